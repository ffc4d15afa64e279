// One complaint about a text, as its tree holds it. A header of its own because the generated parser's header needs it.
#pragma once

#include "base/diagnostic.h"

namespace isl::grammar {

struct Complaint {
  Diagnostic diagnostic;
  /// The next one about the same statement or, in a branch or a macro's body, about the rest of that: it would not be
  /// reached any more once this one is met.
  const Complaint* next = nullptr;

  [[nodiscard]] bool is_error() const { return diagnostic.severity == Severity::error; }
};

}  // namespace isl::grammar
