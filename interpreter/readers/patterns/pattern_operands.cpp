#include "interpreter/readers/patterns/pattern_operands.h"

#include "interpreter/functions/functions.h"
#include "interpreter/readers/objects/objects.h"
#include "interpreter/readers/patterns/image.h"
#include "interpreter/readers/patterns/operand_stream.h"
#include "interpreter/readers/patterns/pattern.h"
#include "interpreter/readers/textures/pigment.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/readers/words/transform.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace isl::interpreter {
namespace {

using render::info_of;
using render::PatternBlock;
using scene::OperandField;
using scene::Operands;
using scene::Pattern;
using scene::PatternKind;

scene::ImageId read_image(ElementStream& stream, PatternKind kind) {
  scene::Image image = read_image_source(stream);
  image.holds_numbers = kind != PatternKind::image_map;
  while (read_image_item(stream, image)) {
  }
  // As in POV-Ray, an image_pattern takes colours even where `use_index` asks for numbers.
  if (kind == PatternKind::image_pattern && image.channel != scene::ImageChannel::alpha)
    image.channel = scene::ImageChannel::colour;
  return add_image(stream.context(), std::move(image));
}

scene::ObjectOperands read_object(ElementStream& stream, PatternKind kind) {
  Context& context = stream.context();
  const SourceSpan span = stream.peek().span;
  const Ref<ObjectValue> object = read_child(stream);
  if (!object) fail_expected(stream, "an object");
  scene::Object placed = object->object;
  if (kind == PatternKind::potential && placed.kind != scene::Object::Kind::blob) {
    // An empty group stands for an object that was refused already.
    const bool is_empty = placed.kind == scene::Object::Kind::group &&
                          (placed.shape == scene::kNone || context.database.groups[placed.shape].children.empty());
    if (is_empty) return {};
    context.fail(span, "`potential` takes a blob");
  }
  while (const std::optional<scene::Transform> next = read_transform(stream))
    placed.parent_from_object = scene::then(placed.parent_from_object, *next);
  if (placed.shape == scene::kNone) return {};
  context.database.pattern_objects.push_back(placed);
  return {static_cast<std::uint32_t>(context.database.pattern_objects.size() - 1)};
}

/// `{ red, green, blue, filter, transmit }`: any of them may be missing before a comma or at the end.
scene::ColourOperands read_colour_functions(ElementStream& stream) {
  scene::ColourOperands colour;
  for (scene::FunctionId& term : colour.terms) {
    if (stream.peek().is(ElementKind::end)) break;
    if (stream.accept_comma()) continue;
    term = read_function_operand(stream);
    stream.accept_comma();
  }
  return colour;
}

scene::PigmentOperands read_pigment_operand(ElementStream& stream) {
  const scene::Pigment pigment = read_pigment_body(stream, {});
  return {patterned_pigment(stream.context(), pigment)};
}

/// Reads a value of the type that the field has.
struct FieldReader {
  ElementStream& stream;
  const OperandField& field;
  std::string what;

  scene::OperandValue operator()(double /*value*/) const { return number(); }
  scene::OperandValue operator()(int /*value*/) const { return static_cast<int>(number()); }
  scene::OperandValue operator()(bool /*value*/) const { return read_optional_truth(stream); }
  scene::OperandValue operator()(const scene::Vec3& /*value*/) const { return read_vector(stream, what); }
  template <class Other>
  scene::OperandValue operator()(const Other& /*value*/) const {
    ISL_CHECK(false, "the operand {} has no way to be read", what);
  }

 private:
  [[nodiscard]] double number() const {
    const bool is_bounded = std::isfinite(field.low) || std::isfinite(field.high);
    return is_bounded ? read_number_in(stream, what, field.low, field.high) : read_number(stream, what);
  }
};

const OperandField* field_named(std::span<const OperandField> fields, std::string_view word) {
  const auto field = std::ranges::find(fields, word, &OperandField::word);
  return field == fields.end() ? nullptr : &*field;
}

/// The patterns that have an operand of that word, as messages name them: in accents, joined by commas and `and`.
std::string owners_of(std::string_view word) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < scene::kPatternKindCount; ++i) {
    const auto kind = PatternKind(i);
    if (!info_of(kind).operands || !field_named(info_of(kind).operands().fields, word)) continue;
    names.push_back(fmt::format("`{}`", name_of(kind)));
  }
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

/// Some pattern has an operand of the word. Reserved words have the same numbers in every scene.
bool is_operand_word(Context& context, grammar::Symbol symbol) {
  using Flags = std::array<bool, grammar::word::kReservedCount>;
  static const Flags kFlags = [&context] {
    Flags flags{};
    for (std::size_t i = 0; i < scene::kPatternKindCount; ++i) {
      if (!info_of(PatternKind(i)).operands) continue;
      for (const OperandField& field : info_of(PatternKind(i)).operands().fields) {
        if (!field.word.empty()) flags.at(static_cast<std::size_t>(context.symbols.intern(field.word))) = true;
      }
    }
    return flags;
  }();
  return grammar::is_reserved(symbol) && kFlags[static_cast<std::size_t>(symbol)];
}

}  // namespace

bool is_function(const Element& element) {
  return element.is(ElementKind::value) && element.node->kind == grammar::NodeKind::function;
}

void read_operands(ElementStream& stream, Pattern& pattern, std::string_view word) {
  const render::PatternInfo& info = info_of(pattern.kind);
  switch (info.block) {
    case PatternBlock::image: pattern.operands = read_image(stream, pattern.kind); break;
    case PatternBlock::object:
    case PatternBlock::blob: pattern.operands = read_object(stream, pattern.kind); break;
    case PatternBlock::colours: pattern.operands = read_colour_functions(stream); break;
    case PatternBlock::pigment: pattern.operands = read_pigment_operand(stream); break;
    case PatternBlock::none:
    case PatternBlock::optional:
    case PatternBlock::of_host:
    case PatternBlock::function: break;
  }
  if (!info.read) return;
  OperandStream reader(stream);
  info.read(reader, std::get<Operands>(pattern.operands).record, word);
  reader.rethrow_failure();
}

scene::FunctionId read_function_operand(ElementStream& stream) {
  if (!is_function(stream.peek())) fail_expected(stream, "`function { … }`");
  const Element next = stream.take();
  return make_point_function(stream.context(), grammar::as<grammar::Function>(*next.node));
}

bool read_operand_modifier(ElementStream& stream, Pattern& pattern) {
  Context& context = stream.context();
  const Element next = stream.peek();
  if (pattern.kind == PatternKind::potential && next.is_word(word::kw_threshold)) {
    stream.drop();
    std::get<scene::ObjectOperands>(pattern.operands).less_threshold = read_optional_truth(stream);
    return true;
  }
  if (!is_operand_word(context, next.word)) return false;
  stream.drop();
  const std::string_view word = context.text(next.word);
  auto* const operands = std::get_if<Operands>(&pattern.operands);
  const OperandField* const field = operands ? field_named(operands->fields, word) : nullptr;
  if (!field) {
    const std::string found = pattern.kind == PatternKind::plain
                                  ? "found it before any pattern"
                                  : fmt::format("found it in `{}`", name_of(pattern.kind));
    context.fail(next.span, fmt::format("`{}` applies to {}, {}", word, owners_of(word), found));
  }
  if (field->read) {
    OperandStream reader(stream);
    field->read(reader, operands->record);
    reader.rethrow_failure();
  } else {
    const FieldReader read_value{stream, *field, fmt::format("`{}`", word)};
    field->set(operands->record, std::visit(read_value, field->get(operands->record)));
  }
  return true;
}

void check_operands(ElementStream& stream, const Pattern& pattern) {
  const auto check = info_of(pattern.kind).check;
  const auto* const operands = std::get_if<Operands>(&pattern.operands);
  if (!check || !operands) return;
  OperandStream reader(stream);
  check(reader, operands->record);
  reader.rethrow_failure();
}

}  // namespace isl::interpreter
