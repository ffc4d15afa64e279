// The rules of which part may include which (CONTRIBUTING.md, "Layout"): the data flow goes one way, and every part can
// be read without the next. Within renderer/ and cli/ the ordered lists of their folders, in their CMakeLists.txt, are
// the rule.
#include "tests/support/source_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace isl {
namespace {

namespace fs = std::filesystem;

/// Files whose path starts with `part` may include files whose path starts with one of `allowed`. The first row that
/// matches counts.
struct Rule {
  std::string part;
  std::vector<std::string> allowed;
};

const std::vector<Rule>& rules() {
  static const std::vector<Rule> kRules{
      {"base/", {"base/"}},
      {"grammar/", {"base/", "grammar/"}},
      {"renderer/", {"base/", "renderer/"}},
      {"interpreter/",
       {"base/", "grammar/", "interpreter/", "renderer/effects/statements.h", "renderer/patterns/", "renderer/scene/",
        "renderer/values/"}},
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

/// The folders of a part, each of which may include itself and those before it. Files of the part itself, which is the
/// last of its own folders, may include all of them.
class OrderedFolders {
 public:
  /// Reads `set(variable …)` from the part's CMakeLists.txt.
  OrderedFolders(const std::string& part, const std::string& variable) : part_(part) {
    std::ifstream file(fs::path(ISL_SOURCE_DIR) / part / "CMakeLists.txt");
    const std::string text(std::istreambuf_iterator<char>(file), {});
    const std::string head = "set(" + variable;
    if (const std::size_t begin = text.find(head); begin != std::string::npos) {
      std::istringstream words(text.substr(begin + head.size(), text.find(')', begin) - begin - head.size()));
      for (std::string folder; words >> folder;) folders_.push_back((fs::path(part) / folder).generic_string());
    }
    folders_.push_back(part);
  }

  [[nodiscard]] bool has(const std::string& file) const { return file.starts_with(part_ + "/"); }
  [[nodiscard]] bool is_listed(const std::string& file) const { return place_of(file) < folders_.size(); }
  [[nodiscard]] bool may_include(const std::string& file, const std::string& other) const {
    return place_of(other) <= place_of(file);
  }
  [[nodiscard]] const std::vector<std::string>& folders() const { return folders_; }

 private:
  [[nodiscard]] std::size_t place_of(const std::string& file) const {
    const std::string folder = fs::path(file).parent_path();
    return static_cast<std::size_t>(std::find(folders_.begin(), folders_.end(), folder) - folders_.begin());
  }

  std::string part_;
  std::vector<std::string> folders_;
};

const std::vector<OrderedFolders>& ordered_parts() {
  static const std::vector<OrderedFolders> kParts{OrderedFolders("renderer", "ISL_RENDERER_FOLDERS"),
                                                  OrderedFolders("cli", "ISL_CLI_FOLDERS")};
  return kParts;
}

/// True if both files are in a part with an order of folders, and this order lets the one include the other.
bool is_in_order(const std::string& file, const std::string& other) {
  for (const OrderedFolders& part : ordered_parts()) {
    if (part.has(file) && part.has(other)) return part.is_listed(file) && part.may_include(file, other);
  }
  return true;
}

/// The file that an #include line names, with its opening bracket or quote: `"cli/options/options.h`; "" for any other
/// line.
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

/// The judge knows the records of a scene alone, and of the product only what measures errors knows the judge: else the
/// product would be compared with itself.
bool shares_with_the_judge(const std::string& file, const std::string& other) {
  constexpr const char* kJudge = "renderer/reference/";
  if (file.starts_with(kJudge))
    return !starts_with_any(other, {kJudge, "renderer/scene/", "base/"}) && other.starts_with("renderer/");
  return other.starts_with(kJudge) && !file.starts_with("renderer/accuracy/");
}

/// "file:line: may not include x", or "" if the line is allowed.
std::string complaint(const std::string& file, std::size_t line_number, const std::string& line) {
  const std::string name = included(line);
  if (name.empty()) return "";
  const std::string bare = name.substr(1);
  const std::string message = file + ":" + std::to_string(line_number) + ": may not include " + bare;
  if (shares_with_the_judge(file, bare)) return message;
  // Only the image modules may use libraries of picture formats.
  if (starts_with_any(bare, {"OpenImageIO/", "OpenEXR/", "png.h"})) {
    return file.starts_with("renderer/image/") && file.ends_with("_plugin.cpp") ? "" : message;
  }
  if (name.front() != '"') return "";
  for (const Rule& rule : rules()) {
    if (!file.starts_with(rule.part)) continue;
    return starts_with_any(bare, rule.allowed) && is_in_order(file, bare) ? "" : message;
  }
  return "";
}

/// The sources of the product, by their paths relative to the top folder.
std::vector<std::string> sources_of_tree() {
  const fs::path root = ISL_SOURCE_DIR;
  std::vector<std::string> files;
  for (const char* part : {"base", "grammar", "interpreter", "renderer", "cli"}) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / part)) {
      const std::string extension = entry.path().extension();
      if (!entry.is_regular_file() || !starts_with_any(extension, {".h", ".cpp", ".ll", ".yy", ".def"})) continue;
      files.push_back(fs::relative(entry.path(), root));
    }
  }
  return files;
}

TEST(IncludeRules, HoldInTheWholeTree) {
  const std::vector<std::string> files = sources_of_tree();
  EXPECT_GT(files.size(), 50u) << "the scan missed the sources";
  std::vector<std::string> found;
  for (const std::string& file : files) {
    std::ifstream text(fs::path(ISL_SOURCE_DIR) / file);
    std::size_t number = 0;
    for (std::string line; std::getline(text, line);) {
      std::string problem = complaint(file, ++number, line);
      if (!problem.empty()) found.push_back(std::move(problem));
    }
  }
  EXPECT_EQ(found, std::vector<std::string>{});
}

TEST(IncludeRules, EveryFolderIsListedAndEveryListedFolderHasSources) {
  const std::vector<std::string> files = sources_of_tree();
  for (const OrderedFolders& part : ordered_parts()) {
    EXPECT_GT(part.folders().size(), 3u) << part.folders().back() << "/CMakeLists.txt has no list of folders";
    for (const std::string& file : files) EXPECT_TRUE(!part.has(file) || part.is_listed(file)) << file;
    for (const std::string& folder : part.folders()) {
      const auto is_in = [&folder](const std::string& file) { return fs::path(file).parent_path() == folder; };
      EXPECT_TRUE(std::any_of(files.begin(), files.end(), is_in)) << folder;
    }
  }
}

TEST(IncludeRules, ForbidLookingForwardAndSideways) {
  const auto is_forbidden = [](const std::string& file, const std::string& line) {
    return !complaint(file, 1, line).empty();
  };
  EXPECT_TRUE(is_forbidden("grammar/parser.yy", "#include \"interpreter/value.h\""));
  EXPECT_TRUE(is_forbidden("grammar/ast.h", "#include \"renderer/scene/database.h\""));
  EXPECT_TRUE(is_forbidden("renderer/render.cpp", "  # include \"grammar/ast.h\""));
  EXPECT_TRUE(is_forbidden("renderer/scene/database.h", "#include \"renderer/trace/tracer.h\""));
  EXPECT_TRUE(
      is_forbidden("renderer/compiled/compiled_scene.h", "#include \"renderer/solvers/published/paper_memory.h\""));
  EXPECT_TRUE(is_forbidden("renderer/fields/component_table.h", "#include \"renderer/fields/ray/lane_memory.h\""));
  EXPECT_TRUE(is_forbidden("renderer/integrator/integrator.h", "#include \"renderer/render.h\""));
  EXPECT_TRUE(is_forbidden("renderer/unlisted/file.h", "#include \"renderer/scene/ids.h\""));
  EXPECT_TRUE(is_forbidden("interpreter/evaluate.cpp", "#include \"renderer/trace/tracer.h\""));
  EXPECT_TRUE(is_forbidden("renderer/shading/light.cpp", "#include <OpenImageIO/imageio.h>"));
  EXPECT_TRUE(is_forbidden("renderer/image/image_file.cpp", "#include <png.h>"));
  EXPECT_TRUE(is_forbidden("renderer/solvers/cells/stretch_search.cpp", "#include \"renderer/reference/interval.h\""));
  EXPECT_TRUE(is_forbidden("cli/commands/accuracy.cpp", "#include \"renderer/reference/interval.h\""));
  EXPECT_TRUE(is_forbidden("renderer/reference/interval.h", "#include \"renderer/extended/interval.h\""));
  EXPECT_TRUE(is_forbidden("renderer/reference/interval.h", "#include \"renderer/numerics/sums.h\""));
  EXPECT_FALSE(is_forbidden("renderer/reference/interval.h", "#include \"renderer/scene/database.h\""));
  EXPECT_FALSE(is_forbidden("renderer/accuracy/reference_hits.h", "#include \"renderer/reference/box_tree.h\""));
  EXPECT_FALSE(is_forbidden("renderer/image/exr_plugin.cpp", "#include <OpenEXR/ImfHeader.h>"));
  EXPECT_FALSE(is_forbidden("renderer/image/image_plugin.cpp", "#include <OpenImageIO/imageio.h>"));
  EXPECT_FALSE(is_forbidden("renderer/trace/tracer.cpp", "#include \"renderer/scene/database.h\""));
  EXPECT_FALSE(is_forbidden("renderer/fields/ray/lane_memory.h", "#include \"renderer/fields/component_table.h\""));
  EXPECT_FALSE(is_forbidden("cli/main.cpp", "#include \"grammar/loader.h\""));
  EXPECT_FALSE(is_forbidden("interpreter/evaluate.cpp", "#include <vector>"));
}

}  // namespace
}  // namespace isl
