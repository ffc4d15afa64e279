// Runs the program on a hostile scene within bounds of time and memory that the system enforces.
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
  /// Address space of the program. Its own memory limit is set to a tenth of it, because texts, their trees and values
  /// are counted separately.
  static constexpr std::size_t kAddressSpaceBytes = std::size_t{3} << 30;

  /// Runs `isl check` on the text as scene.isl. Fails the test if it took too long, crashed or printed pages of
  /// messages.
  [[nodiscard]] ProcessResult check(std::string_view text, std::vector<std::string> options = {});
  /// Does the same with an existing file.
  [[nodiscard]] ProcessResult check_file(const std::string& name, std::vector<std::string> options = {});

  /// The message for a scene that must be refused, with exit code 1.
  [[nodiscard]] std::string refusal(std::string_view text, std::vector<std::string> options = {});
};

[[nodiscard]] std::string repeated(std::string_view text, std::size_t count);

}  // namespace isl::test
