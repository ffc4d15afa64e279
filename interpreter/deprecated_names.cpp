#include "interpreter/deprecated_names.h"

#include <fmt/format.h>

#include <utility>

namespace isl::interpreter {

Slot& use_deprecated(Context& context, const Slot& wrapper, SourceSpan mention) {
  auto& deprecated = wrapper.value.as<DeprecatedValue>();
  Slot& slot = *deprecated.slot;
  if (!std::exchange(deprecated.told, true) || !deprecated.once) context.warn(mention, deprecated.remark);
  return slot;
}

void deprecate(Context& context, const grammar::Declare& node, Slot& slot) {
  const grammar::Symbol name = grammar::as<grammar::Name>(*node.target).name;
  const std::string_view remark = node.deprecation.remark;
  const auto wrapper = make_shared_value<DeprecatedValue>(
      context.scopes.slots(),
      remark.empty() ? fmt::format("`{}` was declared deprecated", context.text(name)) : std::string(remark),
      node.deprecation.once);
  wrapper->slot->value = std::move(slot.value);
  slot.value = Value(ValueKind::deprecated, wrapper);
}

}  // namespace isl::interpreter
