// Scenes with tokens exchanged, of the scenes in this source tree or of those in the folders that ISL_MUTATION_SCENES
// names, separated by `:`, whose includes are in ISL_MUTATION_INCLUDES. ISL_MUTATION_SEED says from where on,
// ISL_MUTATIONS_KEPT names a folder to write each scene to.
#pragma once

#include "tests/fuzz/mutator.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace isl::test {

/// An environment variable, or what holds without it.
[[nodiscard]] std::string setting(const char* name, const char* otherwise);

class MutatedScenes {
 public:
  MutatedScenes();

  /// The text of the next scene.
  [[nodiscard]] std::string next();
  /// What the last one was made from.
  [[nodiscard]] const std::filesystem::path& origin() const { return files_[mutator_.origin()]; }
  /// Where its includes are, besides the folder of its origin.
  [[nodiscard]] const std::vector<std::filesystem::path>& search_path() const { return search_path_; }

 private:
  std::vector<std::filesystem::path> files_;
  Mutator mutator_;
  std::vector<std::filesystem::path> search_path_;
  std::string kept_;
  std::size_t count_ = 0;
};

}  // namespace isl::test
