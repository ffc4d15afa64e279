#include "interpreter/readers/world/statements.h"

#include "interpreter/deprecated_names.h"
#include "interpreter/readers/patterns/warp.h"
#include "interpreter/readers/textures/maps.h"
#include "interpreter/readers/textures/pigment.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/readers/words/colour.h"
#include "interpreter/readers/words/transform.h"
#include "interpreter/records.h"
#include "renderer/effects/statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isl::interpreter {
namespace {

using scene::FieldPlace;
using scene::FieldRule;
using scene::Statement;
using scene::StatementField;
using scene::StatementKind;
namespace word = grammar::word;

/// Replaces the statement by the declared one that the block begins with, if it does.
void read_declared_name(ElementStream& stream, Statement& statement) {
  const Element first = stream.peek();
  if (!first.is(ElementKind::value) || first.node->kind != grammar::NodeKind::name) return;
  const Slot* const slot = without_wrapper(stream.context().scopes.find(first.word));
  if (slot->value.is_numeric()) return;
  const Value value = stream.take_value();
  if (value.kind() != ValueKind::statement || value.as<StatementValue>().statement.kind != statement.kind) {
    stream.context().fail(first.span,
                          fmt::format("expected {} or its items, found {}", statement.kind->noun, describe(value)));
  }
  statement.record = value.as<StatementValue>().statement.record;
}

/// Numbers of POV-Ray's statements may be out of bounds, with a warning: the nearest is taken, and in place of a kind
/// (a whole number) the first. In settings, which are ours, they are errors.
double read_number_of(ElementStream& stream, const StatementField& field, bool is_setting) {
  const std::string what = fmt::format("`{}`", field.word);
  const bool is_bounded = std::isfinite(field.low) || std::isfinite(field.high);
  if (!is_bounded) return read_number(stream, fmt::format("a number after {}", what));
  return is_setting ? read_number_in(stream, what, field.low, field.high)
                    : read_nearest_number(stream, what, field.low, field.high);
}

/// Precondition: the field has bounds.
int read_whole_number_of(ElementStream& stream, const StatementField& field, bool is_setting) {
  const SourceSpan span = stream.peek().span;
  const double number = read_number(stream, fmt::format("a number after `{}`", field.word));
  if (number == std::floor(number) && number >= field.low && number <= field.high) return static_cast<int>(number);
  const bool has_two = field.high == field.low + 1;
  const std::string message =
      fmt::format("`{}` must be {}{:g} {} {:g}, found {:g}", field.word, has_two ? "" : "a whole number from ",
                  field.low, has_two ? "or" : "to", field.high, number);
  if (is_setting) stream.context().fail(span, message);
  stream.context().warn(span, fmt::format("{}; {:g} is taken", message, field.low));
  return static_cast<int>(field.low);
}

/// Reads an item of a field if the next element is one: `operator()` is called with the field's place.
struct ItemReader {
  ElementStream& stream;
  const StatementField& field;
  bool is_setting;

  bool operator()(double* value) const {
    if (!take_word()) return false;
    const double number = read_number_of(stream, field, is_setting);
    *value = field.rule == FieldRule::degrees ? number * std::numbers::pi / 180 : number;
    return true;
  }
  bool operator()(int* value) const {
    if (!take_word()) return false;
    *value = read_whole_number_of(stream, field, is_setting);
    return true;
  }
  bool operator()(scene::Vec3* value) const {
    if (!take_word()) return false;
    const std::string what = fmt::format("a vector after `{}`", field.word);
    *value = field.rule == FieldRule::turned ? read_normal(stream, what) : read_vector(stream, what);
    return true;
  }
  bool operator()(scene::Colour* value) const {
    const Element& next = stream.peek();
    const bool is_there = field.word.empty() ? next.is(ElementKind::word) && is_colour_word(next.word) : take_word();
    if (is_there) *value = read_colour(stream);
    return is_there;
  }
  bool operator()(scene::Turbulence* value) const { return read_turbulence_item(stream, *value); }
  // Transforms turn several fields, so that the statement reads them itself.
  bool operator()(const scene::TransformId* /*value*/) const { return false; }
  bool operator()(scene::PigmentMapId* value) const {
    const Element next = stream.peek();
    if (!next.is_block(word::kw_color_map) && !next.is_block(word::kw_colour_map)) return false;
    stream.drop();
    *value = read_colour_map(stream.context(), next);
    return true;
  }
  bool operator()(std::vector<scene::Pigment>* value) const {
    const Element next = stream.peek();
    if (!next.is_block(word::kw_pigment)) return false;
    stream.drop();
    value->push_back(read_pigment(stream.context(), next, stream.context().default_texture.pigment));
    return true;
  }

 private:
  /// Takes the field's word if it is next.
  [[nodiscard]] bool take_word() const {
    const Element& next = stream.peek();
    if (!next.is(ElementKind::word) || stream.context().text(next.word) != field.word) return false;
    stream.drop();
    return true;
  }
};

/// A field whose value may stand without its word.
template <class Value>
struct Bare {
  Value* value = nullptr;  ///< null: the statement has none of that type
  std::string_view word;
};

template <class Value>
Bare<Value> bare_field(Statement& statement) {
  for (const StatementField& field : statement.kind->fields) {
    const FieldPlace place = field.place(statement.record);
    Value* const* const found = std::get_if<Value*>(&place);
    if (found && field.rule == FieldRule::bare) return {*found, field.word};
  }
  return {};
}

/// Reads a colour, or a lone number, as POV-Ray 1 had them.
bool read_bare_value(ElementStream& stream, Statement& statement) {
  if (!stream.peek().is(ElementKind::value)) return false;
  const auto number = bare_field<double>(statement);
  const auto colour = bare_field<scene::Colour>(statement);
  if (!number.value && !colour.value) return false;
  const Element next = stream.peek();
  const Value value = stream.take_value();
  if (number.value && value.is_number()) {
    stream.context().warn(next.span, fmt::format("found a number without a word; write `{}` before it", number.word));
    *number.value = value.number();
  } else if (colour.value && value.is_numeric() && next.node->kind != grammar::NodeKind::vector) {
    *colour.value = to_colour(read_colour_after(stream, value));
  } else {
    stream.context().fail(next.span,
                          fmt::format("expected an item of {}, found {}", statement.kind->noun, describe(value)),
                          value.is_numeric() && colour.value ? "write `rgb` before it" : "");
  }
  return true;
}

bool is_moved(const StatementField& field, const FieldPlace& place) {
  return field.rule == FieldRule::turned || std::holds_alternative<scene::TransformId*>(place);
}

void move(Context& context, scene::TransformId& id, const scene::Transform& transform) {
  auto& transforms = context.database.transforms;
  const scene::Transform total = id == scene::kIdentity ? transform : scene::then(transforms[index(id)], transform);
  id = add_record<scene::TransformId>(context, transforms, total);
}

/// Transforms change only the direction of the fields that are directions; a scale changes no length.
bool read_transform_of(ElementStream& stream, Statement& statement) {
  const auto takes = [&](const StatementField& field) { return is_moved(field, field.place(statement.record)); };
  if (std::ranges::none_of(statement.kind->fields, takes)) return false;
  const std::optional<scene::Transform> transform = read_transform(stream);
  if (!transform) return false;
  for (const StatementField& field : statement.kind->fields) {
    const FieldPlace place = field.place(statement.record);
    if (auto* const* const id = std::get_if<scene::TransformId*>(&place)) move(stream.context(), **id, *transform);
    if (auto* const* const vector = std::get_if<scene::Vec3*>(&place); vector && field.rule == FieldRule::turned) {
      **vector = transform->vector(**vector).normalized();
    }
  }
  return true;
}

bool read_statement_item(ElementStream& stream, Statement& statement) {
  if (read_bare_value(stream, statement) || read_transform_of(stream, statement)) return true;
  return std::ranges::any_of(statement.kind->fields, [&](const StatementField& field) {
    return std::visit(ItemReader{stream, field, statement.kind->is_setting}, field.place(statement.record));
  });
}

/// The words of the statement's items, for suggestions.
std::vector<grammar::Symbol> item_words(Context& context, const StatementKind& kind) {
  std::vector<grammar::Symbol> words;
  std::any record = kind.make();
  for (const StatementField& field : kind.fields) {
    const FieldPlace place = field.place(record);
    if (!field.word.empty()) words.push_back(context.symbols.intern(field.word));
    if (std::holds_alternative<scene::Colour*>(place) && field.word.empty()) words.push_back(word::kw_color);
    if (std::holds_alternative<scene::Turbulence*>(place)) words.push_back(word::kw_turbulence);
    if (is_moved(field, place)) words.push_back(word::kw_rotate);
  }
  return words;
}

}  // namespace

namespace {

const StatementKind* find_kind(const Context& context, grammar::Symbol word, bool is_setting) {
  const std::string_view text = context.text(word);
  const auto kinds = render::statement_kinds();
  const auto kind = std::ranges::find_if(
      kinds, [&](const StatementKind* k) { return k->is_setting == is_setting && k->word == text; });
  return kind == kinds.end() ? nullptr : *kind;
}

Statement read_statement(Context& context, const Element& block, const StatementKind& kind) {
  ElementStream stream(context, block);
  Statement statement{&kind, kind.make(), context.origin(block.span)};
  read_declared_name(stream, statement);
  while (!stream.peek().is(ElementKind::end)) {
    if (!read_statement_item(stream, statement)) refuse(stream, item_words(context, kind));
  }
  const std::string mistake = kind.check ? kind.check(statement.record) : "";
  if (!mistake.empty()) context.fail(block.word_span, mistake);
  return statement;
}

void place(Context& context, const Element& block, Statement statement) {
  context.count_primitive(block.span, sizeof(Statement));
  auto& statements = context.database.statements;
  if (statement.kind->list.empty()) {
    const auto earlier = std::ranges::find(statements, statement.kind, &Statement::kind);
    if (earlier != statements.end()) {
      context.warn(block.word_span, fmt::format("this {} replaces an earlier one", statement.kind->word));
      statements.erase(earlier);
    }
  }
  statements.push_back(std::move(statement));
}

}  // namespace

const StatementKind* statement_kind(const Context& context, grammar::Symbol word) {
  return grammar::is_reserved(word) ? find_kind(context, word, /*is_setting=*/false) : nullptr;
}

Statement read_statement(Context& context, const Element& block) {
  return read_statement(context, block, *statement_kind(context, block.word));
}

void place_statement(Context& context, const Element& block) { place(context, block, read_statement(context, block)); }

bool read_setting_block(ElementStream& stream) {
  Context& context = stream.context();
  const Element block = stream.peek();
  if (!block.is(ElementKind::block)) return false;
  const StatementKind* const kind = find_kind(context, block.word, /*is_setting=*/true);
  if (!kind) return false;
  stream.drop();
  place(context, block, read_statement(context, block, *kind));
  return true;
}

std::vector<grammar::Symbol> setting_words(Context& context) {
  std::vector<grammar::Symbol> words;
  for (const StatementKind* const kind : render::statement_kinds()) {
    if (kind->is_setting) words.push_back(context.symbols.intern(kind->word));
  }
  return words;
}

}  // namespace isl::interpreter
