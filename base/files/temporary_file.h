// Names of temporary files, and what becomes of them when their process dies. A file is written under such a name and
// then renamed; a process that is killed in between leaves it behind, and the next run that writes to the same folder
// removes it. The name therefore tells the owner, so that files of living processes and of other machines are left
// alone.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace isl {

/// A process, told from all others.
struct Owner {
  std::string host;             ///< its name and a hash of the machine's id, since many machines have the same name
  std::string boot;             ///< the system's id of this start; `0` if it has none
  std::uint64_t pid_space = 0;  ///< the namespace of process ids: containers of one machine have their own
  std::uint64_t pid = 0;
  std::uint64_t start = 0;  ///< when it began, in ticks since the boot: process ids are used again

  friend bool operator==(const Owner&, const Owner&) = default;
};

[[nodiscard]] const Owner& this_process();

/// `.isl.HOST.BOOT.SPACE.PID.START.NUMBER.tmp`; at most 170 bytes, whatever the file's own name.
[[nodiscard]] std::string temporary_name(const Owner& owner, unsigned number);
/// The owner that a file's name tells; nothing if it is not such a name.
[[nodiscard]] std::optional<Owner> owner_of(std::string_view file_name);

/// True if the owner surely lives no more. `changed`: seconds since 1970 of the file's last change, for an owner from
/// before the present boot. A process that cannot be judged from here (another machine, another container) counts as
/// living.
[[nodiscard]] bool is_dead(const Owner& owner, double changed);

/// Removes the temporary files of dead owners from an open folder.
void remove_leftovers(int folder);

}  // namespace isl
