// Answers about records that are worked out once.
#pragma once

#include <optional>

namespace isl::scene {

/// Empty until the question is asked.
using Answer = std::optional<bool>;

/// The answer; the first time it is what `ask` returns.
template <class Ask>
bool remembered(Answer& answer, const Ask& ask) {
  if (!answer) answer = ask();
  return *answer;
}

}  // namespace isl::scene
