#include "interpreter/control.h"

#include "interpreter/deprecated_names.h"
#include "interpreter/expressions.h"
#include "interpreter/newer_words.h"
#include "interpreter/places.h"
#include "interpreter/routines/routines.h"

#include <algorithm>
#include <cmath>

namespace isl::interpreter {
namespace {

using grammar::as;
using grammar::Items;
using grammar::Node;
using grammar::NodeKind;

void push_branch(Context& context, const Node& node, Items items) {
  if (items.empty()) return;
  // Tail call: if a list has nothing left after its #if, the branch reuses the list's frame. A file and a text that is
  // read in one piece keep theirs: after an error inside the branch, reading goes on with them.
  Frame& frame = context.frames.back();
  if (frame.next == frame.end && frame.kind >= Frame::Kind::branch) {
    frame.set_items(items);
  } else {
    context.push(Frame::Kind::branch, items, &node, node.span);
  }
}

[[gnu::noinline]] void start_for(Context& context, const grammar::For& node) {
  if (run_loop(context, node)) return;
  const double start = evaluate_number(context, *node.start);
  const double end = evaluate_number(context, *node.end);
  const Frame::Range range{end, node.step ? evaluate_number(context, *node.step) : 1};
  if (!begin_for(context, node, start, range)) return;
  context.count_turn(node.span);
  context.push(Frame::Kind::for_, node.body, &node, node.span).range = range;
}

bool matches(Context& context, const grammar::SwitchCase& c, double subject) {
  const double low = evaluate_number(context, *c.low);
  if (!c.high) return std::abs(subject - low) < kTolerance;
  // As in POV-Ray, a range has no tolerance.
  return subject >= low && subject <= evaluate_number(context, *c.high);
}

[[gnu::noinline]] void start_switch(Context& context, const grammar::Switch& node) {
  const double subject = evaluate_number(context, *node.subject);
  std::size_t taken = 0;
  while (taken < node.cases.size() && !matches(context, node.cases[taken], subject)) ++taken;
  if (taken == node.cases.size() && !node.has_default) return;
  const Items items = taken < node.cases.size() ? node.cases[taken].body : node.otherwise;
  context.push(Frame::Kind::case_, items, &node, node.span).next_case = taken + 1;
}

bool continue_switch(Frame& frame) {
  const auto& node = as<grammar::Switch>(*frame.node);
  const bool has_next =
      frame.next_case < node.cases.size() || (frame.next_case == node.cases.size() && node.has_default);
  if (!has_next) return false;
  frame.set_items(frame.next_case < node.cases.size() ? node.cases[frame.next_case].body : node.otherwise);
  ++frame.next_case;
  return true;
}

[[gnu::noinline]] void start_if(Context& context, const grammar::If& node) {
  push_branch(context, node, evaluate_condition(context, *node.condition) ? node.then : node.otherwise);
}

[[gnu::noinline]] void start_ifdef(Context& context, const grammar::Ifdef& node) {
  push_branch(context, node, is_declared(context, *node.target) != node.negated ? node.then : node.otherwise);
}

[[gnu::noinline]] void start_while(Context& context, const grammar::While& node) {
  if (run_loop(context, node)) return;
  if (!evaluate_condition(context, *node.condition)) return;
  context.count_turn(node.span);
  context.push(Frame::Kind::while_, node.body, &node, node.span);
}

}  // namespace

bool begin_for(Context& context, const grammar::For& node, double start, const Frame::Range& range) {
  check_newer_name(context, node.variable, node.span);
  if (std::abs(range.step) < kTolerance) context.fail(node.step->span, "the step of `#for` is zero");
  used(context, context.scopes.local(node.variable), node.span).value.set_number(start);
  return has_turn(start, range.end, range.step);
}

bool next_for(Context& context, const grammar::For& node, const Frame::Range& range) {
  Slot* const slot = without_wrapper(context.scopes.find(node.variable));
  if (!slot || !slot->value.is_number()) context.fail(node.span, "the variable of `#for` no longer holds a number");
  const double value = slot->value.number() + range.step;
  slot->value.set_number(value);
  return has_turn(value, range.end, range.step);
}

bool is_declared(Context& context, const Node& target) {
  const Slot* slot = find_slot_if_declared(context, target);
  return slot && slot->value.kind() != ValueKind::none;
}

// Only a jump, as execute() is.
void start_control(Context& context, const Node& node) {
  switch (node.kind) {
    case NodeKind::if_: return start_if(context, as<grammar::If>(node));
    case NodeKind::ifdef: return start_ifdef(context, as<grammar::Ifdef>(node));
    case NodeKind::while_: return start_while(context, as<grammar::While>(node));
    case NodeKind::for_: return start_for(context, as<grammar::For>(node));
    case NodeKind::switch_: return start_switch(context, as<grammar::Switch>(node));
    default: ISL_CHECK(false, "node kind {} is no control directive", static_cast<int>(node.kind));
  }
}

bool continue_frame(Context& context, Frame& frame) {
  switch (frame.kind) {
    case Frame::Kind::while_: {
      // The condition may open nested streams, which move the frames in memory: no reference to `frame` survives it.
      const auto& node = as<grammar::While>(*frame.node);
      if (!evaluate_condition(context, *node.condition)) return false;
      context.count_turn(node.span);
      context.frames.back().set_items(node.body);
      return true;
    }
    case Frame::Kind::for_: {
      const auto& node = as<grammar::For>(*frame.node);
      if (!next_for(context, node, frame.range)) return false;
      context.count_turn(node.span);
      frame.set_items(node.body);
      return true;
    }
    case Frame::Kind::case_: return continue_switch(frame);
    default: return false;
  }
}

void skip_abandoned(Context& context) {
  Frame& frame = context.frames.back();
  frame.next = std::find_if(frame.next, frame.end, [](const Node* item) {
    return item->kind == NodeKind::block_end || item->kind >= NodeKind::declare;
  });
}

void break_out(Context& context, std::size_t base, const Node& node) {
  auto& frames = context.frames;
  while (true) {
    const Frame::Kind kind = frames.back().kind;
    const bool is_target = kind == Frame::Kind::while_ || kind == Frame::Kind::for_ || kind == Frame::Kind::case_;
    if (kind == Frame::Kind::macro) {
      // Returns from the macro: the frame stays, and the stream ends it in its own way.
      frames.back().next = frames.back().end;
      return;
    }
    if (frames.size() == base + 1 || kind == Frame::Kind::include) {
      context.fail(node.span, "found `#break` outside a loop, a `#switch` and a macro");
    }
    context.pop();
    if (is_target) return;
  }
}

}  // namespace isl::interpreter
