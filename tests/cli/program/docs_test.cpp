// Every scene that README.md and docs/ show in a code block marked `isl` can be read, as can every scene in scenes/ and
// bench/. If a block marked `text` follows directly, the scene prints exactly its content.
#include "tests/cli/program/program_fixture.h"
#include "tests/support/source_folder.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>
#include <optional>

namespace isl::test {
namespace {

namespace fs = std::filesystem;

struct CodeBlock {
  std::string place;  ///< file:line
  std::string text;
  std::optional<std::string> output{};  ///< set if the page shows what the scene prints
};

std::vector<CodeBlock> code_blocks_of(const fs::path& file) {
  std::vector<CodeBlock> blocks;
  std::ifstream text(file);
  bool inside = false;             // inside a block of any kind
  std::string* content = nullptr;  // the text that the lines of a scene or an output are appended to
  bool follows_scene = false;      // only empty lines lie between the last scene and here
  std::size_t number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    const bool is_fence = line.starts_with("```");
    if (inside && !is_fence) {
      if (content) *content += line + "\n";
    } else if (inside) {
      follows_scene = content && content == &blocks.back().text;
      content = nullptr;
      inside = false;
    } else if (is_fence) {
      inside = true;
      if (line == "```isl") {
        blocks.push_back({file.filename().string() + ":" + std::to_string(number + 1), ""});
        content = &blocks.back().text;
      } else if (line == "```text" && follows_scene) {
        content = &blocks.back().output.emplace();
      }
    } else if (!line.empty()) {
      follows_scene = false;
    }
  }
  return blocks;
}

std::vector<fs::path> files_below(const fs::path& folder, std::string_view extension) {
  std::vector<fs::path> found;
  if (!fs::exists(folder)) return found;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == extension) found.push_back(entry.path());
  }
  return found;
}

class Docs : public ProgramTest {};

TEST_F(Docs, CodeBlocksCanBeReadAndPrintWhatIsShown) {
  std::vector<fs::path> pages = files_below(fs::path(ISL_SOURCE_DIR) / "docs", ".md");
  pages.push_back(fs::path(ISL_SOURCE_DIR) / "README.md");
  std::size_t count = 0, output_count = 0;
  write("paper.png", "what docs/language.md takes a picture from; no picture is looked into here");
  for (const fs::path& page : pages) {
    for (const CodeBlock& block : code_blocks_of(page)) {
      ++count;
      // With JSON the problems do not go to standard error, so that only #debug writes there.
      std::vector<std::string> arguments{"check", "--format", "json", write("block.isl", block.text)};
      // The reference shows all of the language, also parts that are not rendered yet. The README shows only what is
      // rendered.
      if (page.filename() != "README.md") arguments.emplace_back("--lenient");
      const ProcessResult result = run(arguments);
      EXPECT_EQ(result.exit_code, 0) << block.place << "\n" << result.out;
      EXPECT_THAT(result.out, testing::Not(testing::HasSubstr("not supported"))) << block.place;
      if (!block.output) continue;
      ++output_count;
      EXPECT_EQ(result.err, *block.output) << block.place;
    }
  }
  EXPECT_GT(count, 0u) << "README.md shows a first scene";
  EXPECT_GT(output_count, 0u) << "docs/language.md shows what scenes print";
}

TEST_F(Docs, ScenesCanBeRead) {
  const std::vector<fs::path> scenes = files_below(fs::path(ISL_SOURCE_DIR) / "scenes", ".isl");
  EXPECT_FALSE(scenes.empty());
  for (const fs::path& scene : scenes) {
    const ProcessResult result = run({"check", scene.string()});
    EXPECT_EQ(result.exit_code, 0) << scene << "\n" << result.err;
  }
}

TEST_F(Docs, ScenesThatArePairedWithPovraysCanBeRead) {
  std::vector<fs::path> scenes = files_below(fs::path(ISL_SOURCE_DIR) / "bench" / "pairs", ".pov");
  EXPECT_GE(scenes.size(), 100u) << "bench/pairs.py compares at least a hundred";
  const std::vector<fs::path> soft = files_below(fs::path(ISL_SOURCE_DIR) / "bench" / "soft", ".pov");
  EXPECT_GE(soft.size(), 20u) << "bench/soft_noise.py compares twenty";
  scenes.insert(scenes.end(), soft.begin(), soft.end());
  for (const fs::path& scene : scenes) {
    // Some are about what is not rendered yet.
    const ProcessResult result = run({"check", "--lenient", scene.string()});
    EXPECT_EQ(result.exit_code, 0) << scene << "\n" << result.err;
  }
}

/// The text of a page below the heading of an effect, to the next heading; empty if there is none.
std::string section_of(const std::string& page, const std::string& effect) {
  const std::string heading = "\n### `" + effect + "`\n";
  const std::size_t begin = page.find(heading);
  if (begin == std::string::npos) return "";
  const std::size_t text = begin + heading.size();
  return page.substr(text, page.find("\n##", text) - text);
}

/// The files that a page links to, as it writes them.
std::vector<std::string> linked_files(const std::string& page) {
  std::vector<std::string> files;
  for (std::size_t at = page.find("]("); at != std::string::npos; at = page.find("](", at + 1)) {
    const std::string target = page.substr(at + 2, page.find(')', at) - at - 2);
    if (const std::string file = target.substr(0, target.find('#')); !file.empty()) files.push_back(file);
  }
  return files;
}

TEST_F(Docs, EveryEffectIsDescribedWithAnExampleAndAScene) {
  const fs::path folder = fs::path(ISL_SOURCE_DIR) / "docs";
  std::ifstream stream(folder / "effects.md");
  const std::string page{std::istreambuf_iterator<char>(stream), {}};
  const ProcessResult result = run({"plan", "--format", "json", write("nothing.isl", "sphere { 3*z, 1 }\n")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const nlohmann::json plan = nlohmann::json::parse(result.out);
  std::size_t count = 0;
  for (const char* const list : {"called_for", "left_out"}) {
    for (const nlohmann::json& effect : plan.at(list)) {
      ++count;
      const std::string name = effect.at("name");
      // Effects that are not rendered yet have a row each at the end of the page.
      if (page.find("\n| `" + name + "` |") != std::string::npos) continue;
      const std::string section = section_of(page, name);
      EXPECT_NE(section, "") << "docs/effects.md has no section `" << name << "`";
      EXPECT_THAT(section, testing::HasSubstr("```isl\n")) << name;
      EXPECT_FALSE(linked_files(section).empty()) << name << ": no scene shows it";
    }
  }
  EXPECT_GT(count, 20u) << "the plan lists every effect";
  for (const std::string& file : linked_files(page)) EXPECT_TRUE(fs::exists(folder / file)) << file;
}

}  // namespace
}  // namespace isl::test
