#include "interpreter/tuples.h"

#include "interpreter/deprecated_names.h"
#include "interpreter/element_stream.h"
#include "interpreter/newer_words.h"
#include "interpreter/places.h"
#include "interpreter/readers/words/arguments.h"
#include "interpreter/readers/words/rvalue.h"
#include "interpreter/statement_ends.h"

#include <fmt/format.h>

#include <vector>

namespace isl::interpreter {
namespace {

using grammar::as;
using grammar::DeclareTuple;
using grammar::Items;
using grammar::Node;
using grammar::NodeKind;

/// The places of the fields, found before the values are evaluated: a macro that yields them has names of its own. Each
/// place is kept until its value is set.
class Fields {
 public:
  explicit Fields(Context& context) : context_(context) {}
  void find(const DeclareTuple& node) {
    for (const grammar::TupleField& field : node.fields) {
      if (field.target->kind == NodeKind::name)
        check_newer_name(context_, as<grammar::Name>(*field.target).name, field.target->span);
      Slot& slot = used(context_, slot_to_write(context_, *field.target, node.local), field.target->span);
      if (slot.value.kind() == ValueKind::function)
        context_.fail(field.target->span, "a function cannot be declared again", "`#undef` it first");
      context_.scopes.slots().retain(&slot);
      slots_.push_back(&slot);
    }
  }
  ~Fields() {
    for (Slot* const slot : slots_) context_.scopes.slots().release(slot);
  }
  Fields(const Fields&) = delete;
  Fields& operator=(const Fields&) = delete;

  /// Called after a mistake: the fields that have no value yet cause no further errors.
  void poison() {
    for (Slot* const slot : slots_) {
      if (slot->value.kind() == ValueKind::none) slot->value = Value::poison();
    }
  }

  [[nodiscard]] Slot& operator[](std::size_t i) const { return *slots_[i]; }

 private:
  Context& context_;
  std::vector<Slot*> slots_;
};

/// True if the value of a tuple is a place that is not declared.
bool is_undeclared(Context& context, Items value) {
  if (value.size() != 1 || !grammar::is_place(*value[0])) return false;
  if (value[0]->kind == NodeKind::name && is_newer_value(as<grammar::Name>(*value[0]).name)) return false;
  if (value[0]->kind == NodeKind::dot && !is_field(context, *value[0])) return false;
  const Slot* const slot = find_slot_if_declared(context, *value[0]);
  return !slot || slot->value.kind() == ValueKind::none;
}

void set(Context& context, const Node& target, Value value, Slot& slot, SourceSpan span) {
  if (is_container(value)) {
    if (target.kind != NodeKind::name) check_container_depth(context, value, span);
    context.check_memory(span, bytes_of_copy(value));
    value = copy_of_container(value);
  }
  slot.value = std::move(value);
}

void set_field(Context& context, const grammar::TupleField& field, Items value, Slot& slot, SourceSpan span) {
  if (field.optional && (value.empty() || is_undeclared(context, value))) return;
  if (value.empty()) context.fail(span, "this tuple lacks a value for a field that is not `optional`");
  ElementStream stream(context, value, value.front()->span);
  Value found = read_declared(stream);
  expect_end(stream);
  set(context, *field.target, std::move(found), slot, span);
}

/// The tuple that the right side is or yields. The stream is still in the scope of the macro that yielded it.
const grammar::Tuple& read_tuple(ElementStream& stream, const DeclareTuple& node) {
  Context& context = stream.context();
  const Element next = stream.peek();
  if (!next.is(ElementKind::value) || next.node->kind != NodeKind::tuple) {
    context.fail(next.is(ElementKind::end) ? node.span : next.span,
                 fmt::format("expected a tuple of {} values, found {}", node.fields.size(), describe(context, next)),
                 "write the values in parentheses: `(1, 2)`");
  }
  const auto& tuple = as<grammar::Tuple>(*next.node);
  // The comma after the last value is no value.
  std::size_t count = tuple.values.size();
  if (count > node.fields.size() && tuple.values.back().empty()) --count;
  if (count != node.fields.size()) {
    context.fail(next.span, fmt::format("expected a tuple of {} values, found one of {}", node.fields.size(), count));
  }
  return tuple;
}

/// As in POV-Ray, each field is set before the next value is evaluated: `(A, B) = (B, A)` gives B twice.
void set_fields(Context& context, const DeclareTuple& node, const Fields& fields) {
  ElementStream stream(context, node.value, node.span);
  const bool is_tuple = stream.peek().is(ElementKind::value) && stream.peek().node->kind == NodeKind::tuple;
  if (!is_tuple && node.fields.size() == 1) {
    set(context, *node.fields[0].target, read_declared(stream), fields[0], node.span);
  } else {
    const grammar::Tuple& tuple = read_tuple(stream, node);
    for (std::size_t i = 0; i < node.fields.size(); ++i)
      set_field(context, node.fields[i], tuple.values[i], fields[i], tuple.span);
    stream.drop();
  }
  stream.accept(ElementKind::semicolon);
  expect_end(stream);
}

}  // namespace

[[gnu::noinline]] void declare_tuple(Context& context, const DeclareTuple& node) {
  try {
    Fields fields(context);
    fields.find(node);
    try {
      set_fields(context, node, fields);
    } catch (const Failed&) {
      fields.poison();
      throw;
    }
    skip_semicolon(context);
  } catch (const Failed&) {
    skip_rest(context);
  }
}

}  // namespace isl::interpreter
