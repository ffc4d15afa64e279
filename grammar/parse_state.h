// Makes the nodes for the grammar's rules, and keeps the result. There is one per parse; the rules in parser.yy call it
// and decide nothing themselves. It knows the shapes of ast.h and no text.
#pragma once

#include "base/diagnostic.h"
#include "grammar/arena.h"
#include "grammar/ast.h"
#include "grammar/complaints.h"
#include "grammar/parse_values.h"
#include "grammar/parser.hh"
#include "grammar/source_map.h"
#include "grammar/text_literal.h"

#include <cstdint>
#include <span>
#include <string>
#include <utility>

namespace isl::grammar {

class ParseState {
 public:
  /// Trees higher than `max_height` are errors.
  ParseState(const SourceMap& map, Arena& arena, Complaints& complaints, std::uint32_t max_height)
      : map_(map), arena_(arena), complaints_(complaints), max_height_(max_height) {}

  void finish(const TreeList& items);
  /// Called when the parser cannot recover from a mistake: only the complaints are left of the text.
  void abandon(SourceSpan text);
  [[nodiscard]] Items items() const { return items_; }

  // Expressions.
  Tree number(SourceSpan span, double value) { return make<Number>(NodeKind::number, span, 0, value); }
  Tree string(SourceSpan span, TextLiteral literal);
  Tree constant(SourceSpan span, Symbol word) { return make<Constant>(NodeKind::constant, span, 0, word); }
  Tree name(SourceSpan span, Symbol name) { return make<Name>(NodeKind::name, span, 0, name); }
  Tree scoped_name(SourceSpan span, ScopeName scope, Symbol name) {
    return make<ScopedName>(NodeKind::scoped_name, span, 0, scope, name);
  }
  Tree index(SourceSpan span, Tree base, Tree subscript);
  Tree call(SourceSpan span, Tree callee, const ArgumentList& arguments);
  Tree function_call(SourceSpan span, Symbol function, const ArgumentList& arguments);
  Tree dot(SourceSpan span, Tree base, Symbol item) {
    return make<Dot>(NodeKind::dot, span, base.height, base.node, item);
  }
  Tree vector(SourceSpan span, const TreeList& coordinates);
  Tree unary(SourceSpan span, UnaryOp op, Tree operand);
  Tree binary(SourceSpan span, BinaryOp op, SourceSpan op_span, Tree left, Tree right);
  /// Each choice stands in the `no` of the one before; the text ends at `end`.
  Tree conditional(std::uint32_t end, const ChoiceList& choices, Tree no);
  /// The condition itself, except that a lone variable becomes a value (ast.h, Argument).
  Tree parenthesised(SourceSpan span, Tree condition);

  // Other elements.
  Tree word(SourceSpan span, Symbol word) { return make<Word>(NodeKind::word, span, 0, word); }
  Tree block(SourceSpan span, Symbol word, SourceSpan word_span, const TreeList& items);
  Tree entry(SourceSpan span, const TreeList& items);
  Tree array(SourceSpan span, const TreeList& dimensions, bool initialised, const TreeList& items);
  Tree function(SourceSpan span, const FunctionHead& head, const TreeList& body);
  Tree function(SourceSpan span, const TreeList& size, const TreeList& body);
  Tree dictionary(SourceSpan span, const TreeList& items);
  Tree field(SourceSpan span, Tree key, const TreeList& value);
  Tree tuple(SourceSpan span, const ArgumentList& values);
  Tree block_begin(SourceSpan span, Symbol word, SourceSpan word_span) {
    return make<BlockBegin>(NodeKind::block_begin, span, 0, word, word_span);
  }
  Tree block_end(SourceSpan span) { return mark(NodeKind::block_end, span); }
  Tree comma(SourceSpan span) { return mark(NodeKind::comma, span); }
  /// The semicolon that follows these items.
  Tree semicolon(SourceSpan span, const TreeList& before) {
    return make<Semicolon>(NodeKind::semicolon, span, 0, before.nodes.empty() ? nullptr : before.nodes.back());
  }

  // Directives.
  Tree declare(SourceSpan span, bool local, Tree target, const TreeList& value);
  Tree declare_deprecated(SourceSpan span, bool local, Deprecation deprecation, Tree target, const TreeList& value);
  Tree declare_tuple(SourceSpan span, bool local, const TupleFieldList& fields, const TreeList& value);
  TupleFieldTree tuple_field(Tree target) { return {{target.node, false}, target.height}; }
  /// The field is written with a word before it.
  TupleFieldTree optional_field(Symbol word, SourceSpan word_span, Tree target);
  Tree undef(SourceSpan span, Tree target) { return make<Undef>(NodeKind::undef, span, target.height, target.node); }
  Tree if_(SourceSpan span, Tree condition, const TreeList& then, const TreeList& otherwise);
  Tree ifdef(SourceSpan span, bool negated, Tree target, const TreeList& then, const TreeList& otherwise);
  Tree while_(SourceSpan span, Tree condition, const TreeList& body);
  Tree for_(SourceSpan span, Symbol variable, Tree start, Tree end, Tree step, const TreeList& body);
  Tree switch_(SourceSpan span, Tree subject, const TreeList& before, const CaseList& cases, bool has_default,
               const TreeList& otherwise);
  Tree break_(SourceSpan span) { return make<Break>(NodeKind::break_, span, 0); }
  Tree macro(SourceSpan span, Symbol name, SourceSpan name_span, const ParameterList& parameters, const TreeList& body);
  Tree include(SourceSpan span, Tree path) { return make<Include>(NodeKind::include, span, path.height, path.node); }
  Tree version(SourceSpan span, Tree value) { return make<Version>(NodeKind::version, span, value.height, value.node); }
  Tree default_(SourceSpan span, const TreeList& items);
  Tree message(SourceSpan span, MessageKind level, Tree text);
  Tree fopen(SourceSpan span, Symbol handle, Tree path, Symbol mode);
  Tree fclose(SourceSpan span, Symbol handle) { return make<Fclose>(NodeKind::fclose, span, 0, handle); }
  // The list begins with an omitted argument if a comma follows the handle.
  Tree read(SourceSpan span, Symbol handle, ArgumentList targets);
  Tree write(SourceSpan span, Symbol handle, ArgumentList values);

  // Lists.
  TreeList pair(Tree first, Tree second);
  /// A value after statements: a branch that is always taken.
  Tree sequence(SourceSpan span, TreeList statements, Tree value);
  TreeList join(Tree first, const TreeList& rest);
  /// `first`, a semicolon and the rest.
  TreeList join(Tree first, SourceSpan semicolon, const TreeList& rest);
  ArgumentList with_argument(ArgumentList list, const TreeList& argument);
  /// Arguments that a call leaves out.
  ArgumentList with_omitted(ArgumentList list, std::size_t count);
  /// A parameter that follows the one before without a comma, which may be the word `optional`.
  ParameterList with_parameter(ParameterList list, Symbol name);
  /// `clause` is the parenthesis, or the token that ends it.
  CaseList with_case(CaseList list, SourceSpan span, SourceSpan clause, Tree low, Tree high, TreeList body);

  // Mistakes.
  /// Takes the complaint about the mistake that was found last; null if there is none.
  [[nodiscard]] const Complaint* found() { return std::exchange(found_, nullptr); }
  /// The node that represents a mistake.
  Tree mistake(SourceSpan span, const Complaint* complaint);
  ArgumentList mistaken_argument(SourceSpan span, const Complaint* complaint);
  Tree unclosed(SourceSpan span, const Complaint* complaint) { return mistake(span, complaint); }
  /// The items of a text that is executed as a whole or not at all, each preceded by the complaints about it.
  TreeList part(TreeList items, SourceSpan range);
  /// False if no more errors are kept.
  [[nodiscard]] bool wants_syntax_error();
  void syntax_error(Parser::symbol_kind_type found, SourceSpan span,
                    std::span<const Parser::symbol_kind_type> expected);
  /// The parser has met a mistake that the token stream reported; null if that is reported elsewhere, or needs no
  /// message.
  void known_error(const Complaint* complaint) { found_ = complaint; }
  /// Reports a mistake that the parser itself cannot recover from.
  void failure(SourceSpan span, const std::string& message) {
    complaints_.report_certain({Severity::error, span, message, {}, {}, {}});
  }

 private:
  /// A node above children of at most the given height.
  template <class T, class... Fields>
  Tree make(NodeKind kind, SourceSpan span, std::uint32_t children_height, Fields... fields) {
    if (children_height >= max_height_) return too_high(span);
    return {arena_.create(T{{kind, span}, fields...}), children_height + 1};
  }
  /// A node without fields: only its kind.
  Tree mark(NodeKind kind, SourceSpan span) { return {arena_.create(Node{kind, span}), 1}; }
  Tree too_high(SourceSpan span);

  /// The node of the mistake if an argument of a list that needs all of them is left out.
  Tree omitted(SourceSpan span, std::span<const Argument> arguments);
  TreeList merge(const TreeList& items, std::span<Complaint* const> complaints);
  Tree error(SourceSpan span, const Complaint* complaint, bool gives_up) {
    return make<Error>(NodeKind::error, span, 0, complaint, gives_up);
  }

  const SourceMap& map_;
  Arena& arena_;
  Complaints& complaints_;
  std::uint32_t max_height_;
  SourceSpan too_high_;  ///< the last tree that was reported as too high
  const Complaint* too_high_complaint_ = nullptr;
  const Complaint* found_ = nullptr;  ///< the mistake found last, until a node represents it
  Items items_;
};

}  // namespace isl::grammar
