#include "interpreter/builtins/builtins.h"

#include "interpreter/arithmetic.h"
#include "interpreter/element_stream.h"
#include "interpreter/expressions.h"
#include "interpreter/operators.h"
#include "interpreter/places.h"
#include "interpreter/readers/words/rvalue.h"

#include <fmt/format.h>

#include <array>

namespace isl::interpreter {
namespace {

using grammar::as;
using grammar::Node;
using grammar::NodeKind;
namespace word = grammar::word;

using Table = std::array<const Builtin*, word::kReservedCount>;

Table make_table() {
  Table table{};
  for (const auto functions :
       {float_functions(), vector_functions(), object_functions(), string_functions(), time_functions()}) {
    for (const Builtin& function : functions) table[static_cast<std::uint32_t>(function.name)] = &function;
  }
  return table;
}

/// True if the argument is one expression with one value, without a macro call; most arguments are.
bool is_plain(const grammar::Argument& argument) {
  return argument.size() == 1 && argument[0]->kind < NodeKind::word && argument[0]->kind != NodeKind::call;
}

/// The values of a call's arguments, in order; a few of them are kept on the stack.
class ArgumentValues {
 public:
  ArgumentValues(Context& context, const grammar::FunctionCall& call) : context_(context) {
    for (const grammar::Argument& argument : call.arguments) read(argument, call.span);
  }

  [[nodiscard]] std::span<const Value> span() const {
    return many_.empty() ? std::span<const Value>(few_).first(count_) : std::span<const Value>(many_);
  }

 private:
  static constexpr std::size_t kFew = 3;

  void read(const grammar::Argument& argument, SourceSpan span) {
    if (is_plain(argument)) {
      if (count_ < kFew) return evaluate_into(context_, *argument[0], few_[count_++]);
      return push(evaluate(context_, *argument[0]));
    }
    // A macro may yield several arguments.
    ElementStream stream(context_, argument, span);
    while (!stream.peek().is(ElementKind::end)) {
      push(read_rvalue(stream));
      stream.accept_comma();
    }
  }

  void push(Value value) {
    if (count_ < kFew) {
      few_[count_] = std::move(value);
    } else {
      if (many_.empty()) many_.assign(few_.begin(), few_.end());
      many_.push_back(std::move(value));
    }
    ++count_;
  }

  Context& context_;
  std::size_t count_ = 0;
  std::array<Value, kFew> few_;
  std::vector<Value> many_;  ///< all of them, if they are more than kFew
};

std::string expected_count(const Builtin& function) {
  const std::size_t low = function.min_arguments, high = function.max_arguments;
  const auto plural = [](std::size_t n) { return n == 1 ? "" : "s"; };
  if (high == Builtin::kAnyNumber) return fmt::format("at least {} argument{}", low, plural(low));
  return low == high ? fmt::format("{} argument{}", low, plural(low)) : fmt::format("{} to {} arguments", low, high);
}

/// `defined`, `dimensions` and `dimension_size` ask about a name, whose value need not exist.
std::optional<Value> call_query(Context& context, const grammar::FunctionCall& call) {
  const auto index = static_cast<word::Index>(call.function);
  if (index != word::kIndex_defined && index != word::kIndex_dimensions && index != word::kIndex_dimension_size)
    return {};
  const bool has_name =
      !call.arguments.empty() && call.arguments[0].size() == 1 && grammar::is_place(*call.arguments[0][0]);
  const std::size_t wanted = index == word::kIndex_dimension_size ? 2 : 1;
  if (!has_name || call.arguments.size() != wanted || (wanted == 2 && call.arguments[1].size() != 1)) {
    context.fail(call.span, fmt::format("`{}` takes an identifier{}", context.text(call.function),
                                        wanted == 2 ? " and the number of a dimension" : ""));
  }
  const Node& name = *call.arguments[0][0];
  if (index == word::kIndex_defined) {
    const Slot* slot = find_slot_if_declared(context, name);
    return Value(slot && slot->value.kind() != ValueKind::none ? 1.0 : 0.0);
  }
  const Slot& slot = find_slot(context, name);
  if (slot.value.kind() == ValueKind::poison) throw Failed{};
  if (slot.value.kind() != ValueKind::array)
    context.fail(name.span, fmt::format("expected an array, found {}", describe(slot.value)));
  // The dimension's number may come from a macro that undeclares the array.
  const Value keep = slot.value;
  const ArrayValue& array = keep.as<ArrayValue>();
  const auto count = static_cast<double>(array.dimensions.size());
  if (index == word::kIndex_dimensions) return Value(count);
  const double dimension = evaluate_number(context, *call.arguments[1][0]);
  if (!(dimension >= 1 && dimension < count + 1)) return Value(0.0);
  return Value(static_cast<double>(array.dimensions[static_cast<std::size_t>(dimension) - 1]));
}

/// `result` may alias the arguments.
void apply(const Builtin& function, const Arguments& arguments, Value& result) {
  if (function.of_number) {
    result.set_number(function.of_number(arguments.number(0)));
  } else {
    result = function.general(arguments);
  }
}

[[gnu::noinline]] void call_list(Context& context, const grammar::FunctionCall& call, const Builtin& function,
                                 Value& result) {
  const ArgumentValues values(context, call);
  const std::size_t found = values.span().size();
  if (found < function.min_arguments || found > function.max_arguments) {
    context.fail(call.span,
                 fmt::format("`{}` takes {}, found {}", context.text(call.function), expected_count(function), found));
  }
  apply(function, Arguments(context, call, values.span()), result);
}

[[gnu::noinline]] void call_unlisted(Context& context, const grammar::FunctionCall& call, Value& result) {
  if (std::optional<Value> answer = call_query(context, call)) {
    result = *std::move(answer);
    return;
  }
  context.unsupported(call.span, context.text(call.function));
  throw Failed{};
}

}  // namespace

[[gnu::noinline]] void call_builtin(Context& context, const grammar::FunctionCall& call, Value& result) {
  static const Table kTable = make_table();
  const NestingGuard guard(context, call.span);
  const Builtin* function = kTable[static_cast<std::uint32_t>(call.function)];
  if (!function) return call_unlisted(context, call, result);
  // Most calls have one argument, and need no list of values.
  const bool is_single = call.arguments.size() == 1 && function->min_arguments == 1 && is_plain(call.arguments[0]);
  if (!is_single) return call_list(context, call, *function, result);
  evaluate_into(context, *call.arguments[0][0], result);
  apply(*function, Arguments(context, call, {&result, 1}), result);
}

// ---- Arguments ------------------------------------------------------------------------------------------------------

SourceSpan Arguments::span(std::size_t i) const {
  if (i >= call_.arguments.size() || call_.arguments[i].empty()) return call_.span;
  return join(call_.arguments[i].front()->span, call_.arguments[i].back()->span);
}

const grammar::Node* Arguments::expression(std::size_t i) const {
  if (i >= call_.arguments.size() || call_.arguments[i].size() != 1) return nullptr;
  return call_.arguments[i].front();
}

void Arguments::fail(std::size_t i, std::string message) const {
  context_.fail(span(i), fmt::format("`{}`: {}", context_.text(call_.function), message));
}

double Arguments::number(std::size_t i) const {
  if (!values_[i].is_number()) [[unlikely]]
    fail(i, fmt::format("expected a number, found {}", describe(values_[i])));
  return values_[i].number();
}

scene::Vec3 Arguments::vector(std::size_t i) const {
  if (!values_[i].is_numeric()) [[unlikely]]
    fail(i, fmt::format("expected a vector, found {}", describe(values_[i])));
  const Value::Terms& terms = values_[i].terms();
  return values_[i].is_number() ? scene::Vec3(terms[0]) : scene::Vec3(terms[0], terms[1], terms[2]);
}

const std::string& Arguments::string(std::size_t i) const {
  const Value& value = values_[i];
  if (value.kind() != ValueKind::string) {
    context_.fail(span(i),
                  fmt::format("`{}`: expected a string, found {}", context_.text(call_.function), describe(value)),
                  value.is_number()    ? "`str(…, 0, -1)` converts a number to a string"
                  : value.is_numeric() ? "`vstr(3, …, \", \", 0, -1)` converts a vector to a string"
                                       : "");
  }
  return value.as<StringValue>().text;
}

int Arguments::integer(std::size_t i, int low, int high) const {
  const double value = number(i);
  if (!(value > low - 1.0 && value < high + 1.0))
    fail(i, fmt::format("expected {} to {}, found {:g}", low, high, value));
  return static_cast<int>(value);
}

Slot& Arguments::variable(std::size_t i) const {
  const bool is_alone = i < call_.arguments.size() && call_.arguments[i].size() == 1;
  const NodeKind kind = is_alone ? call_.arguments[i][0]->kind : NodeKind::error;
  if (kind != NodeKind::name && kind != NodeKind::index && kind != NodeKind::scoped_name)
    fail(i, "expected the name of a variable");
  return find_slot(context_, *call_.arguments[i][0]);
}

}  // namespace isl::interpreter
