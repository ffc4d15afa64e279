// Text that may be sent to a terminal: the only kind that cli/output/console.h prints as messages. Whatever it is made
// from, a terminal shows it; it obeys nothing but the styles that are added here.
#pragma once

#include "cli/output/printable_text.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace isl::cli {

enum class Style : std::uint8_t { bold, red, magenta, cyan };

class SafeText {
 public:
  SafeText() = default;
  explicit SafeText(std::string_view any) : text_(with_visible_controls(any)) {}

  SafeText& operator+=(const SafeText& other) {
    text_ += other.text_;
    return *this;
  }

  [[nodiscard]] static SafeText styled(Style style, std::string_view any) {
    SafeText result;
    result.text_ = std::string(code_of(style)) + with_visible_controls(any) + "\033[0m";
    return result;
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  static std::string_view code_of(Style style) {
    switch (style) {
      case Style::red: return "\033[1;31m";
      case Style::magenta: return "\033[1;35m";
      case Style::cyan: return "\033[1;36m";
      case Style::bold: break;
    }
    return "\033[1m";
  }

  std::string text_;
};

}  // namespace isl::cli
