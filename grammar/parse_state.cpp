#include "grammar/parse_state.h"

#include "grammar/syntax_messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace isl::grammar {
namespace {

/// Larger than every offset.
constexpr std::uint32_t kEndOfTexts = std::numeric_limits<std::uint32_t>::max();

/// Links the complaints, so that execution of the first one reports the others.
void link(std::span<Complaint* const> complaints) {
  for (std::size_t i = 0; i + 1 < complaints.size(); ++i) complaints[i]->next = complaints[i + 1];
}

std::uint32_t highest(std::initializer_list<std::uint32_t> heights) { return std::max(heights); }

}  // namespace

Tree ParseState::too_high(SourceSpan span) {
  // One complaint is enough: the tree around it is too high as well, and its node hides the inner one.
  const bool is_known = !too_high_.empty() && span.begin <= too_high_.begin && too_high_.end <= span.end;
  too_high_ = span;
  if (!is_known) {
    too_high_complaint_ =
        complaints_.error(span, fmt::format("more than {} nested operations and brackets", max_height_),
                          "declare parts of the expression first");
  }
  // An error node is a leaf: the height limit does not apply.
  return {arena_.create(Error{{NodeKind::error, span}, too_high_complaint_, true}), 1};
}

Tree ParseState::string(SourceSpan span, TextLiteral literal) {
  return make<String>(NodeKind::string, span, 0, literal.text, literal.raw);
}

Tree ParseState::index(SourceSpan span, Tree base, Tree subscript) {
  return make<Index>(NodeKind::index, span, highest({base.height, subscript.height}), base.node, subscript.node);
}

Tree ParseState::call(SourceSpan span, Tree callee, const ArgumentList& arguments) {
  return make<Call>(NodeKind::call, span, highest({callee.height, arguments.height}), callee.node,
                    arena_.copy(arguments.arguments));
}

Tree ParseState::function_call(SourceSpan span, Symbol function, const ArgumentList& arguments) {
  if (const Tree mistake = omitted(span, arguments.arguments); mistake.node) return mistake;
  return make<FunctionCall>(NodeKind::function_call, span, arguments.height, function,
                            arena_.copy(arguments.arguments));
}

Tree ParseState::vector(SourceSpan span, const TreeList& coordinates) {
  return make<Vector>(NodeKind::vector, span, coordinates.height, arena_.copy(coordinates.nodes));
}

Tree ParseState::unary(SourceSpan span, UnaryOp op, Tree operand) {
  const bool is_negative = op == UnaryOp::minus && operand.node->kind == NodeKind::number;
  const double* const negative = is_negative ? arena_.create(-as<Number>(*operand.node).value) : nullptr;
  return make<Unary>(NodeKind::unary, span, operand.height, op, operand.node, negative);
}

Tree ParseState::binary(SourceSpan span, BinaryOp op, SourceSpan op_span, Tree left, Tree right) {
  return make<Binary>(NodeKind::binary, span, highest({left.height, right.height}), op, left.node, right.node, op_span);
}

Tree ParseState::conditional(std::uint32_t end, const ChoiceList& choices, Tree no) {
  for (auto choice = choices.rbegin(); choice != choices.rend(); ++choice) {
    const auto& [begin, condition, yes] = *choice;
    no = make<Conditional>(NodeKind::conditional, {begin, end}, highest({condition.height, yes.height, no.height}),
                           condition.node, yes.node, no.node);
  }
  return no;
}

Tree ParseState::parenthesised(SourceSpan span, Tree condition) {
  const NodeKind kind = condition.node->kind;
  const bool is_variable = kind == NodeKind::name || kind == NodeKind::index || kind == NodeKind::scoped_name;
  return is_variable ? unary(span, UnaryOp::plus, condition) : condition;
}

Tree ParseState::block(SourceSpan span, Symbol word, SourceSpan word_span, const TreeList& items) {
  return make<Block>(NodeKind::block, span, items.height, word, word_span, arena_.copy(items.nodes));
}

Tree ParseState::entry(SourceSpan span, const TreeList& items) {
  return make<Entry>(NodeKind::entry, span, items.height, arena_.copy(items.nodes));
}

Tree ParseState::array(SourceSpan span, const TreeList& dimensions, bool initialised, const TreeList& items) {
  return make<Array>(NodeKind::array, span, highest({dimensions.height, items.height}), arena_.copy(dimensions.nodes),
                     initialised, arena_.copy(items.nodes));
}

Tree ParseState::dictionary(SourceSpan span, const TreeList& items) {
  return make<Dictionary>(NodeKind::dictionary, span, items.height, arena_.copy(items.nodes));
}

Tree ParseState::field(SourceSpan span, Tree key, const TreeList& value) {
  return make<DictionaryField>(NodeKind::field, span, highest({key.height, value.height}), key.node,
                               arena_.copy(value.nodes));
}

Tree ParseState::tuple(SourceSpan span, const ArgumentList& values) {
  return make<Tuple>(NodeKind::tuple, span, values.height, arena_.copy(values.arguments));
}

Tree ParseState::function(SourceSpan span, const FunctionHead& head, const TreeList& body) {
  if (head.mistake.node) return head.mistake;
  return make<Function>(NodeKind::function, span, body.height, true, arena_.copy(head.parameters),
                        std::span<const Node* const>(), arena_.copy(body.nodes));
}

Tree ParseState::function(SourceSpan span, const TreeList& size, const TreeList& body) {
  return make<Function>(NodeKind::function, span, body.height, false, std::span<const Symbol>(),
                        arena_.copy(size.nodes), arena_.copy(body.nodes));
}

Tree ParseState::declare(SourceSpan span, bool local, Tree target, const TreeList& value) {
  const bool is_newer = target.node->kind == NodeKind::name && is_newer_word(as<Name>(*target.node).name);
  return make<Declare>(is_newer ? NodeKind::declare_newer_word : NodeKind::declare, span,
                       highest({target.height, value.height}), local, Deprecation{}, target.node,
                       arena_.copy(value.nodes));
}

Tree ParseState::declare_deprecated(SourceSpan span, bool local, Deprecation deprecation, Tree target,
                                    const TreeList& value) {
  return make<Declare>(NodeKind::declare_deprecated, span, highest({target.height, value.height}), local, deprecation,
                       target.node, arena_.copy(value.nodes));
}

Tree ParseState::declare_tuple(SourceSpan span, bool local, const TupleFieldList& fields, const TreeList& value) {
  if (fields.mistake.node) return fields.mistake;
  return make<DeclareTuple>(NodeKind::declare_tuple, span, highest({fields.height, value.height}), local,
                            arena_.copy(fields.fields), arena_.copy(value.nodes));
}

TupleFieldTree ParseState::optional_field(Symbol word, SourceSpan word_span, Tree target) {
  if (word == newer_word::kw_optional) return {{target.node, true}, target.height};
  return tuple_field(mistake(word_span, complaints_.error(word_span, "expected `,` or `)` after this identifier",
                                                          "only the word `optional` may precede a name here")));
}

Tree ParseState::if_(SourceSpan span, Tree condition, const TreeList& then, const TreeList& otherwise) {
  return make<If>(NodeKind::if_, span, highest({condition.height, then.height, otherwise.height}), condition.node,
                  arena_.copy(then.nodes), arena_.copy(otherwise.nodes));
}

Tree ParseState::ifdef(SourceSpan span, bool negated, Tree target, const TreeList& then, const TreeList& otherwise) {
  return make<Ifdef>(NodeKind::ifdef, span, highest({target.height, then.height, otherwise.height}), negated,
                     target.node, arena_.copy(then.nodes), arena_.copy(otherwise.nodes));
}

Tree ParseState::while_(SourceSpan span, Tree condition, const TreeList& body) {
  return make<While>(NodeKind::while_, span, highest({condition.height, body.height}), condition.node,
                     arena_.copy(body.nodes));
}

Tree ParseState::for_(SourceSpan span, Symbol variable, Tree start, Tree end, Tree step, const TreeList& body) {
  return make<For>(NodeKind::for_, span, highest({start.height, end.height, step.height, body.height}), variable,
                   start.node, end.node, step.node, arena_.copy(body.nodes));
}

Tree ParseState::switch_(SourceSpan span, Tree subject, const TreeList& before, const CaseList& cases, bool has_default,
                         const TreeList& otherwise) {
  if (!before.nodes.empty()) {
    return mistake(span, complaints_.error(before.nodes.front()->span,
                                           "expected `#case`, `#range` or `#end` after the parenthesis of `#switch`"));
  }
  return make<Switch>(NodeKind::switch_, span, highest({subject.height, cases.height, otherwise.height}), subject.node,
                      arena_.copy(cases.cases), has_default, arena_.copy(otherwise.nodes));
}

Tree ParseState::macro(SourceSpan span, Symbol name, SourceSpan name_span, const ParameterList& parameters,
                       const TreeList& body) {
  return make<Macro>(NodeKind::macro, span, body.height, name, name_span, arena_.copy(parameters),
                     arena_.copy(body.nodes));
}

Tree ParseState::default_(SourceSpan span, const TreeList& items) {
  return make<Default>(NodeKind::default_, span, items.height, arena_.copy(items.nodes));
}

Tree ParseState::message(SourceSpan span, MessageKind level, Tree text) {
  return make<Message>(NodeKind::message, span, text.height, level, text.node);
}

Tree ParseState::fopen(SourceSpan span, Symbol handle, Tree path, Symbol mode) {
  return make<Fopen>(NodeKind::fopen, span, path.height, handle, path.node, mode);
}

namespace {

/// The list without the comma that may follow the handle of an open file.
void drop_comma(ArgumentList& list) {
  if (!list.arguments.empty() && list.arguments.front().empty()) list.arguments.erase(list.arguments.begin());
}

}  // namespace

Tree ParseState::read(SourceSpan span, Symbol handle, ArgumentList targets) {
  drop_comma(targets);
  if (const Tree mistake = omitted(span, targets.arguments); mistake.node) return mistake;
  return make<Read>(NodeKind::read, span, targets.height, handle, arena_.copy(targets.arguments));
}

Tree ParseState::write(SourceSpan span, Symbol handle, ArgumentList values) {
  drop_comma(values);
  if (const Tree mistake = omitted(span, values.arguments); mistake.node) return mistake;
  return make<Write>(NodeKind::write, span, values.height, handle, arena_.copy(values.arguments));
}

TreeList ParseState::pair(Tree first, Tree second) {
  TreeList list;
  list.push(first);
  list.push(second);
  return list;
}

Tree ParseState::sequence(SourceSpan span, TreeList statements, Tree value) {
  statements.push(value);
  return if_(span, number(span, 1), statements, {});
}

TreeList ParseState::join(Tree first, const TreeList& rest) {
  TreeList list;
  list.push(first);
  list.nodes.insert(list.nodes.end(), rest.nodes.begin(), rest.nodes.end());
  list.height = std::max(list.height, rest.height);
  return list;
}

TreeList ParseState::join(Tree first, SourceSpan semicolon, const TreeList& rest) {
  TreeList list;
  list.push(first);
  const Tree second = this->semicolon(semicolon, list);
  return join(first, join(second, rest));
}

ArgumentList ParseState::with_argument(ArgumentList list, const TreeList& argument) {
  list.arguments.push_back(arena_.copy(argument.nodes));
  list.height = std::max(list.height, argument.height);
  return list;
}

ArgumentList ParseState::with_omitted(ArgumentList list, std::size_t count) {
  list.arguments.resize(list.arguments.size() + count);
  return list;
}

ParameterList ParseState::with_parameter(ParameterList list, Symbol name) {
  const bool is_optional = list.back().name == newer_word::kw_optional && !list.back().optional;
  if (is_optional) list.pop_back();
  list.push_back({name, is_optional});
  return list;
}

CaseList ParseState::with_case(CaseList list, SourceSpan span, SourceSpan clause, Tree low, Tree high, TreeList body) {
  body = part(std::move(body), {clause.end, kEndOfTexts});
  // A mistake in the parenthesis is reported when the value is compared with it.
  for (const Complaint* complaint : complaints_.claim({span.begin, clause.end}).unclaimed) {
    if (complaint->is_error()) low = error(complaint->diagnostic.span, complaint, true);
  }
  list.cases.push_back({span, low.node, high.node, arena_.copy(body.nodes)});
  list.height = highest({list.height, low.height, high.height, body.height});
  return list;
}

// ---- Mistakes -------------------------------------------------------------------------------------------------------

Tree ParseState::mistake(SourceSpan span, const Complaint* complaint) {
  if (complaint) complaints_.claim(*complaint);
  return error(span, complaint, true);
}

Tree ParseState::omitted(SourceSpan span, std::span<const Argument> arguments) {
  if (std::ranges::none_of(arguments, [](const Argument& argument) { return argument.empty(); })) return {};
  return mistake(span,
                 complaints_.error(span, "a value is missing before a comma",
                                   "only calls of macros may leave out arguments: those of `optional` parameters"));
}

ArgumentList ParseState::mistaken_argument(SourceSpan span, const Complaint* complaint) {
  TreeList argument;
  argument.push(mistake(span, complaint));
  return with_argument({}, argument);
}

TreeList ParseState::part(TreeList items, SourceSpan range) {
  const Complaints::Part part = complaints_.claim(range);
  if (part.all.empty()) return items;
  link(part.all);
  return merge(items, part.unclaimed);
}

/// The items, each preceded by those complaints about it that no node represents.
TreeList ParseState::merge(const TreeList& items, std::span<Complaint* const> complaints) {
  TreeList merged;
  merged.height = items.height;
  auto item = items.nodes.begin();
  for (const Complaint* complaint : complaints) {
    const SourceSpan place = complaint->diagnostic.span;
    for (; item != items.nodes.end() && (*item)->span.end <= place.begin; ++item) merged.nodes.push_back(*item);
    merged.push(error(place, complaint, false));
  }
  merged.nodes.insert(merged.nodes.end(), item, items.nodes.end());
  return merged;
}

void ParseState::finish(const TreeList& items) {
  const Complaints::Part part = complaints_.claim({0, kEndOfTexts});
  // After a mistake, execution goes on with the next statement: only mistakes in the same statement are linked to it.
  std::span<Complaint* const> left = part.all;
  for (const Node* item : items.nodes) {
    const auto is_of_item = [&](const Complaint* complaint) {
      return complaint->diagnostic.span.begin <= item->span.end;
    };
    const auto count = static_cast<std::size_t>(std::ranges::partition_point(left, is_of_item) - left.begin());
    link(left.first(count));
    left = left.subspan(count);
  }
  TreeList all = merge(items, part.unclaimed);
  for (const Complaint* complaint : complaints_.certain())
    all.push(error(complaint->diagnostic.span, complaint, false));
  items_ = arena_.copy(all.nodes);
}

void ParseState::abandon(SourceSpan text) {
  if (complaints_.outside().empty()) failure(text, "this text cannot be parsed to its end");
  TreeList all;
  for (const auto& complaints : {complaints_.outside(), complaints_.certain()}) {
    for (const Complaint* complaint : complaints) all.push(error(complaint->diagnostic.span, complaint, false));
  }
  items_ = arena_.copy(all.nodes);
}

bool ParseState::wants_syntax_error() {
  found_ = nullptr;
  return !complaints_.has_enough_errors();
}

void ParseState::syntax_error(Parser::symbol_kind_type found, SourceSpan span,
                              std::span<const Parser::symbol_kind_type> expected) {
  SyntaxMessage text = syntax_message(found, map_.text(span), expected);
  found_ = complaints_.error(span, std::move(text.message), std::move(text.hint));
}

}  // namespace isl::grammar
