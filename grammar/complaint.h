// One complaint about a text, as its tree holds it. It has its own header because the generated parser's header needs
// it.
#pragma once

#include "base/diagnostic.h"

namespace isl::grammar {

struct Complaint {
  Diagnostic diagnostic;
  /// The next complaint about the same statement or, in a branch or a macro's body, about the rest of that body:
  /// execution would not reach it once this one is met.
  const Complaint* next = nullptr;

  [[nodiscard]] bool is_error() const { return diagnostic.severity == Severity::error; }
};

}  // namespace isl::grammar
