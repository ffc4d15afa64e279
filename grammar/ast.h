// The abstract syntax tree: the parser makes it and the evaluator walks it. Nodes live in an Arena (grammar/arena.h),
// are immutable once parsed, own nothing, and point into it. They know expressions, brackets and directives and no
// object: `sphere { … }` is a Block whose word happens to be `sphere`.
//
// A body is a sequence of *items*: elements (expressions, words, blocks, entries, arrays, functions), directives,
// commas and semicolons, in source order. Executing it yields a stream of evaluated elements
// (interpreter/element_stream.h).
#pragma once

#include "base/source_span.h"
#include "grammar/complaint.h"
#include "grammar/symbols.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace isl::grammar {

enum class NodeKind : std::uint8_t {
  // Expressions.
  number,
  string,
  constant,
  name,
  scoped_name,
  index,
  call,
  function_call,
  dot,
  vector,
  unary,
  binary,
  conditional,
  // Other elements.
  word,
  block,
  block_begin,
  block_end,
  entry,
  field,
  array,
  function,
  dictionary,
  tuple,
  comma,
  semicolon,
  // Directives.
  declare,
  declare_deprecated,
  declare_newer_word,
  declare_tuple,
  undef,
  if_,
  ifdef,
  while_,
  for_,
  switch_,
  break_,
  macro,
  include,
  version,
  default_,
  message,
  fopen,
  fclose,
  read,
  write,
  // A mistake in the text.
  error,
};

struct Node {
  NodeKind kind;
  SourceSpan span;
};

using Items = std::span<const Node* const>;

// ---- Expressions ----------------------------------------------------------------------------------------------------

struct Number : Node {
  double value;
};

/// `text` has its escapes resolved; `raw` is the text between the quotes (file names do not interpret escapes).
struct String : Node {
  std::string_view text;
  std::string_view raw;
};

/// A reserved word with a value: `x y z u v t pi clock on off yes no true false version tau …`.
struct Constant : Node {
  Symbol word;
};

/// An identifier: variable, macro (only as a callee), or one of our contextual words.
struct Name : Node {
  Symbol name;
};

/// `local.Name`, `global.Name`: the name in the innermost or in the outermost table.
enum class ScopeName : std::uint8_t { local, global };
struct ScopedName : Node {
  ScopeName scope;
  Symbol name;
};

/// `base[index]`: an array's element or a dictionary's value; base is a place (is_place).
struct Index : Node {
  const Node* base;
  const Node* subscript;
};

/// One actual argument: the items between commas; a lone place goes by reference. `(Q)` arrives as a Unary plus of Q,
/// so that it goes by value. An omitted argument of a macro is empty.
using Argument = Items;

/// `callee(a, b)`: a macro, a user function or a spline. The callee is a place.
struct Call : Node {
  const Node* callee;
  std::span<const Argument> arguments;
};

/// `sin(a)`: a built-in function, reserved.
struct FunctionCall : Node {
  Symbol function;
  std::span<const Argument> arguments;
};

/// `base.item`: x y z u v t red green blue filter transmit gray of a vector or colour, or any key of a dictionary.
struct Dot : Node {
  const Node* base;
  Symbol item;
};

/// `<a, b, …>`, one to five coordinates.
struct Vector : Node {
  std::span<const Node* const> coordinates;
};

enum class UnaryOp : std::uint8_t { plus, minus, logical_not };
/// `negative` is the value of a minus directly before a number literal (-1); null otherwise.
struct Unary : Node {
  UnaryOp op;
  const Node* operand;
  const double* negative;
};

enum class BinaryOp : std::uint8_t {
  add,
  subtract,
  multiply,
  divide,
  less,
  greater,
  equal,
  less_equal,
  greater_equal,
  not_equal,
  logical_and,
  logical_or,
};
struct Binary : Node {
  BinaryOp op;
  const Node* left;
  const Node* right;
  SourceSpan op_span;
};

/// `condition ? yes : no`; both arms are evaluated, as in POV-Ray.
struct Conditional : Node {
  const Node* condition;
  const Node* yes;
  const Node* no;
};

// ---- Other elements -------------------------------------------------------------------------------------------------

/// A reserved word that stands alone: `no_shadow`, `rgb`, `translate`, `sphere` without its brace …
struct Word : Node {
  Symbol word;
};

/// `word { items }`; with word == kNoSymbol a bare `{ items }`. The word may be an identifier (contextual words).
struct Block : Node {
  Symbol word;
  SourceSpan word_span;
  Items items;
};

/// `word {` whose brace is closed in another branch of an `#if` or `#switch`, or outside it: the block's items are what
/// is executed from here on until a `block_end`, a plain node.
struct BlockBegin : Node {
  Symbol word;
  SourceSpan word_span;
};

/// `[ items ]`, an entry of a map.
struct Entry : Node {
  Items items;
};

/// `after` is the item before it in its list; null if it is the first.
struct Semicolon : Node {
  const Node* after;
};

/// `array[2][3] { items }`. Without dimensions it takes its size from the items; without these too, it grows by use.
struct Array : Node {
  std::span<const Node* const> dimensions;
  bool initialised;
  Items items;
};

/// `function(a, b) { body }`. The body is one expression (precedence of its own, resolved by the parser) or one Block
/// (`pattern {}`, `pigment {}`, `transform {}`, `spline {}`, `internal(n)`); `function w, h { pattern }` keeps w and h
/// in `size`.
struct Function : Node {
  bool has_parameters;
  std::span<const Symbol> parameters;
  std::span<const Node* const> size;
  Items body;
};

/// `["key"]: value` or `.Name: value`, where the key is an Entry, or a Name that is not evaluated.
struct DictionaryField : Node {
  const Node* key;
  Items value;
};

/// `dictionary { items }`: its fields, and directives that yield fields.
struct Dictionary : Node {
  Items items;
};

/// `(a, b, …)`: at least one comma. A value may be missing: its items are empty.
struct Tuple : Node {
  std::span<const Items> values;
};

// ---- Directives -----------------------------------------------------------------------------------------------------

/// `once "remark"`; without a remark it is empty.
struct Deprecation {
  bool once;
  std::string_view remark;
};

/// `#declare target = value` / `#local`. `value` is one expression, block, array, function or directive; a run of
/// `texture {}` blocks; or a colour (`rgb <1,0,0>`, `color red 1 green .5`) as its words and expressions. Before it
/// there may be other declarations, with their semicolons.
/// A semicolon after it is an item of its own in the enclosing list.
/// `#declare deprecated once "remark" target = value` is a node of its own kind and of this type; so is a declaration
/// of a word of POV-Ray 3.8, which is one of a name before that version.
struct Declare : Node {
  bool local;
  Deprecation deprecation;
  const Node* target;
  Items value;
};

/// `#declare (A, optional B) = value`, where the value is a Tuple or yields one.
struct TupleField {
  const Node* target;
  bool optional;
};
struct DeclareTuple : Node {
  bool local;
  std::span<const TupleField> fields;
  Items value;
};

/// `#undef target`.
struct Undef : Node {
  const Node* target;
};

/// `#if (condition) then #else otherwise #end`; `#elseif` is a nested If in `otherwise`.
struct If : Node {
  const Node* condition;
  Items then;
  Items otherwise;
};

/// `#ifdef (target)`, with `negated` for `#ifndef`.
struct Ifdef : Node {
  bool negated;
  const Node* target;
  Items then;
  Items otherwise;
};

struct While : Node {
  const Node* condition;
  Items body;
};

/// `#for (variable, start, end, step)`; step may be null (1).
struct For : Node {
  Symbol variable;
  const Node* start;
  const Node* end;
  const Node* step;
  Items body;
};

/// A `#case (low)` (high is null) or a `#range (low, high)`. Cases fall through, as in C.
struct SwitchCase {
  SourceSpan span;
  const Node* low;
  const Node* high;
  Items body;
};
struct Switch : Node {
  const Node* subject;
  std::span<const SwitchCase> cases;
  bool has_default;
  Items otherwise;
};

struct Break : Node {};

struct Parameter {
  Symbol name;
  bool optional = false;  ///< a call may omit its argument
};
struct Macro : Node {
  Symbol name;
  SourceSpan name_span;
  std::span<const Parameter> parameters;
  Items body;
};

struct Include : Node {
  const Node* path;
};

struct Version : Node {
  const Node* value;
};

/// `#default { texture {} … }`.
struct Default : Node {
  Items items;
};

enum class MessageKind : std::uint8_t { debug, warning, error };
struct Message : Node {
  MessageKind level;
  const Node* text;
};

/// `#fopen handle path read|write|append`.
struct Fopen : Node {
  Symbol handle;
  const Node* path;
  Symbol mode;
};
struct Fclose : Node {
  Symbol handle;
};
struct Read : Node {
  Symbol handle;
  std::span<const Argument> targets;
};
struct Write : Node {
  Symbol handle;
  std::span<const Argument> values;
};

/// A mistake in the text: an error or a warning that is reported when execution reaches it. `complaint` is null if it
/// is reported elsewhere. With `gives_up`, the node replaces text that could not be parsed, and its statement ends
/// there; otherwise the node stands before the item that it is about.
struct Error : Node {
  const Complaint* complaint;
  bool gives_up;
};

/// True for what a declaration may write to and a macro may get by reference, as far as the text tells: an item of a
/// vector looks like the value of a dictionary.
[[nodiscard]] inline bool is_place(const Node& node) {
  return node.kind == NodeKind::name || node.kind == NodeKind::scoped_name || node.kind == NodeKind::index ||
         node.kind == NodeKind::dot;
}

/// A checked downcast; the caller must have looked at the kind.
template <class T>
[[nodiscard]] const T& as(const Node& node) {
  return static_cast<const T&>(node);
}

}  // namespace isl::grammar
