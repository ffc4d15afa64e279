#include "interpreter/routines/routines.h"

#include "interpreter/nesting.h"
#include "interpreter/routines/routine_builder.h"

#include <memory>
#include <optional>
#include <utility>

namespace isl::interpreter {
namespace {

using grammar::Node;
using grammar::NodeKind;

[[gnu::noinline]] const Routine* make(Context& context, const Node& node) {
  std::optional<Routine> routine = node.kind == NodeKind::macro
                                       ? routine_of_macro(context, grammar::as<grammar::Macro>(node))
                                       : routine_of_loop(context, node);
  auto kept = routine ? std::make_shared<const Routine>(*std::move(routine)) : nullptr;
  return context.routines.emplace(&node, std::move(kept)).first->second.get();
}

const Routine* routine_at(Context& context, const Node& node) {
  const auto found = context.routines.find(&node);
  return found != context.routines.end() ? found->second.get() : make(context, node);
}

void run(Machine& machine, const Routine& routine) {
  const Operation* at = routine.operations.data();
  do {
    at = at->perform(machine, at);
  } while (at);
}

}  // namespace

[[gnu::noinline]] bool run_loop(Context& context, const Node& loop) {
  const Routine* const routine = routine_at(context, loop);
  if (!routine) return false;
  const NestingGuard guard(context, loop.span);
  Value none;
  Machine machine(context, *routine, none);
  run(machine, *routine);
  return true;
}

const Routine* routine_of(Context& context, const MacroValue& macro) {
  if (!macro.is_examined) [[unlikely]] {
    macro.is_examined = true;
    macro.routine = routine_at(context, macro.definition);
  }
  return macro.routine;
}

bool run_body(Context& context, const Routine& routine, Value& result) {
  Machine machine(context, routine, result);
  run(machine, routine);
  return machine.has_result;
}

}  // namespace isl::interpreter
