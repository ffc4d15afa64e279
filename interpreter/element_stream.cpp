#include "interpreter/element_stream.h"

#include "interpreter/control.h"
#include "interpreter/directives.h"
#include "interpreter/expressions.h"
#include "interpreter/macro_calls.h"
#include "interpreter/spare_semicolons.h"

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
      base_(context.frames.size()),
      word_(block.word),
      span_(block.span) {
  context_.push(Frame::Kind::block, block.items, nullptr, block.span);
}

ElementStream::ElementStream(Context& context, grammar::Items items, SourceSpan span)
    : context_(context), nesting_(context, span, kStreamUnits), base_(context.frames.size()), span_(span) {
  context_.push(Frame::Kind::value, items, nullptr, span);
}

ElementStream::ElementStream(Context& context, const grammar::Call& call, const MacroValue& macro)
    : context_(context), nesting_(context, call.span, kStreamUnits), base_(context.frames.size()), span_(call.span) {
  push_macro(context, call, macro);
}

ElementStream::~ElementStream() {
  while (context_.frames.size() > base_) context_.pop();
}

Value ElementStream::take_value() {
  ISL_DCHECK(peek().kind == ElementKind::value);
  ready_ = false;
  return evaluate(context_, *element_.node);
}

void ElementStream::recover() {
  auto& frames = context_.frames;
  while (frames.size() > base_ + 1 && frames.back().kind != Frame::Kind::include) context_.pop();
  ready_ = false;
}

void ElementStream::yield(ElementKind kind, const Node& node, grammar::Symbol word) {
  element_.kind = kind;
  element_.word = word;
  element_.span = node.span;
  element_.node = &node;
  ready_ = true;
}

void ElementStream::take_call(const grammar::Call& call) {
  const bool is_plain = call.callee->kind == NodeKind::name;
  const Slot* slot = is_plain ? context_.scopes.find(as<grammar::Name>(*call.callee).name) : nullptr;
  if (is_plain && !slot) return yield(ElementKind::unknown, call, as<grammar::Name>(*call.callee).name);
  const Value& callee = slot ? slot->value : called(context_, call);
  if (callee.kind() == ValueKind::macro) return push_macro(context_, call, callee.as<MacroValue>());
  // The value is a function's; otherwise it is a mistake, unless a reader knows the name as a contextual word:
  // `hardness (2)` in a scene that declares a `hardness` too.
  yield(ElementKind::value, call);
}

/// Leaves the innermost frame, or starts it again if it is a loop with turns to go. Returns false at the stream's end.
bool ElementStream::finish_frame() {
  Frame& frame = context_.frames.back();
  if (frame.kind > Frame::Kind::if_block && continue_frame(context_, frame)) return true;
  if (frame.kind == Frame::Kind::if_block) {
    const auto& node = as<grammar::IfBlock>(*frame.node);
    yield(ElementKind::block, node, frame.condition ? node.then_word : node.else_word);
    element_.word_span = node.span;
    element_.items = node.items;
    context_.pop();
    return true;
  }
  if (context_.frames.size() == base_ + 1) return false;
  context_.pop();
  return true;
}

void ElementStream::advance() {
  while (!ready_) {
    Frame& frame = context_.frames.back();
    if (frame.next == frame.end) {
      if (finish_frame()) continue;
      element_ = {.kind = ElementKind::end, .span = span_};
      ready_ = true;
      return;
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
      case NodeKind::function: yield(ElementKind::value, node); break;
      case NodeKind::name: {
        const grammar::Symbol name = as<grammar::Name>(node).name;
        yield(context_.scopes.find(name) ? ElementKind::value : ElementKind::unknown, node, name);
        break;
      }
      case NodeKind::call: take_call(as<grammar::Call>(node)); break;
      case NodeKind::word: yield(ElementKind::word, node, as<grammar::Word>(node).word); break;
      case NodeKind::block:
        yield(ElementKind::block, node, as<grammar::Block>(node).word);
        element_.word_span = as<grammar::Block>(node).word_span;
        element_.items = as<grammar::Block>(node).items;
        break;
      case NodeKind::entry:
        yield(ElementKind::entry, node);
        element_.items = as<grammar::Entry>(node).items;
        break;
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
