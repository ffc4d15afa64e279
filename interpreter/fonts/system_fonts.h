// Fonts that the system has installed, for scenes that name a font without having its file.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace isl::interpreter {

class SystemFonts {
 public:
  /// The installed file of that name, in any case, with or without its ending; empty if there is none.
  [[nodiscard]] std::filesystem::path find(std::string_view name);
  /// A font for text, if possible like the named one; empty if no font is installed.
  [[nodiscard]] std::filesystem::path substitute_for(std::string_view name);

 private:
  /// The folders are searched at the first question.
  const std::vector<std::filesystem::path>& files();

  bool is_listed_ = false;
  std::vector<std::filesystem::path> files_;
};

}  // namespace isl::interpreter
