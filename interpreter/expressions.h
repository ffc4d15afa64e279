// Evaluates expressions by walking the tree. It also follows everything that may replace a number in a scene (a macro
// call, a directive in parentheses).
#pragma once

#include "interpreter/arithmetic.h"
#include "interpreter/context.h"
#include "interpreter/operators.h"

#include <string>
#include <vector>

namespace isl::interpreter {

/// The expression's value. Fails if it has none. `result` must not alias a variable of the scene: it may be written to
/// before the evaluation is over.
void evaluate_into(Context& context, const grammar::Node& node, Value& result);
[[nodiscard]] inline Value evaluate(Context& context, const grammar::Node& node) {
  Value result;
  evaluate_into(context, node, result);
  return result;
}
/// The same for a number; a vector is an error.
[[nodiscard]] double compute_number(Context& context, const grammar::Node& node);
[[nodiscard]] inline double evaluate_number(Context& context, const grammar::Node& node) {
  const double* const number = number_at_hand(context, node);
  return number ? *number : compute_number(context, node);
}
/// A number's truth: not zero within kTolerance.
[[nodiscard]] bool evaluate_condition(Context& context, const grammar::Node& node);
/// The same for a string; other values are errors.
[[nodiscard]] const StringValue& evaluate_string(Context& context, const grammar::Node& node, Value& keep);

/// The only value that a body yields: the body of a macro called inside an expression, or of a directive in
/// parentheses.
void evaluate_call(Context& context, const grammar::Call& call, Value& result);
[[nodiscard]] Value evaluate_items(Context& context, grammar::Items items, SourceSpan span);

/// The numbers of `< … >`, however many, including all that a macro or directive among them yields.
[[nodiscard]] std::vector<double> evaluate_coordinates(Context& context, const grammar::Vector& node);

[[nodiscard]] Value make_string(Context& context, std::string text, SourceSpan span);

}  // namespace isl::interpreter
