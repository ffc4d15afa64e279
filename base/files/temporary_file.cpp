#include "base/files/temporary_file.h"

#include "base/content_hash.h"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <ctime>
#include <fstream>
#include <limits>
#include <sstream>
#include <vector>

namespace isl {
namespace {

constexpr std::string_view kBegin = ".isl.";
constexpr std::string_view kEnd = ".tmp";
/// The boot of a system that does not tell it.
constexpr std::string_view kNoBoot = "0";

std::string first_line(const std::string& file) {
  std::string line;
  std::ifstream stream(file);
  std::getline(stream, line);
  return line;
}

bool is_plain(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-'; }

/// Only the characters that may stand between the dots of a temporary name.
std::string plain(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (is_plain(c)) result += c;
  }
  return result;
}

std::string host() {
  constexpr std::size_t kShownBytes = 32;  // of a name; the hash tells the rest apart
  std::array<char, 256> name{};
  static_cast<void>(gethostname(name.data(), name.size() - 1));
  ContentHash hash;
  hash.add(name.data());
  hash.add(first_line("/etc/machine-id"));
  return fmt::format("{}-{:016x}", plain(name.data()).substr(0, kShownBytes), hash.value());
}

std::string boot() {
  const std::string id = plain(first_line("/proc/sys/kernel/random/boot_id"));
  return id.empty() ? std::string(kNoBoot) : id;
}

/// The 22nd value of proc(5)'s `stat`. The second, a name in parentheses, may hold anything. 0: there is no such
/// process, or it is hidden from us.
std::uint64_t start_of(std::uint64_t pid) {
  constexpr int kValuesBetween = 19;  // from the third value, which follows the name, to the 22nd
  const std::string line = first_line(fmt::format("/proc/{}/stat", pid));
  const std::size_t name_end = line.rfind(')');
  if (name_end == std::string::npos) return 0;
  std::istringstream values(line.substr(name_end + 1));
  std::string skipped;
  for (int i = 0; i < kValuesBetween; ++i) values >> skipped;
  std::uint64_t start = 0;
  values >> start;
  return start;
}

std::optional<std::uint64_t> number_of(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

double seconds_of(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

const Owner& this_process() {
  static const Owner kSelf = [] {
    struct stat space {};
    static_cast<void>(::stat("/proc/self/ns/pid", &space));
    const auto pid = static_cast<std::uint64_t>(getpid());
    return Owner{host(), boot(), space.st_ino, pid, start_of(pid)};
  }();
  return kSelf;
}

std::string temporary_name(const Owner& owner, unsigned number) {
  return fmt::format("{}{}.{}.{}.{}.{}.{}{}", kBegin, owner.host, owner.boot, owner.pid_space, owner.pid, owner.start,
                     number, kEnd);
}

std::optional<Owner> owner_of(std::string_view name) {
  if (!name.starts_with(kBegin) || !name.ends_with(kEnd)) return std::nullopt;
  name = name.substr(kBegin.size(), name.size() - kBegin.size() - kEnd.size());
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('.', begin), name.size());
    parts.push_back(name.substr(begin, end - begin));
    begin = end + 1;
  }
  if (parts.size() != 6) return std::nullopt;
  const auto space = number_of(parts[2]), pid = number_of(parts[3]), start = number_of(parts[4]);
  if (!space || !pid || !start || !number_of(parts[5])) return std::nullopt;
  if (*pid == 0 || *pid > std::numeric_limits<pid_t>::max()) return std::nullopt;
  return Owner{std::string(parts[0]), std::string(parts[1]), *space, *pid, *start};
}

bool is_dead(const Owner& owner, double changed) {
  const Owner& self = this_process();
  if (self.boot == kNoBoot || owner.host != self.host) return false;
  if (owner.boot != self.boot) {
    // Two machines can still share a name and an id, as copies of one image do: the file must be older than our boot.
    return changed < seconds_of(CLOCK_REALTIME) - seconds_of(CLOCK_BOOTTIME);
  }
  if (owner.pid_space != self.pid_space) return false;
  if (::kill(static_cast<pid_t>(owner.pid), 0) != 0 && errno == ESRCH) return true;
  const std::uint64_t start = start_of(owner.pid);
  return start != 0 && start != owner.start;  // another process has that id now
}

void remove_leftovers(int folder) {
  const int descriptor = ::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  DIR* const entries = ::fdopendir(descriptor);
  if (entries == nullptr) {
    ::close(descriptor);
    return;
  }
  while (const dirent* const entry = ::readdir(entries)) {
    const std::optional<Owner> owner = owner_of(entry->d_name);
    struct stat status {};
    if (!owner || ::fstatat(folder, entry->d_name, &status, AT_SYMLINK_NOFOLLOW) != 0) continue;
    if (S_ISREG(status.st_mode) && is_dead(*owner, static_cast<double>(status.st_mtim.tv_sec))) {
      static_cast<void>(::unlinkat(folder, entry->d_name, 0));
    }
  }
  ::closedir(entries);
}

}  // namespace isl
