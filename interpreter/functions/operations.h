// The machine's operations for the words and operators of a `function {}`.
#pragma once

#include "grammar/ast.h"
#include "grammar/symbols.h"
#include "renderer/scene/function.h"

#include <optional>

namespace isl::interpreter {

[[nodiscard]] scene::Opcode operation_of(grammar::BinaryOp op);

/// `sin`, `pow`, `min` …: functions that are one operation.
struct BuiltinOperation {
  grammar::Symbol name;
  scene::Opcode operation;
  std::size_t argument_count;
  bool is_variadic = false;  ///< argument_count or more, applied from the left
};

/// Null for a word without a meaning in a function; `select`, `sum` and `prod` are more than one operation.
[[nodiscard]] const BuiltinOperation* builtin_operation(grammar::Symbol name);

/// `.x`, `.red`, `.gray` … after a call of a function that yields several terms: one of the terms (Opcode::copy), or a
/// number computed from the colour.
struct ResultItem {
  scene::Opcode operation = scene::Opcode::copy;
  std::uint16_t term = 0;  ///< the highest term that is needed
};

[[nodiscard]] std::optional<ResultItem> result_item(grammar::Symbol name);

}  // namespace isl::interpreter
