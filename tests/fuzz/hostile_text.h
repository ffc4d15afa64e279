// Evaluates any text, within limits that keep it short, and reports what must never happen: an error without a place. A
// crash ends the test program; the text that caused it is printed then.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace isl::test {

struct Verdict {
  bool has_errors = false;
  /// Empty, or a description of what is wrong with the messages.
  std::string trouble;
};

[[nodiscard]] Verdict evaluate_hostile(std::string_view text);

/// Keeps the text for a report in case a signal, a failed check or a sanitizer ends the program.
void remember_for_crash(std::string_view text);

/// Statements that are evaluated together after one prelude, because reading the prelude takes most of the time. Each
/// statement may have errors, so there are fewer of them than a scene may have errors.
class StatementBatch {
 public:
  explicit StatementBatch(std::string prelude) : prelude_(std::move(prelude)) {}
  StatementBatch(const StatementBatch&) = delete;
  StatementBatch& operator=(const StatementBatch&) = delete;

  void add(std::string_view statement);
  /// Evaluates the statements added since the last call.
  void flush();

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] const std::vector<std::string>& troubles() const { return troubles_; }

 private:
  std::string prelude_;
  std::string statements_;
  std::size_t waiting_ = 0;
  std::size_t count_ = 0;
  std::vector<std::string> troubles_;
};

}  // namespace isl::test
