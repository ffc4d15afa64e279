// What `isl check` and then a tiny `isl render` do with a text that may hold anything, in this process and within
// limits.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace isl::test {

struct SceneVerdict {
  bool is_accepted = false;  ///< by check
  bool is_rendered = false;
  bool is_slow = false;  ///< ended from outside after kSecondsAllowed
  std::string trouble;   ///< empty, or what must not happen
};

inline constexpr double kSecondsAllowed = 20;

/// `folder` is where the scene would stand; its includes are looked for there and in the search path.
[[nodiscard]] SceneVerdict try_scene(std::string_view text, const std::filesystem::path& folder,
                                     const std::vector<std::filesystem::path>& search_path, bool lenient);

}  // namespace isl::test
