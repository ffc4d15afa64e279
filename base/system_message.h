// The system's words for the number of an error.
#pragma once

#include <string>
#include <system_error>

namespace isl {

/// `error` is a value of errno.
[[nodiscard]] inline std::string explain(int error) { return std::generic_category().message(error); }

}  // namespace isl
