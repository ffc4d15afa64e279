// The stages of the program that golden files test. A new stage is a function and a row in stages.cpp; its cases are
// the files in the folder of its name.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace isl::test {

struct StageResult {
  bool is_okay;      ///< no errors; warnings do not count
  std::string text;  ///< the diagnostics as the user sees them, then, if it is okay, the stage's result
};

struct Stage {
  std::string_view name;
  StageResult (*run)(const std::filesystem::path& scene);
};

[[nodiscard]] std::span<const Stage> stages();

/// Parses the scene. The result has all that is wrong with the text, executed or not, then the syntax tree.
[[nodiscard]] StageResult run_parse(const std::filesystem::path& scene);

/// Evaluates the scene. The result has the output of #debug, then the database. A scene whose name contains `_lenient`
/// is read with --lenient.
[[nodiscard]] StageResult run_eval(const std::filesystem::path& scene);

}  // namespace isl::test
