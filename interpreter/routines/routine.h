// A loop or a macro's body as a flat list of operations. Numbers are computed in registers; names are looked up at each
// use, because what a name is bound to changes while a scene is read. Knows nothing of the tree's shape.
#pragma once

#include "grammar/ast.h"
#include "interpreter/builtins/number_functions.h"
#include "interpreter/context.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isl::interpreter {

struct Machine;
struct Operation;
/// Does one operation and returns the next one; null at the end.
using Perform = const Operation* (*)(Machine&, const Operation*);

struct Operation {
  Perform perform;
  union {
    const grammar::Node* node;       ///< for operations that the evaluator does
    const NumberFunction* function;  ///< for calls
  };
  std::uint32_t a, b;  ///< operands: a register, a constant or a symbol, as `perform` takes them
  std::uint32_t to;    ///< register of the result
  /// Place of another operation, relative to this one: where a jump leads, or the evaluator's way of doing the
  /// statement where an operand is no number.
  std::int32_t other;
};

struct Routine {
  std::vector<Operation> operations;
  std::vector<double> constants;
  bool yields = false;  ///< a macro's body that ends with a value, on some way at least

  [[nodiscard]] std::size_t bytes() const {
    return operations.capacity() * sizeof(Operation) + constants.capacity() * sizeof(double);
  }
};

/// The state of a routine that is running.
struct Machine {
  /// The builder leaves expressions that need more to the evaluator.
  static constexpr std::uint32_t kRegisters = 32;

  // The registers are left as they are until they are written.
  Machine(Context& context_, const Routine& routine, Value& result_)
      : context(context_), scopes(context_.scopes), constants(routine.constants.data()), result(&result_) {}

  Context& context;
  Scopes& scopes;
  const double* constants;
  Value* result;  ///< of a macro that yields a value
  bool has_result = false;
  std::array<double, kRegisters> registers;
};

}  // namespace isl::interpreter
