// Names declared with `deprecated`. As in POV-Ray, each mention of one causes a warning, or only the first if it is
// declared `once`; a later declaration of the name leaves it deprecated, `#undef` ends that. Such a name's slot holds a
// wrapper with the slot of the value, so that other names cost nothing: the wrapper is found only where a value is not
// a number.
#pragma once

#include "base/source_span.h"
#include "grammar/ast.h"
#include "interpreter/context.h"
#include "interpreter/scopes.h"
#include "interpreter/shared.h"

#include <string>
#include <utility>

namespace isl::interpreter {

struct DeprecatedValue final : Shared {
  DeprecatedValue(SlotPool& pool_, std::string remark_, bool once_)
      : pool(pool_), slot(pool_.make()), remark(std::move(remark_)), once(once_) {}
  ~DeprecatedValue() override { pool.release(slot); }

  SlotPool& pool;
  Slot* slot;  ///< of the value itself
  std::string remark;
  bool once;
  bool told = false;
};

/// The slot of the value, for a look-up that does not count as a use.
[[nodiscard]] inline Slot* without_wrapper(Slot* slot) {
  const bool is_wrapper = slot && slot->value.kind() == ValueKind::deprecated;
  return is_wrapper ? slot->value.as<DeprecatedValue>().slot : slot;
}

/// Warns of the use at `mention` and returns the slot of the value.
[[nodiscard]] Slot& use_deprecated(Context& context, const Slot& wrapper, SourceSpan mention);

/// The slot of the value of a name that is used at `mention`.
[[nodiscard]] inline Slot& used(Context& context, Slot& slot, SourceSpan mention) {
  if (slot.value.kind() == ValueKind::deprecated) [[unlikely]]
    return use_deprecated(context, slot, mention);
  return slot;
}
[[nodiscard]] inline Slot* used(Context& context, Slot* slot, SourceSpan mention) {
  return slot ? &used(context, *slot, mention) : nullptr;
}

/// Makes the declared name a deprecated one.
void deprecate(Context& context, const grammar::Declare& node, Slot& slot);

}  // namespace isl::interpreter
