// A body as a stream of elements. The AST of a body holds directives, loops and macro calls among its elements; this
// pull machine follows them in order, on the explicit stack Context::frames, and yields the elements: values (not yet
// evaluated), words, blocks, entries, commas. So a macro may yield half an argument list, three modifiers or several
// objects, and the readers of constructs (readers/) need not know which text an element came from.
//
// A block whose `}` stands in another branch of an `#if` is no list of items (grammar/parted_braces.h). Its stream goes
// on with the frames of the stream around it until the `}` is executed; if the block is a declared value, `#declare A =
// union {`, these are the frames around the declaration.
#pragma once

#include "grammar/ast.h"
#include "interpreter/context.h"
#include "interpreter/nesting.h"

namespace isl::interpreter {

enum class ElementKind : std::uint8_t {
  end,
  value,    ///< an expression, array or function; evaluated by take_value()
  unknown,  ///< an undeclared name (or a call of one): a contextual word, or a mistake
  word,     ///< a reserved word that stands alone
  block,    ///< `word { items }`, or `word {` alone whose items follow in the stream that yielded it
  entry,    ///< `[ items ]`
  field,    ///< `.Name: value` or `["key"]: value`
  comma,
  semicolon,
};

struct Element {
  ElementKind kind = ElementKind::end;
  grammar::Symbol word = grammar::kNoSymbol;  ///< word, block, unknown; and value if it is a plain name
  SourceSpan span = {};
  SourceSpan word_span = {};            ///< block: its word
  const grammar::Node* node = nullptr;  ///< value and unknown: the expression
  grammar::Items items = {};            ///< block and entry
  std::size_t opened_in = kClosed;      ///< block without its `}`: index of the bottom frame whose items may close it

  static constexpr std::size_t kClosed = SIZE_MAX;

  [[nodiscard]] bool is(ElementKind k) const { return kind == k; }
  [[nodiscard]] bool is_word(grammar::Symbol w) const { return kind == ElementKind::word && word == w; }
  [[nodiscard]] bool is_block(grammar::Symbol w) const { return kind == ElementKind::block && word == w; }
};

class ElementStream {
 public:
  /// A stream over the body of a block that was yielded as an element.
  ElementStream(Context& context, const Element& block);
  /// A stream over the items of a value: a declaration's right side, an argument. `span` is the place of the error if
  /// they yield nothing.
  ElementStream(Context& context, grammar::Items items, SourceSpan span);
  /// A stream over the elements that a macro call yields.
  ElementStream(Context& context, const grammar::Call& call, const MacroValue& macro);
  /// Ends every frame that the stream opened.
  ~ElementStream();
  ElementStream(const ElementStream&) = delete;
  ElementStream& operator=(const ElementStream&) = delete;

  /// The next element, without consuming it; Kind::end for ever after the last.
  [[nodiscard]] const Element& peek() {
    if (!ready_) advance();
    return element_;
  }
  Element take() {
    const Element element = peek();
    ready_ = element_.kind == ElementKind::end;
    return element;
  }
  void drop() {
    static_cast<void>(peek());
    ready_ = element_.kind == ElementKind::end;
  }
  /// Consumes and evaluates the next element, which is a value.
  Value take_value();
  bool accept(ElementKind kind) {
    if (peek().kind != kind) return false;
    drop();
    return true;
  }
  bool accept_comma() { return accept(ElementKind::comma); }

  /// Takes all elements up to the end, and executes the directives among them.
  void skip_rest();

  /// Called after an error: gives up the loops and macro calls in progress, down to the innermost file, and goes on
  /// there.
  void recover();

  [[nodiscard]] Context& context() const { return context_; }
  /// The construct that is being read, for messages (kNoSymbol for a value or file).
  [[nodiscard]] grammar::Symbol word() const { return word_; }
  [[nodiscard]] SourceSpan span() const { return span_; }

 private:
  void advance();
  bool finish_frame();
  void begin_block(const grammar::BlockBegin& node);
  void end_block(const grammar::Node& node);
  void end(SourceSpan span);
  void leave_outer_frame();
  /// `#if (A) merge #else union #end { … }`: the word that ends a branch, which is the present element, names the block
  /// behind the directive; in a declaration, the block behind the declaration.
  void take_block_behind();
  void take_call(const grammar::Call& call);
  void yield(ElementKind kind, const grammar::Node& node, grammar::Symbol word = grammar::kNoSymbol);

  Context& context_;
  NestingGuard nesting_;
  std::size_t base_;          ///< index of the stream's bottom frame; of an open block, that of the stream around it
  std::size_t outer_base_;    ///< the bottom frame of the stream that was read before
  std::size_t own_from_ = 0;  ///< of an open block: index of the first frame that it began itself
  /// Items of an open block are those of the stream around it, up to a `block_end`.
  bool is_open_ = false;
  /// The value ended with an open block, which has taken over its frames.
  bool is_handed_over_ = false;
  grammar::Symbol word_ = grammar::kNoSymbol;
  SourceSpan span_;
  bool ready_ = false;
  Element element_;
};

}  // namespace isl::interpreter
