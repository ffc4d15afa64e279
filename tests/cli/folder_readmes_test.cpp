// A folder with many files has a README.md of a few lines that says what lives there, and what may not.
#include "tests/support/source_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace isl {
namespace {

namespace fs = std::filesystem;

constexpr std::ptrdiff_t kMostFiles = 8;
constexpr std::ptrdiff_t kMostLines = 10;

std::ptrdiff_t files_in(const fs::path& folder) {
  const auto is_file = [](const fs::directory_entry& entry) {
    return entry.is_regular_file() && entry.path().filename() != "README.md";
  };
  return std::count_if(fs::directory_iterator(folder), fs::directory_iterator(), is_file);
}

/// Rows of tables do not count: a page of pictures has one for each.
std::ptrdiff_t lines_in(const fs::path& file) {
  std::ifstream text(file);
  std::ptrdiff_t count = 0;
  for (std::string line; std::getline(text, line);) count += line.starts_with('|') ? 0 : 1;
  return count;
}

TEST(FolderReadmes, StandInEveryFolderWithManyFilesAndAreShort) {
  const fs::path root = ISL_SOURCE_DIR;
  std::size_t large_folders = 0;
  std::vector<std::string> without, too_long;
  for (const char* part : {"base", "grammar", "interpreter", "renderer", "cli", "scenes", "tests"}) {
    std::vector<fs::path> folders{root / part};
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / part)) {
      if (entry.is_directory()) folders.push_back(entry.path());
    }
    for (const fs::path& folder : folders) {
      if (files_in(folder) <= kMostFiles) continue;
      ++large_folders;
      const fs::path readme = folder / "README.md";
      if (!fs::exists(readme)) without.push_back(fs::relative(folder, root));
      if (fs::exists(readme) && lines_in(readme) > kMostLines) too_long.push_back(fs::relative(readme, root));
    }
  }
  EXPECT_GT(large_folders, 10u) << "the scan missed the sources";
  EXPECT_EQ(without, std::vector<std::string>{});
  EXPECT_EQ(too_long, std::vector<std::string>{});
}

}  // namespace
}  // namespace isl
