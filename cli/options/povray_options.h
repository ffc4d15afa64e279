// The names of POV-Ray's options, short (`+W640`) and long (`Width=640`): the words of its .ini files and of its
// command line. povray_switches.h makes a hint of them, ini_options.h our options with the same meaning.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace isl::cli {

/// Facts from the manual of POV-Ray 3.7, "Command-Line and INI-File Options".
struct PovrayOption {
  std::string_view letters;    ///< of the short form; "" if there is none
  std::string_view key;        ///< of the long form, in lower case
  std::string_view ours = {};  ///< our option that takes the same value
};

/// One option as given.
struct PovraySetting {
  const PovrayOption* option = nullptr;
  std::string value;
  bool on = true;  ///< `-A` turns off what `+A` turns on
};

[[nodiscard]] std::span<const PovrayOption> povray_options();

/// The option of that key, ignoring case; null if there is none.
[[nodiscard]] const PovrayOption* povray_option(std::string_view key);

/// `+W640` or `-A`, ignoring case.
[[nodiscard]] std::optional<PovraySetting> povray_switch(std::string_view text);

[[nodiscard]] std::string lower_case(std::string_view text);

/// The file extension for a type of POV-Ray's (`N`, `J85`), "" if isl cannot write that type.
[[nodiscard]] std::string_view extension_of_povray_type(std::string_view type);

}  // namespace isl::cli
