// One expression for each kind of value that a scene can write, as a literal or by a declared name, and the
// declarations that they need.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace isl::test {

/// Declares a name for every kind of value.
[[nodiscard]] const std::string& declarations_of_every_kind();

/// Expressions after those declarations: literals, declared names, and expressions without a value.
[[nodiscard]] std::span<const std::string_view> expressions_of_every_kind();

}  // namespace isl::test
