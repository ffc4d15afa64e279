// Every scene that README.md and docs/ show in a code block marked `isl` can be read, as can every scene in scenes/.
#include "tests/cli/program_fixture.h"

#include <fstream>

namespace isl::test {
namespace {

namespace fs = std::filesystem;

struct CodeBlock {
  std::string place;  ///< file:line
  std::string text;
};

std::vector<CodeBlock> code_blocks_of(const fs::path& file) {
  std::vector<CodeBlock> blocks;
  std::ifstream text(file);
  bool inside = false;
  std::size_t number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    if (!inside && line == "```isl") {
      blocks.push_back({file.filename().string() + ":" + std::to_string(number + 1), ""});
      inside = true;
    } else if (line.starts_with("```")) {
      inside = false;
    } else if (inside) {
      blocks.back().text += line + "\n";
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

TEST_F(Docs, CodeBlocksCanBeRead) {
  std::vector<fs::path> pages = files_below(fs::path(ISL_SOURCE_DIR) / "docs", ".md");
  pages.push_back(fs::path(ISL_SOURCE_DIR) / "README.md");
  std::size_t count = 0;
  for (const fs::path& page : pages) {
    for (const CodeBlock& block : code_blocks_of(page)) {
      ++count;
      const ProcessResult result = run({"check", write("block.isl", block.text)});
      EXPECT_EQ(result.exit_code, 0) << block.place << "\n" << result.err;
    }
  }
  EXPECT_GT(count, 0u) << "README.md shows a first scene";
}

TEST_F(Docs, ScenesCanBeRead) {
  const std::vector<fs::path> scenes = files_below(fs::path(ISL_SOURCE_DIR) / "scenes", ".isl");
  EXPECT_FALSE(scenes.empty());
  for (const fs::path& scene : scenes) {
    const ProcessResult result = run({"check", scene.string()});
    EXPECT_EQ(result.exit_code, 0) << scene << "\n" << result.err;
  }
}

}  // namespace
}  // namespace isl::test
