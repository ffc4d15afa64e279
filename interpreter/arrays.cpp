#include "interpreter/arrays.h"

#include "interpreter/element_stream.h"
#include "interpreter/expressions.h"
#include "interpreter/readers/words/rvalue.h"

#include <fmt/format.h>

#include <algorithm>

namespace isl::interpreter {
namespace {

using grammar::as;
using grammar::Node;
using grammar::NodeKind;

/// POV-Ray's limit.
constexpr std::size_t kMaxDimensions = 5;

/// The depth of arrays within arrays, counted up to `most`: an element may have been put into one that was nested
/// before, so that the whole is deeper than any value that was checked.
std::uint32_t depth_of(const Value& value, std::uint32_t most) {
  if (value.kind() != ValueKind::array || most == 0) return 0;
  std::uint32_t deepest = 0;
  for (const Slot* element : value.as<ArrayValue>().elements) {
    deepest = std::max(deepest, depth_of(element->value, most - 1));
    if (deepest + 1 == most) break;
  }
  return deepest + 1;
}

void initialise(ElementStream& stream, ArrayValue& array, std::size_t dimension, std::size_t first) {
  Context& context = stream.context();
  std::size_t stride = 1;
  for (std::size_t d = dimension + 1; d < array.dimensions.size(); ++d) stride *= array.dimensions[d];
  const std::size_t wanted = array.dimensions[dimension];
  std::size_t found = 0;
  while (!stream.peek().is(ElementKind::end)) {
    const Element element = stream.peek();
    const std::size_t place = first + found * stride;
    if (++found > wanted) {
      context.fail(element.span,
                   fmt::format("this dimension of the array has {} elements, found more initialisers", wanted));
    }
    if (dimension + 1 < array.dimensions.size()) {
      if (!element.is_block(grammar::kNoSymbol))
        context.fail(element.span, "expected `{` with the next dimension's initialisers");
      ElementStream inner(context, stream.take());
      initialise(inner, array, dimension + 1, place);
    } else {
      Value value = read_rvalue(stream);
      check_array_nesting(context, value, element.span);
      array.elements[place]->value = std::move(value);
    }
    stream.accept_comma();
  }
  if (found != wanted) {
    context.fail(stream.span(), fmt::format("this dimension of the array has {} elements, found {} initialiser{}",
                                            wanted, found, found == 1 ? "" : "s"));
  }
}

std::size_t element_count(Context& context, const Node& node) {
  const double size = evaluate_number(context, node);
  if (!(size + kTolerance >= 1))
    context.fail(node.span, fmt::format("an array's size must be at least 1, found {:g}", size));
  if (size > 1e12) context.fail(node.span, fmt::format("an array of {:g} elements is too large", size));
  return static_cast<std::size_t>(size + kTolerance);
}

/// The index that the value of the subscript `node` means.
std::size_t place_of(Context& context, const Node& node, double value, std::size_t size) {
  const double index = value + kTolerance;
  if (!(index >= 0 && index < static_cast<double>(size))) {
    context.fail(node.span, fmt::format("expected an index from 0 to {}, found {:g}", size - 1, index));
  }
  return static_cast<std::size_t>(index);
}

/// The one-dimensional array that the slot holds, or null.
ArrayValue* list_in(const Slot* slot) {
  if (!slot || slot->value.kind() != ValueKind::array) return nullptr;
  ArrayValue& array = slot->value.as<ArrayValue>();
  return array.dimensions.size() == 1 ? &array : nullptr;
}

struct Subscript {
  const Node* node;
  double value;
};

/// The element for a list of subscripts; the first subscript is last in the list.
Slot* element_at(Context& context, const grammar::Index& node, Slot* slot, std::vector<Subscript>& subscripts,
                 bool may_be_undeclared) {
  while (!subscripts.empty()) {
    if (slot->value.kind() == ValueKind::poison) throw Failed{};
    if (slot->value.kind() != ValueKind::array) {
      if (may_be_undeclared) return nullptr;
      const Node* base = node.base;
      while (base->kind == NodeKind::index) base = as<grammar::Index>(*base).base;
      context.fail(base->span, fmt::format("expected an array before `[`, found {}", describe(slot->value)));
    }
    const ArrayValue& array = slot->value.as<ArrayValue>();
    if (subscripts.size() < array.dimensions.size()) {
      context.fail(node.span, fmt::format("the array has {} dimensions, found {} index{}", array.dimensions.size(),
                                          subscripts.size(), subscripts.size() == 1 ? "" : "es"));
    }
    std::size_t place = 0;
    for (const std::size_t size : array.dimensions) {
      place = place * size + place_of(context, *subscripts.back().node, subscripts.back().value, size);
      subscripts.pop_back();
    }
    slot = array.elements[place];
  }
  return slot;
}

}  // namespace

void check_array_nesting(Context& context, const Value& element, SourceSpan span) {
  context.check_value_depth(span, 1 + depth_of(element, scene::kMaxValueDepth));
}

Value make_array(Context& context, const grammar::Array& node) {
  if (node.dimensions.size() > kMaxDimensions) {
    context.fail(node.span,
                 fmt::format("an array has at most {} dimensions, found {}", kMaxDimensions, node.dimensions.size()));
  }
  std::vector<std::size_t> dimensions;
  double total = 1;
  for (const Node* dimension : node.dimensions) {
    dimensions.push_back(element_count(context, *dimension));
    total *= static_cast<double>(dimensions.back());
  }
  constexpr double kMost = 1e17;  // more elements than any machine holds; their bytes can still be counted
  context.check_memory(node.span, ArrayValue::bytes_of(static_cast<std::size_t>(std::min(total, kMost))));
  Ref<ArrayValue> array = make_shared_value<ArrayValue>(std::move(dimensions), context.scopes.slots(), context.memory);
  if (node.initialised) {
    ElementStream stream(context, node.items, node.span);
    initialise(stream, *array, 0, 0);
  }
  return {ValueKind::array, array};
}

// A subscript may call a macro that undeclares the array, or declares another by its name. So subscripts are evaluated
// first, and the array is looked up after them.
Slot* find_element(Context& context, const grammar::Index& node, bool may_be_undeclared) {
  // The common case first: A[i] of one dimension.
  if (node.base->kind == NodeKind::name) {
    const grammar::Symbol name = as<grammar::Name>(*node.base).name;
    if (list_in(context.scopes.find(name))) {
      const double index = evaluate_number(context, *node.subscript);
      const ArrayValue* const list = list_in(context.scopes.find(name));
      if (!list) context.fail(node.span, "evaluating the index has undeclared this array");
      return list->elements[place_of(context, *node.subscript, index, list->elements.size())];
    }
  }
  // A[i][j] is Index(Index(A, i), j): the last subscript is taken off first.
  std::vector<Subscript> subscripts;
  const Node* base = &node;
  while (base->kind == NodeKind::index) {
    subscripts.push_back({as<grammar::Index>(*base).subscript, 0});
    base = as<grammar::Index>(*base).base;
  }
  const auto find_base = [&] {
    return may_be_undeclared ? find_slot_if_declared(context, *base) : &find_slot(context, *base);
  };
  const Slot* const before = find_base();
  if (!before) return nullptr;
  if (before->value.kind() == ValueKind::array) {
    for (std::size_t i = subscripts.size(); i-- > 0;)
      subscripts[i].value = evaluate_number(context, *subscripts[i].node);
  }
  Slot* const slot = find_base();
  return slot ? element_at(context, node, slot, subscripts, may_be_undeclared) : nullptr;
}

}  // namespace isl::interpreter
