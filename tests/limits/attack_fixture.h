// Runs the program on a hostile scene, and measures that it stays within bounds of time and memory.
#pragma once

#include "tests/cli/program/program_fixture.h"

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

namespace isl::test {

class AttackTest : public ProgramTest {
 protected:
  /// No attack may take longer; most end in a fraction of a second. The bound is generous, because test machines are
  /// busy.
  static constexpr std::chrono::seconds kTimeBound{60};
  /// The limit that check() gives the program, and what it may take beyond: its own code, the libraries, and what the
  /// allocator holds back.
  static constexpr std::size_t kMaxMemoryMegabytes = 300, kBeyondMegabytes = 150;

  /// Runs `isl check` on the text as scene.isl, and `isl render` in a copy of the folder. Fails the test if one of them
  /// took too long or too much memory, crashed or printed pages of messages. Returns the result of `isl check`.
  [[nodiscard]] ProcessResult check(std::string_view text, std::vector<std::string> options = {});
  /// Does the same with an existing file.
  [[nodiscard]] ProcessResult check_file(const std::string& name, std::vector<std::string> options = {});

  /// The message for a scene that must be refused, with exit code 1, whether it is checked or rendered.
  [[nodiscard]] std::string refusal(std::string_view text, std::vector<std::string> options = {});

  /// A test whose attacks are many seconds of work on an idle machine may set it higher.
  std::chrono::seconds time_bound_ = kTimeBound;

 private:
  /// Runs `isl command… name options…` within the bounds.
  ProcessResult attack(const std::filesystem::path& where, std::vector<std::string> command, const std::string& name,
                       const std::vector<std::string>& options);

  int rendered_exit_code_ = 0;  ///< of the last rendering
};

[[nodiscard]] std::string repeated(std::string_view text, std::size_t count);

}  // namespace isl::test
