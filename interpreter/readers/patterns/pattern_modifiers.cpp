// The words that belong to one pattern each, one row a word.
#include "interpreter/readers/patterns/pattern.h"
#include "interpreter/readers/patterns/pattern_operands.h"
#include "interpreter/readers/words/arguments.h"

#include <fmt/format.h>

#include <algorithm>

namespace isl::interpreter {
namespace {

using scene::FractalOperands;
using scene::Pattern;
using scene::PavementOperands;
namespace word = grammar::word;

/// Reads the operand after its word; returns false if the word does not apply to the pattern.
using ReadModifier = bool (*)(ElementStream& stream, Pattern& pattern, std::string_view what);

struct ModifierRow {
  grammar::Symbol word;
  ReadModifier read;
  std::string_view owners;  ///< the patterns that take the word, for messages
};

template <auto member>
struct MemberOf;
template <class Operands, class Type, Type Operands::*member>
struct MemberOf<member> {
  using Owner = Operands;
};

template <auto member>
bool read_number_into(ElementStream& stream, Pattern& pattern, std::string_view what) {
  auto* const operands = std::get_if<typename MemberOf<member>::Owner>(&pattern.operands);
  if (!operands) return false;
  operands->*member = read_number(stream, what);
  return true;
}

template <auto member, int low, int high>
bool read_choice_into(ElementStream& stream, Pattern& pattern, std::string_view what) {
  auto* const operands = std::get_if<typename MemberOf<member>::Owner>(&pattern.operands);
  if (!operands) return false;
  operands->*member = static_cast<int>(read_number_in(stream, what, low, high));
  return true;
}

template <auto member>
bool read_vector_into(ElementStream& stream, Pattern& pattern, std::string_view what) {
  auto* const operands = std::get_if<typename MemberOf<member>::Owner>(&pattern.operands);
  if (!operands) return false;
  operands->*member = read_vector(stream, what);
  return true;
}

// ---- Words with a rule of their own ---------------------------------------------------------------------------------

/// `form` is a vector for `crackle` and a number for `pavement`.
bool read_form(ElementStream& stream, Pattern& pattern, std::string_view what) {
  return read_vector_into<&scene::CrackleOperands::form>(stream, pattern, what) ||
         read_choice_into<&PavementOperands::form, 0, 3>(stream, pattern, "`form`");
}

bool read_solid(ElementStream& stream, Pattern& pattern, std::string_view /*what*/) {
  auto* const crackle = std::get_if<scene::CrackleOperands>(&pattern.operands);
  if (!crackle) return false;
  crackle->is_solid = read_optional_truth(stream);
  return true;
}

/// Facets have a size in space or a size among normals: the last of the two words decides.
bool read_coords(ElementStream& stream, Pattern& pattern, std::string_view what) {
  if (!read_number_into<&scene::FacetsOperands::coords>(stream, pattern, what)) return false;
  std::get<scene::FacetsOperands>(pattern.operands).size = 0;
  return true;
}

bool read_size(ElementStream& stream, Pattern& pattern, std::string_view what) {
  if (!read_number_into<&scene::FacetsOperands::size>(stream, pattern, what)) return false;
  std::get<scene::FacetsOperands>(pattern.operands).coords = 0;
  return true;
}

/// POV-Ray warns of an exponent that it does not support, and takes 2.
bool read_exponent(ElementStream& stream, Pattern& pattern, std::string_view what) {
  auto* const fractal = std::get_if<FractalOperands>(&pattern.operands);
  if (!fractal) return false;
  const SourceSpan span = stream.peek().span;
  if (fractal->magnet != 0) stream.context().fail(span, "`exponent` is not allowed with `magnet`");
  const double exponent = read_number(stream, what);
  const bool is_known = exponent >= 2 && exponent < 34;
  if (!is_known)
    stream.context().warn(span, fmt::format("`exponent` must be from 2 to 33, found {:g}; 2 is used", exponent));
  fractal->exponent = is_known ? static_cast<int>(exponent) : 2;
  return true;
}

/// `exterior type, factor` of a fractal; `exterior form` of a pavement.
bool read_exterior(ElementStream& stream, Pattern& pattern, std::string_view /*what*/) {
  if (!read_choice_into<&FractalOperands::exterior_type, 0, 6>(stream, pattern, "the type of the `exterior`"))
    return read_choice_into<&PavementOperands::exterior, 0, 2>(stream, pattern, "`exterior`");
  stream.accept_comma();
  std::get<FractalOperands>(pattern.operands).exterior_factor = read_number(stream, "a factor");
  return true;
}

bool read_interior(ElementStream& stream, Pattern& pattern, std::string_view /*what*/) {
  if (!read_choice_into<&FractalOperands::interior_type, 0, 6>(stream, pattern, "the type of the `interior`"))
    return read_choice_into<&PavementOperands::interior, 0, 2>(stream, pattern, "`interior`");
  stream.accept_comma();
  std::get<FractalOperands>(pattern.operands).interior_factor = read_number(stream, "a factor");
  return true;
}

bool read_sides(ElementStream& stream, Pattern& pattern, std::string_view what) {
  auto* const pavement = std::get_if<PavementOperands>(&pattern.operands);
  if (!pavement) return false;
  const SourceSpan span = stream.peek().span;
  pavement->sides = static_cast<int>(read_number(stream, what));
  if (pavement->sides != 3 && pavement->sides != 4 && pavement->sides != 6) {
    stream.context().fail(span, fmt::format("`number_of_sides` must be 3, 4 or 6, found {}", pavement->sides));
  }
  return true;
}

constexpr ModifierRow kModifiers[] = {
    {word::kw_agate_turb, read_number_into<&scene::AgateOperands::turbulence>, "`agate`"},
    {word::kw_brick_size, read_vector_into<&scene::BrickOperands::size>, "`brick`"},
    {word::kw_mortar, read_number_into<&scene::BrickOperands::mortar>, "`brick`"},
    {word::kw_control0, read_number_into<&scene::QuiltedOperands::control0>, "`quilted`"},
    {word::kw_control1, read_number_into<&scene::QuiltedOperands::control1>, "`quilted`"},
    {word::kw_form, read_form, "`crackle` and `pavement`"},
    {word::kw_metric, read_number_into<&scene::CrackleOperands::metric>, "`crackle`"},
    {word::kw_offset, read_number_into<&scene::CrackleOperands::offset>, "`crackle`"},
    {word::kw_solid, read_solid, "`crackle`"},
    {word::kw_coords, read_coords, "`facets`"},
    {word::kw_size, read_size, "`facets`"},
    {word::kw_interpolate, read_choice_into<&scene::DensityFileOperands::interpolate, 0, 2>, "`density_file`"},
    {word::kw_exponent, read_exponent, "`mandel` and `julia`"},
    {word::kw_exterior, read_exterior, "fractals and `pavement`"},
    {word::kw_interior, read_interior, "fractals and `pavement`"},
    {word::kw_number_of_sides, read_sides, "`pavement`"},
    {word::kw_number_of_tiles, read_choice_into<&PavementOperands::tiles, 1, 6>, "`pavement`"},
    {word::kw_pattern, read_choice_into<&PavementOperands::pattern, 1, 22>, "`pavement`"},
};

}  // namespace

bool read_operand_modifier(ElementStream& stream, Pattern& pattern) {
  Context& context = stream.context();
  const Element next = stream.peek();
  const auto* const row = std::ranges::find(kModifiers, next.word, &ModifierRow::word);
  if (row == std::end(kModifiers)) return false;
  stream.drop();
  const std::string_view name = context.text(next.word);
  if (!row->read(stream, pattern, fmt::format("`{}`", name))) {
    context.fail(next.span, fmt::format("`{}` applies to {}, found it in `{}`", name, row->owners,
                                        name_of(context, pattern.kind)));
  }
  return true;
}

}  // namespace isl::interpreter
