// The fixture of tests that run the built program: each test has a folder of its own.
#pragma once

#include "tests/cli/program/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace isl::test {

/// A lit sphere, which renders in a moment.
inline constexpr std::string_view kSmallScene = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 }
light_source { <5, 5, -5> rgb 1 }
sphere { 0, 1 pigment { rgb <1, 0.5, 0> } }
)";

class ProgramTest : public testing::Test {
 public:
  ~ProgramTest() override;

 protected:
  ProgramTest();

  /// Runs `isl arguments…` in the test's folder.
  [[nodiscard]] ProcessResult run(std::vector<std::string> arguments, ProcessOptions options = {}) const;

  /// Writes a file below the folder and returns its name.
  std::string write(const std::string& name, std::string_view text) const;
  [[nodiscard]] std::string read(const std::string& name) const;
  [[nodiscard]] bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  /// Names of all files in the folder, sorted.
  [[nodiscard]] std::vector<std::string> files() const;

 private:
  std::filesystem::path folder_;
};

}  // namespace isl::test
