#include "interpreter/arrays.h"

#include "interpreter/element_stream.h"
#include "interpreter/expressions.h"
#include "interpreter/places.h"
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
      check_container_depth(context, value, element.span);
      if (!value.is_number()) context.check_memory(element.span, array.elements.bytes_of_slot());
      array.elements.set(place, std::move(value));
    }
    stream.accept_comma();
  }
  if (found != wanted) {
    context.fail(stream.span(), fmt::format("this dimension of the array has {} elements, found {} initialiser{}",
                                            wanted, found, found == 1 ? "" : "s"));
  }
}

/// The elements of an array without a size, in the order of the list.
void fill(ElementStream& stream, ArrayValue& array) {
  Context& context = stream.context();
  while (!stream.peek().is(ElementKind::end)) {
    const SourceSpan span = stream.peek().span;
    Value value = read_rvalue(stream);
    check_container_depth(context, value, span);
    const std::size_t place = array.elements.size();
    context.check_memory(span, ArrayElements::bytes_of(1) + array.elements.bytes_of_slot());
    array.grow(place + 1);
    array.elements.set(place, std::move(value));
    stream.accept_comma();
  }
}

std::size_t element_count(Context& context, const Node& node) {
  const double size = evaluate_number(context, node);
  if (!(size + kTolerance >= 1))
    context.fail(node.span, fmt::format("an array's size must be at least 1, found {:g}", size));
  if (size > 1e12) context.fail(node.span, fmt::format("an array of {:g} elements is too large", size));
  return static_cast<std::size_t>(size + kTolerance);
}

}  // namespace

namespace {

Value make_unsized(Context& context, const grammar::Array& node) {
  const auto array = make_shared_value<ArrayValue>(std::vector<std::size_t>{0}, context.scopes.slots(), context.memory);
  if (node.initialised) {
    ElementStream stream(context, node.items, node.span);
    fill(stream, *array);
    if (array->elements.size() == 0)
      context.fail(node.span, "an array without a size takes it from its values, found none",
                   "`array` alone, without braces, grows by use");
  }
  array->grows = !node.initialised;
  return {ValueKind::array, array};
}

}  // namespace

Value make_array(Context& context, const grammar::Array& node) {
  if (node.dimensions.empty()) return make_unsized(context, node);
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

}  // namespace isl::interpreter
