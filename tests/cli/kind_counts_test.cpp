// A kind is declared once (CONTRIBUTING.md, "Adding things"): the files that name it are as few as kind_counts.txt
// says.
#include "tests/support/source_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace isl {
namespace {

namespace fs = std::filesystem;

struct KindRow {
  std::string what, name;
  std::size_t limit = 0;
};

std::vector<KindRow> rows_of(const fs::path& file) {
  std::ifstream text(file);
  std::vector<KindRow> rows;
  for (std::string line; std::getline(text, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream words(line);
    KindRow row;
    words >> row.what >> row.name >> row.limit;
    EXPECT_TRUE(words && row.limit > 0) << line;
    rows.push_back(row);
  }
  return rows;
}

bool is_lower(char c) { return std::islower(static_cast<unsigned char>(c)) != 0; }
bool is_upper(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }
char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

/// The name stands in the text as a word or a part of an identifier: the letters before and after it are none, or a
/// capital begins another part.
bool names(std::string_view text, std::string_view name) {
  const auto same = [](char a, char b) { return lower(a) == lower(b); };
  for (auto at = text.begin();; ++at) {
    at = std::search(at, text.end(), name.begin(), name.end(), same);
    if (at == text.end()) return false;
    const auto end = at + static_cast<std::ptrdiff_t>(name.size());
    const bool begins = at == text.begin() || !std::isalpha(static_cast<unsigned char>(at[-1])) ||
                        (is_lower(at[-1]) && is_upper(*at)) || (at[-1] == 'k' && is_upper(*at));
    const bool ends = end == text.end() || !is_lower(*end) || !is_lower(end[-1]);
    if (begins && ends) return true;
  }
}

std::vector<std::string> files_that_name(const std::string& name) {
  const fs::path root = ISL_SOURCE_DIR;
  std::vector<std::string> files;
  for (const char* part : {"renderer", "interpreter", "cli"}) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / part)) {
      const std::string extension = entry.path().extension();
      const auto is_source = {".h", ".cpp", ".def", ".ll", ".yy"};
      if (!entry.is_regular_file() || std::ranges::find(is_source, extension) == is_source.end()) continue;
      std::ifstream file(entry.path());
      const std::string text(std::istreambuf_iterator<char>(file), {}), path = fs::relative(entry.path(), root);
      if (names(text, name) || names(path, name)) files.push_back(path);
    }
  }
  return files;
}

TEST(KindCounts, EveryKindIsNamedInAsFewFilesAsTheTableSays) {
  const std::vector<KindRow> rows = rows_of(fs::path(ISL_SOURCE_DIR) / "tests/cli/kind_counts.txt");
  EXPECT_FALSE(rows.empty());
  for (const KindRow& row : rows) {
    const std::vector<std::string> files = files_that_name(row.name);
    std::string list;
    for (const std::string& file : files) list += "\n  " + file;
    EXPECT_LE(files.size(), row.limit) << "the " << row.what << " `" << row.name << "` is named in" << list;
    EXPECT_GE(files.size(), 1u) << "the " << row.what << " `" << row.name << "` is named nowhere";
  }
}

TEST(KindCounts, AWordIsFoundAloneAndInIdentifiers) {
  for (const char* text :
       {"pavement", "a Pavement.", "kPavement", "pavement_at", "read_pavement", "PAVEMENT", "\"pavement\""})
    EXPECT_TRUE(names(text, "pavement")) << text;
  for (const char* text : {"pavements", "repavement", "pave ment", ""}) EXPECT_FALSE(names(text, "pavement")) << text;
}

}  // namespace
}  // namespace isl
