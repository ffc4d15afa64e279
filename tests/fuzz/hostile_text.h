// Evaluates a text that may hold anything, within limits that keep it short, and tells what must never happen: an error
// without a place. A crash ends the test program; the text that caused it is printed then.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace isl::test {

struct Verdict {
  bool has_errors = false;
  /// Empty, or what is wrong with how the text was refused.
  std::string trouble;
};

[[nodiscard]] Verdict evaluate_hostile(std::string_view text);

/// Keeps the text for a report, should the program be ended by a signal, a failed check or a sanitizer.
void remember_for_crash(std::string_view text);

/// Statements that are evaluated together after one prelude: reading the prelude takes most of the time. Each statement
/// may be wrong by itself, so there are fewer of them than a scene may have errors.
class StatementBatch {
 public:
  explicit StatementBatch(std::string prelude) : prelude_(std::move(prelude)) {}
  StatementBatch(const StatementBatch&) = delete;
  StatementBatch& operator=(const StatementBatch&) = delete;

  void add(std::string_view statement);
  /// Evaluates what was added since the last time.
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
