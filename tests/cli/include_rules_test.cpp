// Who may include whom (CONTRIBUTING.md, "Layout"): the data flow goes one way, and every part can be read without the
// next.
#include "tests/support/source_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace isl {
namespace {

namespace fs = std::filesystem;

/// Files whose path starts with `part` may include files whose path starts with one of `allowed`. The first row that
/// fits counts.
struct Rule {
  std::string part;
  std::vector<std::string> allowed;
};

const std::vector<Rule>& rules() {
  static const std::vector<Rule> kRules{
      {"base/", {"base/"}},
      {"grammar/", {"base/", "grammar/"}},
      {"renderer/scene/", {"base/", "renderer/scene/"}},
      {"renderer/values/", {"base/", "renderer/scene/", "renderer/values/"}},
      {"renderer/patterns/", {"base/", "renderer/patterns/", "renderer/scene/", "renderer/values/"}},
      {"renderer/", {"base/", "renderer/"}},
      {"interpreter/", {"base/", "grammar/", "interpreter/", "renderer/patterns/", "renderer/scene/", "renderer/values/"}},
      {"cli/", {"base/", "cli/", "grammar/", "interpreter/", "renderer/"}},
  };
  return kRules;
}

bool starts_with_any(const std::string& path, const std::vector<std::string>& prefixes) {
  for (const std::string& prefix : prefixes) {
    if (path.starts_with(prefix)) return true;
  }
  return false;
}

/// What an #include line names, with its opening bracket or quote: `"cli/options.h`; "" for any other line.
std::string included(std::string_view line) {
  const auto skip_blanks = [&line] { line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size())); };
  skip_blanks();
  for (const std::string_view part : {std::string_view("#"), std::string_view("include")}) {
    if (!line.starts_with(part)) return "";
    line.remove_prefix(part.size());
    skip_blanks();
  }
  return std::string(line.substr(0, line.find_first_of("\">", 1)));
}

/// "file:line: may not include x", or "" when the line is in order.
std::string complaint(const std::string& file, std::size_t line_number, const std::string& line) {
  const std::string name = included(line);
  if (name.empty()) return "";
  const std::string bare = name.substr(1);
  const std::string message = file + ":" + std::to_string(line_number) + ": may not include " + bare;
  // Libraries of picture formats, which modules alone may use.
  if (starts_with_any(bare, {"OpenImageIO/", "OpenEXR/", "png.h"})) {
    return file.starts_with("renderer/image/") && file.ends_with("_plugin.cpp") ? "" : message;
  }
  if (name.front() != '"') return "";
  for (const Rule& rule : rules()) {
    if (file.starts_with(rule.part)) return starts_with_any(bare, rule.allowed) ? "" : message;
  }
  return "";
}

std::vector<std::string> complaints_of_tree(const fs::path& root, std::size_t& files) {
  std::vector<std::string> found;
  for (const char* part : {"base", "grammar", "interpreter", "renderer", "cli"}) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / part)) {
      const std::string extension = entry.path().extension();
      if (!entry.is_regular_file() || !starts_with_any(extension, {".h", ".cpp", ".ll", ".yy", ".def"})) continue;
      ++files;
      std::ifstream text(entry.path());
      std::size_t number = 0;
      for (std::string line; std::getline(text, line);) {
        std::string problem = complaint(fs::relative(entry.path(), root), ++number, line);
        if (!problem.empty()) found.push_back(std::move(problem));
      }
    }
  }
  return found;
}

TEST(IncludeRules, HoldInTheWholeTree) {
  std::size_t files = 0;
  const std::vector<std::string> found = complaints_of_tree(ISL_SOURCE_DIR, files);
  EXPECT_GT(files, 50u) << "the scan missed the sources";
  EXPECT_EQ(found, std::vector<std::string>{});
}

TEST(IncludeRules, ForbidLookingForwardAndSideways) {
  const auto is_forbidden = [](const std::string& file, const std::string& line) {
    return !complaint(file, 1, line).empty();
  };
  EXPECT_TRUE(is_forbidden("grammar/parser.yy", "#include \"interpreter/value.h\""));
  EXPECT_TRUE(is_forbidden("grammar/ast.h", "#include \"renderer/scene/database.h\""));
  EXPECT_TRUE(is_forbidden("renderer/render.cpp", "  # include \"grammar/ast.h\""));
  EXPECT_TRUE(is_forbidden("renderer/scene/database.h", "#include \"renderer/tracer.h\""));
  EXPECT_TRUE(is_forbidden("interpreter/evaluate.cpp", "#include \"renderer/tracer.h\""));
  EXPECT_TRUE(is_forbidden("renderer/shading/light.cpp", "#include <OpenImageIO/imageio.h>"));
  EXPECT_TRUE(is_forbidden("renderer/image/image_file.cpp", "#include <png.h>"));
  EXPECT_FALSE(is_forbidden("renderer/image/exr_plugin.cpp", "#include <OpenEXR/ImfHeader.h>"));
  EXPECT_FALSE(is_forbidden("renderer/image/image_plugin.cpp", "#include <OpenImageIO/imageio.h>"));
  EXPECT_FALSE(is_forbidden("cli/session.cpp", "#include \"grammar/loader.h\""));
  EXPECT_FALSE(is_forbidden("interpreter/evaluate.cpp", "#include <vector>"));
}

}  // namespace
}  // namespace isl
