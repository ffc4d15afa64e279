// Scenes with tokens exchanged. They are made from the scenes in this source tree, or from those in the folders that
// ISL_MUTATION_SCENES names, separated by `:`, whose includes are in ISL_MUTATION_INCLUDES. ISL_MUTATION_SEED is the
// first seed; ISL_MUTATIONS_KEPT names a folder to which each scene is written.
#pragma once

#include "tests/fuzz/mutator.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace isl::test {

/// The value of an environment variable, or `otherwise` if it is not set.
[[nodiscard]] std::string setting(const char* name, const char* otherwise);

class MutatedScenes {
 public:
  MutatedScenes();

  /// The text of the next scene.
  [[nodiscard]] std::string next();
  /// The scene from which the last one was made.
  [[nodiscard]] const std::filesystem::path& origin() const { return files_[mutator_.origin()]; }
  /// The folders of its includes, besides the folder of its origin.
  [[nodiscard]] const std::vector<std::filesystem::path>& search_path() const { return search_path_; }

 private:
  std::vector<std::filesystem::path> files_;
  Mutator mutator_;
  std::vector<std::filesystem::path> search_path_;
  std::string kept_;
  std::size_t count_ = 0;
};

}  // namespace isl::test
