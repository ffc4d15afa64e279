#include "interpreter/element_stream.h"

#include "interpreter/control.h"
#include "interpreter/directives.h"
#include "interpreter/expressions.h"
#include "interpreter/macro_calls.h"
#include "interpreter/newer_words.h"
#include "interpreter/routines/routine.h"
#include "interpreter/routines/routines.h"
#include "interpreter/spare_semicolons.h"

#include <algorithm>
#include <utility>

namespace isl::interpreter {

using grammar::as;
using grammar::Node;
using grammar::NodeKind;

namespace {

/// Out of line, because every element goes through the caller.
[[gnu::noinline]] void meet(Context& context, const grammar::Error& node) { context.meet(node); }

}  // namespace

ElementStream::ElementStream(Context& context, const Element& block)
    : context_(context),
      nesting_(context, block.span, kStreamUnits),
      base_(block.opened_in == Element::kClosed ? context.frames.size() : block.opened_in),
      outer_base_(std::exchange(context.stream_base, base_)),
      own_from_(context.frames.size()),
      is_open_(block.opened_in != Element::kClosed),
      word_(block.word),
      span_(block.span) {
  if (is_open_) {
    --context_.abandoned_blocks;
  } else {
    context_.push(Frame::Kind::block, block.items, nullptr, block.span);
  }
}

ElementStream::ElementStream(Context& context, grammar::Items items, SourceSpan span)
    : context_(context),
      nesting_(context, span, kStreamUnits),
      base_(context.frames.size()),
      outer_base_(std::exchange(context.stream_base, base_)),
      span_(span) {
  context_.push(Frame::Kind::value, items, nullptr, span);
}

ElementStream::ElementStream(Context& context, const grammar::Call& call, const MacroValue& macro)
    : context_(context),
      nesting_(context, call.span, kStreamUnits),
      base_(context.frames.size()),
      outer_base_(std::exchange(context.stream_base, base_)),
      span_(call.span) {
  push_macro(context, call, macro);
}

ElementStream::~ElementStream() {
  context_.stream_base = outer_base_;
  if (is_open_ && element_.kind != ElementKind::end) ++context_.abandoned_blocks;
  if (is_open_ || is_handed_over_) return;
  while (context_.frames.size() > base_) context_.pop();
}

Value ElementStream::take_value() {
  ISL_DCHECK(peek().kind == ElementKind::value);
  ready_ = false;
  return evaluate(context_, *element_.node);
}

void ElementStream::skip_rest() {
  while (!peek().is(ElementKind::end)) {
    const Element element = take();
    // The items of a block whose `}` is still to come are this stream's, too.
    if (element.opened_in != Element::kClosed) ElementStream(context_, element).skip_rest();
  }
}

void ElementStream::recover() {
  auto& frames = context_.frames;
  while (frames.size() > base_ + 1 && frames.back().kind != Frame::Kind::include) context_.pop();
  ready_ = false;
  if (context_.abandoned_blocks > 0) skip_abandoned(context_);
}

void ElementStream::yield(ElementKind kind, const Node& node, grammar::Symbol word) {
  element_.kind = kind;
  element_.word = word;
  element_.span = node.span;
  element_.node = &node;
  element_.opened_in = Element::kClosed;
  ready_ = true;
}

void ElementStream::take_block_behind() {
  auto& frames = context_.frames;
  std::size_t i = frames.size() - 1;
  while (i > base_ && frames[i].kind == Frame::Kind::branch && frames[i].next == frames[i].end) --i;
  if (i == frames.size() - 1) return;
  const bool is_declared = i == base_ && frames[i].kind == Frame::Kind::value && outer_base_ != Context::kNoStream;
  if (is_declared && frames[i].next == frames[i].end) --i;
  Frame& around = frames[i];
  if (around.next == around.end || (*around.next)->kind != NodeKind::block) return;
  const auto& block = as<grammar::Block>(**around.next);
  if (block.word != grammar::kNoSymbol) return;
  ++around.next;
  element_.kind = ElementKind::block;
  element_.word_span = element_.span;
  element_.span = block.span;
  element_.items = block.items;
}

void ElementStream::take_call(const grammar::Call& call) {
  const bool is_plain = call.callee->kind == NodeKind::name;
  const Slot* slot = is_plain ? context_.scopes.find(as<grammar::Name>(*call.callee).name) : nullptr;
  if (is_plain && !slot) return yield(ElementKind::unknown, call, as<grammar::Name>(*call.callee).name);
  const Value& callee = slot ? slot->value : called(context_, call);
  if (callee.kind() == ValueKind::macro) {
    const auto& macro = callee.as<MacroValue>();
    const Routine* const routine = routine_of(context_, macro);
    if (!routine || routine->yields) return push_macro(context_, call, macro);
    return call_routine(context_, call, macro, *routine);
  }
  // The value is a function's; otherwise it is a mistake, unless a reader knows the name as a contextual word:
  // `hardness (2)` in a scene that declares a `hardness` too.
  yield(ElementKind::value, call);
}

void ElementStream::end(SourceSpan span) {
  element_ = {.kind = ElementKind::end, .span = span};
  ready_ = true;
}

/// Yields a block whose items are still to come.
void ElementStream::begin_block(const grammar::BlockBegin& node) {
  yield(ElementKind::block, node, node.word);
  element_.word_span = node.word_span;
  const bool is_value = !is_open_ && context_.frames[base_].kind == Frame::Kind::value;
  const bool is_declared = is_value && outer_base_ != Context::kNoStream;
  element_.opened_in = is_declared ? outer_base_ : base_;
  is_handed_over_ = is_declared;
  ++context_.abandoned_blocks;  // until a stream reads it
}

void ElementStream::end_block(const Node& node) {
  if (is_open_) {
    // The branch is over, so that a declaration finds its semicolon behind it.
    auto& frames = context_.frames;
    while (frames.back().kind == Frame::Kind::branch && frames.back().next == frames.back().end) context_.pop();
    return end(node.span);
  }
  if (context_.abandoned_blocks == 0) {
    context_.fail(node.span, "unmatched `}`", "its `{` stands in a branch that was not executed");
  }
  --context_.abandoned_blocks;
}

/// An open block goes on after the branch that it began in, and after the declaration whose value it is, but not after
/// a loop, a macro or a block around it.
void ElementStream::leave_outer_frame() {
  const Frame::Kind kind = context_.frames.back().kind;
  const bool is_bottom = context_.frames.size() == base_ + 1;
  const bool is_left = kind == Frame::Kind::branch || kind == Frame::Kind::case_ || kind == Frame::Kind::value;
  if (is_bottom || !is_left) {
    context_.fail(span_, "no `}` closes this block", "its `}` stands in a branch that was not executed");
  }
  own_from_ = context_.frames.size() - 1;
}

/// Leaves the innermost frame, or starts it again if it is a loop with turns to go. Returns false at the stream's end.
bool ElementStream::finish_frame() {
  if (is_open_ && context_.frames.size() <= own_from_) leave_outer_frame();
  Frame& frame = context_.frames.back();
  if (frame.kind >= Frame::Kind::while_ && continue_frame(context_, frame)) return true;
  if (context_.frames.size() == base_ + 1) return false;
  context_.pop();
  return true;
}

void ElementStream::advance() {
  if (is_handed_over_) return end(span_);
  while (!ready_) {
    // A `#break`, or an open block within this one, may have ended frames around it.
    if (is_open_) own_from_ = std::min(own_from_, context_.frames.size());
    Frame& frame = context_.frames.back();
    if (frame.next == frame.end) {
      if (finish_frame()) continue;
      return end(span_);
    }
    const Node& node = **frame.next++;
    switch (node.kind) {
      case NodeKind::number:
      case NodeKind::string:
      case NodeKind::constant:
      case NodeKind::index:
      case NodeKind::function_call:
      case NodeKind::dot:
      case NodeKind::vector:
      case NodeKind::unary:
      case NodeKind::binary:
      case NodeKind::conditional:
      case NodeKind::array:
      case NodeKind::scoped_name:
      case NodeKind::dictionary:
      case NodeKind::tuple:
      case NodeKind::function: yield(ElementKind::value, node); break;
      case NodeKind::name: {
        const grammar::Symbol name = as<grammar::Name>(node).name;
        const bool has_value = context_.scopes.find(name) != nullptr || is_newer_value(name);
        yield(has_value ? ElementKind::value : ElementKind::unknown, node, name);
        break;
      }
      case NodeKind::call: take_call(as<grammar::Call>(node)); break;
      case NodeKind::word:
        yield(ElementKind::word, node, as<grammar::Word>(node).word);
        if (frame.next == frame.end) take_block_behind();
        break;
      case NodeKind::block:
        yield(ElementKind::block, node, as<grammar::Block>(node).word);
        element_.word_span = as<grammar::Block>(node).word_span;
        element_.items = as<grammar::Block>(node).items;
        break;
      case NodeKind::block_begin: begin_block(as<grammar::BlockBegin>(node)); break;
      case NodeKind::block_end: end_block(node); break;
      case NodeKind::entry:
        yield(ElementKind::entry, node);
        element_.items = as<grammar::Entry>(node).items;
        break;
      case NodeKind::field: yield(ElementKind::field, node); break;
      case NodeKind::comma: yield(ElementKind::comma, node); break;
      case NodeKind::semicolon:
        if (!is_spare(context_, as<grammar::Semicolon>(node))) yield(ElementKind::semicolon, node);
        break;
      case NodeKind::break_: break_out(context_, base_, node); break;
      case NodeKind::error: meet(context_, as<grammar::Error>(node)); break;
      default: execute(context_, node); break;
    }
  }
}

}  // namespace isl::interpreter
