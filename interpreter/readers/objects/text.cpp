// text: a line of letters from a font, swept along z.
#include "interpreter/builtins/characters.h"
#include "interpreter/expressions.h"
#include "interpreter/readers/objects/solid_draft.h"
#include "interpreter/readers/words/arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace isl::interpreter {
namespace {

using scene::SolidKind;
namespace word = grammar::word;

/// POV-Ray's built-in fonts have files of these names; a number beyond them means the last.
constexpr const char* kInternalFonts[] = {"timrom.ttf", "cyrvetic.ttf", "crystal.ttf", "povlogo.ttf"};

const Font& read_font(ElementStream& stream) {
  Context& context = stream.context();
  const Element next = stream.peek();
  if (next.is_word(word::kw_ttf)) {
    stream.drop();
    const SourceSpan where = stream.peek().span;
    const std::string name = read_name_of_file(stream, "the name of a font's file");
    return context.fonts.find(context, name, where);
  }
  if (!next.is_word(word::kw_internal))
    fail_expected(stream, "`ttf` and the name of a font's file, or `internal` and a number");
  stream.drop();
  const double number = read_number(stream, "the number of a font");
  if (!(number >= 0)) context.fail(next.span, fmt::format("a font's number must be at least 0, found {:g}", number));
  constexpr double kLast = static_cast<double>(std::size(kInternalFonts)) - 1;
  // POV-Ray counts from 1, and takes 0 for the last.
  const double place = number < 1 ? kLast : std::min(number - 1, kLast);
  return context.fonts.find(context, kInternalFonts[static_cast<std::size_t>(place)], next.span);
}

double read_depth(ElementStream& stream) {
  const SourceSpan span = stream.peek().span;
  const double depth = read_number(stream, "the depth of the text");
  if (!std::isfinite(depth))
    stream.context().fail_not_finite(span, fmt::format("a depth must be finite, found {:g}", depth));
  return depth;
}

void count_letters(ElementStream& stream, const scene::Outline& outline) {
  stream.context().check_memory(
      stream.span(), 2 * outline.points.capacity() * sizeof(scene::PlanePoint) + 2 * outline.orders.capacity());
}

}  // namespace

void read_text(ElementStream& stream, ObjectDraft& draft) {
  if (read_copy(stream, draft)) return;
  Context& context = stream.context();
  const Font& font = read_font(stream);
  stream.accept_comma();
  const std::string text = read_string(stream, "the text");
  stream.accept_comma();
  const double depth = read_depth(stream);
  stream.accept_comma();
  const SourceSpan place = stream.peek().span;
  const scene::Vec3 step = read_vector(stream, "the offset from letter to letter");
  if (!std::isfinite(step.x) || !std::isfinite(step.y) || !std::isfinite(step.z))
    context.fail_not_finite(place, "an offset must be finite");
  if (depth == 0) return leave_out(stream, draft, "this text has the depth 0");

  // Letters that step along z have heights of their own; all others are one solid.
  const bool is_one_solid = step.z == 0;
  scene::Group letters;
  scene::Outline outline;
  const auto add = [&](double front) {
    const scene::Solid solid{
        .kind = SolidKind::text, .radius_a = front + std::min(0.0, depth), .radius_b = front + std::max(0.0, depth)};
    add_outline(stream, draft, solid, outline);
  };
  Font::Line line(font);
  std::string_view rest = text;
  for (double number = 0; !rest.empty(); ++number) {
    if (!line.draw(take_character(rest), {step.x * number, step.y * number}, outline))
      context.fail(stream.span(), "a letter of this text's font is broken");
    count_letters(stream, outline);
    if (is_one_solid || outline.contours.empty()) continue;
    add(step.z * number);
    letters.children.push_back(draft.object);
    outline = {};
  }
  if (!is_one_solid) return set_group(stream, draft, std::move(letters));
  if (outline.contours.empty()) return leave_out(stream, draft, "this text has no visible letter");
  add(0);
}

}  // namespace isl::interpreter
