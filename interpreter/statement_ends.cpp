#include "interpreter/statement_ends.h"

#include "interpreter/control.h"

#include <algorithm>

namespace isl::interpreter {

using grammar::as;
using grammar::Node;
using grammar::NodeKind;

namespace {

/// True if the item can be the first of a statement. A name is excluded, because it may stand anywhere.
bool begins_statement(const Node& item) {
  const bool is_directive = item.kind >= NodeKind::declare && item.kind != NodeKind::error;
  const bool is_object = item.kind == NodeKind::block && grammar::is_reserved(as<grammar::Block>(item).word);
  return is_directive || is_object || item.kind == NodeKind::call;
}

}  // namespace

void skip_rest(Context& context) {
  if (context.abandoned_blocks > 0) return skip_abandoned(context);
  Frame& frame = context.frames.back();
  const auto* const stop = std::find_if(frame.next, frame.end, [](const Node* item) {
    return item->kind == NodeKind::semicolon || begins_statement(*item);
  });
  if (stop != frame.end && (*stop)->kind == NodeKind::semicolon) frame.next = stop + 1;
}

}  // namespace isl::interpreter
