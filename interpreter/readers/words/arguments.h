// The requests of every reader to its stream: a number, a vector, a string next; a comma or none; and one common form
// of error for anything else.
#pragma once

#include "interpreter/element_stream.h"

#include <span>
#include <string>
#include <string_view>

namespace isl::interpreter {

/// The element's name in messages: "`translate`", "a `pigment` block", "`,`", "the end of `sphere`".
[[nodiscard]] std::string describe(Context& context, const Element& element);

/// Fails with "expected <what>, found <the next element>".
[[noreturn]] void fail_expected(ElementStream& stream, std::string_view what);

/// The next element as a number; `what` names it in messages ("a radius").
[[nodiscard]] double read_number(ElementStream& stream, std::string_view what);
/// The same for a number in [low, high]; others are errors.
[[nodiscard]] double read_number_in(ElementStream& stream, std::string_view what, double low, double high);
/// The same with the nearest bound in place of any other number, which is warned of.
[[nodiscard]] double read_nearest_number(ElementStream& stream, std::string_view what, double low, double high);
/// A finite number above zero.
[[nodiscard]] double read_positive(ElementStream& stream, std::string_view what);
/// A vector of three terms, promoted: a number fills all three, a shorter vector is padded with zeros.
[[nodiscard]] scene::Vec3 read_vector(ElementStream& stream, std::string_view what);
[[nodiscard]] scene::Vec3 to_vector(ElementStream& stream, const Value& value, SourceSpan span, std::string_view what);
[[nodiscard]] std::string read_string(ElementStream& stream, std::string_view what);
/// A file's name: a string in which a backslash is an ordinary character.
[[nodiscard]] std::string read_name_of_file(ElementStream& stream, std::string_view what);
/// A word's optional truth value: `hierarchy`, `hierarchy on`, `hierarchy 0`.
[[nodiscard]] bool read_optional_truth(ElementStream& stream);
/// Fails if any element is left.
void expect_end(ElementStream& stream);

/// Handles an element that no reader of the enclosing construct takes. An unsupported feature of POV-Ray is skipped
/// ("`media` is not supported"); a misspelt word gets a suggestion from `known`; everything else fails.
void refuse(ElementStream& stream, std::span<const grammar::Symbol> known);

/// The identifier that an expression begins with: a contextual word reaches its reader so if the text after it made the
/// parser see an operator or a call (`hardness -4`, `hardness (2)`). kNoSymbol if there is none.
[[nodiscard]] grammar::Symbol leading_name(const Element& element);
/// Reads `word <number>` if the next element begins with that contextual word.
[[nodiscard]] double read_contextual_number(ElementStream& stream, std::string_view what);

/// A vector scaled to unit length; a zero vector is an error.
[[nodiscard]] scene::Vec3 read_normal(ElementStream& stream, std::string_view what);

}  // namespace isl::interpreter
