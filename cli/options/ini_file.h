// The text of an .ini file of POV-Ray's → its settings, each with its place. Knows how they are written (sections,
// comments, quotes, switches within lines); what they mean is ini_options.h's.
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
  std::string value;  ///< without its quotes
  bool on = true;     ///< false: a switch with `-`
  bool is_switch = false;
  std::size_t begin = 0, end = 0;  ///< where it stands: bytes of the text
};

/// Something to tell about bytes of the text.
struct IniRemark {
  Severity severity = Severity::warning;
  std::size_t begin = 0, end = 0;
  std::string message;
  std::string hint;
};

struct IniSettings {
  std::vector<IniSetting> settings;  ///< in the order of the file
  std::vector<IniRemark> remarks;    ///< what could not be read
};

/// The settings before the first `[section]`, which hold for all, and those of the section asked for; "" asks for none.
/// Names of sections and keys are the same in any case.
[[nodiscard]] IniSettings read_ini(std::string_view text, std::string_view section);

}  // namespace isl::cli
