// What every reader asks of its stream: a number, a vector, a string next; a comma or none; and one way to complain
// about anything else.
#pragma once

#include "interpreter/element_stream.h"

#include <span>
#include <string>
#include <string_view>

namespace isl::interpreter {

/// What a message calls the element: "`translate`", "a `pigment` block", "`,`", "the end of `sphere`".
[[nodiscard]] std::string describe(Context& context, const Element& element);

/// Fails with "expected <what>, found <the next element>".
[[noreturn]] void fail_expected(ElementStream& stream, std::string_view what);

/// The next element as a number; `what` names it in messages ("a radius").
[[nodiscard]] double read_number(ElementStream& stream, std::string_view what);
/// The same, in [low, high] or an error.
[[nodiscard]] double read_number_in(ElementStream& stream, std::string_view what, double low, double high);
/// A number above zero and finite.
[[nodiscard]] double read_positive(ElementStream& stream, std::string_view what);
/// A vector of three terms, promoted: a number fills all three, a shorter vector is padded with zeros.
[[nodiscard]] scene::Vec3 read_vector(ElementStream& stream, std::string_view what);
[[nodiscard]] scene::Vec3 to_vector(ElementStream& stream, const Value& value, SourceSpan span, std::string_view what);
[[nodiscard]] std::string read_string(ElementStream& stream, std::string_view what);
/// A word's optional truth value: `hierarchy`, `hierarchy on`, `hierarchy 0`.
[[nodiscard]] bool read_optional_truth(ElementStream& stream);
/// Fails where anything is left.
void expect_end(ElementStream& stream);

/// An element that no reader of the enclosing construct takes. What POV-Ray has and we do not is skipped ("`media` is
/// not supported"); a misspelt word gets a suggestion from `known`; all else fails.
void refuse(ElementStream& stream, std::span<const grammar::Symbol> known);

/// The identifier that an expression begins with: how a contextual word reaches its reader when what follows it made
/// the parser see an operator or a call (`hardness -4`, `hardness (2)`). kNoSymbol where there is none.
[[nodiscard]] grammar::Symbol leading_name(const Element& element);
/// Reads `word <number>` where the next element leads with that contextual word.
[[nodiscard]] double read_contextual_number(ElementStream& stream, std::string_view what);

/// A vector, made of unit length; one without length is an error.
[[nodiscard]] scene::Vec3 read_normal(ElementStream& stream, std::string_view what);

}  // namespace isl::interpreter
