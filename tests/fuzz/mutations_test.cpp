// Scenes with tokens exchanged, through `check` and a tiny render. Of the scenes in this source tree a few hundred, on
// every run the same. For more, ISL_MUTATIONS says how many, ISL_MUTATION_SEED from where on, ISL_MUTATION_SCENES
// names folders of other scenes, separated by `:`, ISL_MUTATION_INCLUDES where their includes are, and
// ISL_MUTATIONS_KEPT a folder to write the scenes to.
#include "tests/fuzz/hostile_scene.h"
#include "tests/fuzz/mutator.h"
#include "tests/support/source_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace isl::test {
namespace {

namespace fs = std::filesystem;

std::string setting(const char* name, const char* otherwise) {
  const char* const value = std::getenv(name);
  return value ? value : otherwise;
}

bool is_scene(const fs::path& file) { return file.extension() == ".isl" || file.extension() == ".pov"; }

std::vector<fs::path> scenes_below(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && is_scene(entry.path())) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

std::vector<fs::path> scene_files() {
  std::vector<fs::path> files;
  const std::string given = setting("ISL_MUTATION_SCENES", "");
  std::stringstream folders(given.empty() ? std::string(ISL_SOURCE_DIR "/scenes:" ISL_SOURCE_DIR "/tests/golden/eval")
                                          : given);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::vector<fs::path> below = scenes_below(folder);
    files.insert(files.end(), below.begin(), below.end());
  }
  return files;
}

std::string read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Mutations, AreReadOrRefusedWithAPlaceAndDrawnInTime) {
  const std::vector<fs::path> files = scene_files();
  ASSERT_GT(files.size(), 5u);
  std::vector<TokenList> scenes;
  for (const fs::path& file : files) scenes.push_back(tokens_of(read(file)));
  const unsigned long count = std::stoul(setting("ISL_MUTATIONS", "500"));
  Mutator mutator(std::move(scenes), std::stoul(setting("ISL_MUTATION_SEED", "1")));
  std::vector<fs::path> search_path{ISL_SOURCE_DIR "/stdlib"};
  if (const std::string more = setting("ISL_MUTATION_INCLUDES", ""); !more.empty()) search_path.emplace_back(more);
  const std::string kept = setting("ISL_MUTATIONS_KEPT", "");
  unsigned long accepted = 0, rendered = 0, slow = 0;
  for (unsigned long i = 0; i < count; ++i) {
    const std::string text = mutator.next();
    const fs::path& file = files[mutator.origin()];
    if (!kept.empty()) std::ofstream(fs::path(kept) / fmt::format("{:05}.pov", i), std::ios::binary) << text;
    const SceneVerdict verdict = try_scene(text, file.parent_path(), search_path, i % 2 == 1);
    accepted += verdict.is_accepted;
    rendered += verdict.is_rendered;
    slow += verdict.is_slow;
    EXPECT_TRUE(verdict.trouble.empty()) << verdict.trouble << "made from " << file << ":\n" << text;
    EXPECT_FALSE(verdict.is_slow) << "more than " << kSecondsAllowed << " s, made from " << file << ":\n" << text;
  }
  fmt::print("{} scenes: {} accepted, {} rendered, {} slow\n", count, accepted, rendered, slow);
  // Too many slips, and nothing would be tested but the parser.
  EXPECT_GT(accepted, count / 10);
  EXPECT_GT(rendered, count / 20);
}

}  // namespace
}  // namespace isl::test
