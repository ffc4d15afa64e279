// For searches that report what they find one by one, and may be ended by the one who asks.
#pragma once

#include <type_traits>

namespace isl::render {

/// Calls the function. False if it returned false; a function that returns nothing never ends the search.
template <class Function, class... Arguments>
[[nodiscard]] bool goes_on_after(Function& function, const Arguments&... arguments) {
  if constexpr (std::is_void_v<std::invoke_result_t<Function&, const Arguments&...>>) {
    function(arguments...);
    return true;
  } else {
    return function(arguments...);
  }
}

}  // namespace isl::render
