// All text of the product goes to standard output and standard error through cli/output/console.h, which makes it safe.
#include "tests/support/source_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace isl {
namespace {

namespace fs = std::filesystem;

/// The files that may print by themselves: the console, the bar, which prints numbers, and the report of a broken
/// invariant.
const std::set<std::string>& printers() {
  static const std::set<std::string> kPrinters{"cli/output/standard_output.cpp", "cli/output/progress.cpp",
                                               "base/check.h"};
  return kPrinters;
}

TEST(ConsoleRules, NothingElsePrints) {
  const std::regex printing(
      R"(\b(fmt::print|f?puts|fputc|putchar|f?printf|fwrite|perror)\s*\(|\bstd::(cout|cerr|clog)\b)"
      R"(|\bwrite\s*\(\s*STD|\bSTD(OUT|ERR)_FILENO,\s*\w+\.(data|c_str))");
  std::vector<std::string> found;
  std::size_t files = 0;
  for (const char* part : {"base", "grammar", "interpreter", "renderer", "cli"}) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(fs::path(ISL_SOURCE_DIR) / part)) {
      const std::string extension = entry.path().extension(), name = fs::relative(entry.path(), ISL_SOURCE_DIR);
      if ((extension != ".h" && extension != ".cpp") || printers().contains(name)) continue;
      ++files;
      std::ifstream text(entry.path());
      std::size_t number = 0;
      for (std::string line; std::getline(text, line);) {
        ++number;
        if (std::regex_search(line, printing)) found.push_back(fmt::format("{}:{}: {}", name, number, line));
      }
    }
  }
  EXPECT_GT(files, 200u) << "the scan missed the sources";
  EXPECT_EQ(found, std::vector<std::string>{});
}

}  // namespace
}  // namespace isl
