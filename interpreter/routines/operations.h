// The operations of a routine. The builder asks for an operation by one of these functions, and sees nothing of how it
// is done.
#pragma once

#include "interpreter/routines/routine.h"

namespace isl::interpreter {

/// The kind of place that holds an operand.
enum class Source : std::uint8_t { name, register_, constant };

namespace operations {

// Each of these goes to `other` where a name holds no number, or where the evaluator has something to say.
[[nodiscard]] Perform load(Source source);  ///< a → to
[[nodiscard]] Perform binary(grammar::BinaryOp op, Source left, Source right);
/// The same with `#declare` of the name `to` with the result.
[[nodiscard]] Perform declare_binary(grammar::BinaryOp op, Source left, Source right);
[[nodiscard]] Perform unary(grammar::UnaryOp op, Source operand);
/// The comparison `node` of strings.
[[nodiscard]] Perform compare_texts();
/// `b` is the index of the term of the name `a`.
[[nodiscard]] Perform item();
/// The element of the array of the name `b` at index `a`.
[[nodiscard]] Perform element(Source index);
/// The built-in `function`; the arguments lie in registers from `a` on.
[[nodiscard]] Perform call();
/// `to` ? register a : register b.
[[nodiscard]] Perform choose();

/// `#declare` or `#local` of the name `b` with the number `a`.
[[nodiscard]] Perform declare(bool is_local, Source value);
/// The same of the element of the array of the name `b` at the index `to`.
[[nodiscard]] Perform declare_element(Source value, Source index);
// Each adds to the string of the name `a`, which no other value may share.
[[nodiscard]] Perform append_text();  ///< of the literal or name `node`
/// With the code in register `b`; `node` is where it stands.
[[nodiscard]] Perform append_character();
/// The macro's value is the number `a`.
[[nodiscard]] Perform yield(Source value);

// Jumps to `other`.
[[nodiscard]] Perform jump();
[[nodiscard]] Perform jump_unless();  ///< register a
/// Unless the directive `node` finds its name declared (or, with `negated`, not declared).
[[nodiscard]] Perform jump_unless_declared();
[[nodiscard]] Perform end();

/// Counts a turn of the loop `node`.
[[nodiscard]] Perform count_turn();
/// Begins the #for `node`, whose start, end and step are in registers from `to` on; goes to `other` if it has no turn.
[[nodiscard]] Perform begin_for();
/// Goes to the next turn of the #for, at `other`, and counts it.
[[nodiscard]] Perform next_for();

// These let the evaluator do `node`. All but the last go to `other` afterwards.
[[nodiscard]] Perform evaluate_number();  ///< → to
[[nodiscard]] Perform evaluate_declaration();
[[nodiscard]] Perform evaluate_yield();

}  // namespace operations
}  // namespace isl::interpreter
