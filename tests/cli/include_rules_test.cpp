// Who may include whom (CONTRIBUTING.md, "Layout"): the data flow goes one way, and every part can be read without the
// next.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
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
      {"renderer/", {"base/", "renderer/"}},
      {"interpreter/", {"base/", "grammar/", "interpreter/", "renderer/scene/", "renderer/values/"}},
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

/// "file:line: may not include x", or "" when the line is in order.
std::string complaint(const std::string& file, std::size_t line_number, const std::string& line) {
  static const std::regex kOurs(R"re(^\s*#\s*include\s*"([^"]+)")re");
  static const std::regex kImageLibrary(R"re(^\s*#\s*include\s*[<"]OpenImageIO/)re");
  const std::string place = file + ":" + std::to_string(line_number) + ": may not include ";
  if (std::regex_search(line, kImageLibrary) && !file.starts_with("renderer/image/")) return place + "OpenImageIO";
  std::smatch match;
  if (!std::regex_search(line, match, kOurs)) return "";
  for (const Rule& rule : rules()) {
    if (file.starts_with(rule.part)) return starts_with_any(match[1], rule.allowed) ? "" : place + match[1].str();
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
  EXPECT_FALSE(is_forbidden("renderer/image/encode.cpp", "#include <OpenImageIO/imageio.h>"));
  EXPECT_FALSE(is_forbidden("cli/session.cpp", "#include \"grammar/loader.h\""));
  EXPECT_FALSE(is_forbidden("interpreter/evaluate.cpp", "#include <vector>"));
}

}  // namespace
}  // namespace isl
