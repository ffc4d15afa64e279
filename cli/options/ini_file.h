// The text of one of POV-Ray's .ini files → its settings, each with its place. Knows their syntax (sections, comments,
// quotes, switches within lines); ini_options.h knows their meaning.
#pragma once

#include "base/diagnostic.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace isl::cli {

/// `Key = value` or `+Lvalue`.
struct IniSetting {
  std::string key;    ///< in lower case
  std::string value;  ///< without quotes
  bool on = true;     ///< false: a switch with `-`
  bool is_switch = false;
  std::size_t begin = 0, end = 0;  ///< its place: bytes of the text
};

/// A message about bytes of the text.
struct IniRemark {
  Severity severity = Severity::warning;
  std::size_t begin = 0, end = 0;
  std::string message;
  std::string hint;
};

struct IniSettings {
  std::vector<IniSetting> settings;  ///< in the order of the file
  std::vector<IniRemark> remarks;    ///< messages about unreadable text
};

/// The settings before the first `[section]`, which apply to all, and those of the requested section; "" requests none.
/// Names of sections and keys ignore case.
[[nodiscard]] IniSettings read_ini(std::string_view text, std::string_view section);

}  // namespace isl::cli
