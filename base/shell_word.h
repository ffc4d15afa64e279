// A word of a command line that a message shows: a user can copy it into a shell.
#pragma once

#include <string>
#include <string_view>

namespace isl {

/// `text` as one word of a POSIX shell: in single quotes, unless every character stands for itself without them.
[[nodiscard]] inline std::string shell_word(std::string_view text) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./+:,=@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string_view::npos) return std::string(text);
  std::string word = "'";
  for (const char c : text) c == '\'' ? word += "'\\''" : word += c;
  return word += '\'';
}

}  // namespace isl
