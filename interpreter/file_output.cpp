#include "interpreter/file_output.h"

#include "interpreter/readers/words/arguments.h"
#include "interpreter/readers/words/rvalue.h"

#include <fmt/format.h>
#include <fmt/printf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace isl::interpreter {
namespace {

namespace word = grammar::word;

/// A whole number with a fixed size in bytes. POV-Ray 3.7 has no unsigned form of 32 bits.
struct BinaryForm {
  grammar::Symbol word;
  int bytes;
  bool is_signed;
  bool is_big_endian;
};

constexpr std::array kForms{
    BinaryForm{word::kw_uint8, 1, false, false},   BinaryForm{word::kw_sint8, 1, true, false},
    BinaryForm{word::kw_uint16be, 2, false, true}, BinaryForm{word::kw_uint16le, 2, false, false},
    BinaryForm{word::kw_sint16be, 2, true, true},  BinaryForm{word::kw_sint16le, 2, true, false},
    BinaryForm{word::kw_sint32be, 4, true, true},  BinaryForm{word::kw_sint32le, 4, true, false},
};

/// Rounds to the nearest, halves up, and clamps to the range, as POV-Ray does; NaN becomes 0.
void append_binary(std::string& bytes, double number, const BinaryForm& form) {
  const double range = std::ldexp(1.0, 8 * form.bytes);
  const double low = form.is_signed ? -range / 2 : 0;
  const double high = low + range - 1;
  const double rounded = std::isnan(number) ? 0 : std::clamp(std::floor(number + 0.5), low, high);
  const auto bits = static_cast<std::uint64_t>(static_cast<std::int64_t>(rounded));
  for (int i = 0; i < form.bytes; ++i) {
    const int shift = 8 * (form.is_big_endian ? form.bytes - 1 - i : i);
    bytes += static_cast<char>(bits >> shift & 0xFFu);
  }
}

std::string read_binary(ElementStream& stream, const BinaryForm& form) {
  stream.drop();
  const SourceSpan span = stream.peek().span;
  const Value value = read_rvalue(stream);
  if (!value.is_numeric()) {
    stream.context().fail(span, fmt::format("expected a number or vector after `{}`, found {}",
                                            stream.context().text(form.word), describe(value)));
  }
  std::string bytes;
  for (int i = 0; i < value.term_count(); ++i) append_binary(bytes, value.terms()[i], form);
  return bytes;
}

std::string spelled(const Value& value) {
  if (value.is_number()) return fmt::sprintf("%g", value.number());
  std::string text = "<";
  for (int i = 0; i < value.term_count(); ++i) {
    if (i > 0) text += ',';
    text += fmt::sprintf("%g", value.terms()[i]);
  }
  return text + "> ";
}

}  // namespace

std::string read_output(ElementStream& stream) {
  const Element next = stream.peek();
  if (next.is(ElementKind::word)) {
    const auto form =
        std::find_if(kForms.begin(), kForms.end(), [&](const auto& row) { return row.word == next.word; });
    if (form != kForms.end()) return read_binary(stream, *form);
  }
  const Value value = read_rvalue(stream);
  if (value.is_numeric()) return spelled(value);
  if (value.kind() == ValueKind::string) return value.as<StringValue>().text;
  stream.context().fail(next.span,
                        fmt::format("expected a number, vector or string to write, found {}", describe(value)));
}

}  // namespace isl::interpreter
