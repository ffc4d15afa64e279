// The built-in functions: `sin(a)`, `vrotate(v, r)`, `concat(…)`. Each is one row of a table; the arguments arrive
// evaluated and counted, except for the few functions that ask about names.
#pragma once

#include "interpreter/context.h"

#include <span>

namespace isl::interpreter {

/// evaluate_into() for calls. Fails if the function is not supported, or if it does not take the arguments.
void call_builtin(Context& context, const grammar::FunctionCall& call, Value& result);

// ---- For the files that define the functions ------------------------------------------------------------------------

/// The evaluated arguments of one call, with checked access.
class Arguments {
 public:
  Arguments(Context& context, const grammar::FunctionCall& call, std::span<const Value> values)
      : context_(context), call_(call), values_(values) {}

  [[nodiscard]] Context& context() const { return context_; }
  [[nodiscard]] SourceSpan span() const { return call_.span; }
  [[nodiscard]] std::size_t size() const { return values_.size(); }
  /// The place of argument i, as exactly as it is known.
  [[nodiscard]] SourceSpan span(std::size_t i) const;
  /// The expression of argument i; null if directives or several items yield the argument.
  [[nodiscard]] const grammar::Node* expression(std::size_t i) const;
  [[nodiscard]] const Value& operator[](std::size_t i) const { return values_[i]; }

  [[nodiscard]] double number(std::size_t i) const;
  /// At least 3 terms, promoted.
  [[nodiscard]] scene::Vec3 vector(std::size_t i) const;
  [[nodiscard]] const std::string& string(std::size_t i) const;
  /// A number in [low, high], truncated.
  [[nodiscard]] int integer(std::size_t i, int low, int high) const;
  /// The variable that argument i names, as an output.
  [[nodiscard]] Slot& variable(std::size_t i) const;
  [[noreturn]] void fail(std::size_t i, std::string message) const;

 private:
  Context& context_;
  const grammar::FunctionCall& call_;
  std::span<const Value> values_;
};

struct Builtin {
  static constexpr std::size_t kAnyNumber = 0xFFFF;

  grammar::Symbol name;
  std::size_t min_arguments;
  std::size_t max_arguments;
  double (*of_number)(double) = nullptr;  ///< for functions of one number that cannot fail
  Value (*general)(const Arguments&) = nullptr;
};

[[nodiscard]] inline Value to_value(const scene::Vec3& v) { return {3, {v.x, v.y, v.z}}; }

[[nodiscard]] std::span<const Builtin> float_functions();
[[nodiscard]] std::span<const Builtin> vector_functions();
[[nodiscard]] std::span<const Builtin> object_functions();
[[nodiscard]] std::span<const Builtin> string_functions();
[[nodiscard]] std::span<const Builtin> time_functions();

/// The value of `now`.
[[nodiscard]] double days_since_2000();

}  // namespace isl::interpreter
