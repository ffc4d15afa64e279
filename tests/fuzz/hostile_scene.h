// Does what `isl check` and then a tiny `isl render` do, with any text, in this process and within limits.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace isl::test {

struct SceneVerdict {
  bool is_accepted = false;  ///< `check` accepted it
  bool is_rendered = false;
  bool is_slow = false;  ///< it was ended from outside after kSecondsAllowed
  std::string trouble;   ///< empty, or a description of what must not happen
};

inline constexpr double kSecondsAllowed = 20;

/// `folder` is that of the scene; includes are looked for there and in the search path.
[[nodiscard]] SceneVerdict try_scene(std::string_view text, const std::filesystem::path& folder,
                                     const std::vector<std::filesystem::path>& search_path, bool lenient);

}  // namespace isl::test
