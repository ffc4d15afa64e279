#include "interpreter/dictionaries.h"

#include "interpreter/element_stream.h"
#include "interpreter/expressions.h"
#include "interpreter/newer_words.h"
#include "interpreter/places.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/readers/words/rvalue.h"

#include <fmt/format.h>

#include <string>

namespace isl::interpreter {
namespace {

using grammar::as;

std::string key_of(Context& context, const grammar::DictionaryField& field) {
  if (field.key->kind == grammar::NodeKind::name) return std::string(context.text(as<grammar::Name>(*field.key).name));
  const Value key = evaluate_items(context, as<grammar::Entry>(*field.key).items, field.key->span);
  if (key.kind() != ValueKind::string)
    context.fail(field.key->span, fmt::format("expected a string as key of a dictionary, found {}", describe(key)));
  return key.as<StringValue>().text;
}

void read_field(Context& context, const grammar::DictionaryField& field, DictionaryValue& dictionary) {
  const SourceSpan span = field.key->span;
  const std::string key = key_of(context, field);
  ElementStream stream(context, field.value, span);
  Value value = read_declared(stream);
  expect_end(stream);
  if (dictionary.find(key)) context.warn(span, fmt::format("the key `{}` is given twice; the last value counts", key));
  check_container_depth(context, value, span);
  context.check_memory(span, DictionaryValue::bytes_of_field(key) + kSlotBytes);
  dictionary.add(key).value = is_container(value) ? copy_of_container(value) : std::move(value);
}

}  // namespace

Value make_dictionary(Context& context, const grammar::Dictionary& node) {
  note_newer_word(context, grammar::newer_word::kw_dictionary, node.span);
  const auto dictionary = make_shared_value<DictionaryValue>(context.scopes.slots(), context.memory);
  ElementStream stream(context, node.items, node.span);
  while (!stream.peek().is(ElementKind::end)) {
    if (!stream.peek().is(ElementKind::field))
      fail_expected(stream, "a field of the dictionary, `.Name: value` or `[\"key\"]: value`");
    const Element field = stream.take();
    read_field(context, as<grammar::DictionaryField>(*field.node), *dictionary);
    if (!stream.accept_comma() && !stream.peek().is(ElementKind::end))
      fail_expected(stream, "`,` between the fields of a dictionary");
  }
  return {ValueKind::dictionary, dictionary};
}

}  // namespace isl::interpreter
