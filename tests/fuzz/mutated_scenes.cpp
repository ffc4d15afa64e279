#include "tests/fuzz/mutated_scenes.h"

#include "base/check.h"
#include "tests/support/source_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

namespace isl::test {
namespace {

namespace fs = std::filesystem;

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
  ISL_CHECK(files.size() > 5, "{} scenes", files.size());
  return files;
}

std::string read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<TokenList> tokens_of_all(const std::vector<fs::path>& files) {
  std::vector<TokenList> scenes;
  for (const fs::path& file : files) scenes.push_back(tokens_of(read(file)));
  return scenes;
}

}  // namespace

std::string setting(const char* name, const char* otherwise) {
  const char* const value = std::getenv(name);
  return value ? value : otherwise;
}

MutatedScenes::MutatedScenes()
    : files_(scene_files()),
      mutator_(tokens_of_all(files_), std::stoul(setting("ISL_MUTATION_SEED", "1"))),
      search_path_{ISL_SOURCE_DIR "/stdlib"},
      kept_(setting("ISL_MUTATIONS_KEPT", "")) {
  if (const std::string more = setting("ISL_MUTATION_INCLUDES", ""); !more.empty()) search_path_.emplace_back(more);
}

std::string MutatedScenes::next() {
  std::string text = mutator_.next();
  if (!kept_.empty()) std::ofstream(fs::path(kept_) / fmt::format("{:05}.pov", count_), std::ios::binary) << text;
  ++count_;
  return text;
}

}  // namespace isl::test
