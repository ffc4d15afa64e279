#include "grammar/text_file.h"

#include "base/files/descriptor.h"
#include "base/system_message.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string_view>

namespace isl::grammar {
namespace {

/// Text has no control characters but those that shape lines and the end mark of DOS. We ignore a stray one in an old
/// scene; one in 32 bytes on average (random bytes have one in 9) shows that a file is not text. Foreign code pages
/// pass: their letters are no control characters.
constexpr std::size_t kBytesPerControl = 32;

bool is_control(char character) {
  static constexpr std::string_view kHarmless = "\t\n\v\f\r\x1A";
  const auto byte = static_cast<unsigned char>(character);
  return (byte < 0x20 || byte == 0x7F) && kHarmless.find(character) == std::string_view::npos;
}

/// The wide encoding of a text, "" for none. It shows in the byte-order mark, or in the zeros: in text that Western
/// editors save most characters are below 256, so that most pairs of bytes have one zero, always on the same side.
std::string_view wide_encoding(std::string_view text) {
  using namespace std::string_view_literals;
  if (text.starts_with("\xFF\xFE\0\0"sv) || text.starts_with("\0\0\xFE\xFF"sv)) return "UTF-32";
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) return "UTF-16";
  std::array<std::size_t, 2> zeros{};
  for (std::size_t i = 0; i < text.size(); ++i) zeros[i % 2] += text[i] == '\0';
  const bool is_one_sided = zeros[0] == 0 || zeros[1] == 0;
  return is_one_sided && (zeros[0] + zeros[1]) * 4 > text.size() ? "UTF-16" : "";
}

void look_for_text(TextFile& file) {
  if (!file.trouble.empty()) return;
  const std::string_view text = file.text;
  if (const std::string_view encoding = wide_encoding(text); !encoding.empty()) {
    file.trouble = fmt::format("it is {} text", encoding);
    file.hint = fmt::format("save it as UTF-8, or convert it with `iconv -f {} -t UTF-8`", encoding);
    return;
  }
  const auto controls = static_cast<std::size_t>(std::count_if(text.begin(), text.end(), is_control));
  if (controls * kBytesPerControl <= text.size()) return;
  file.trouble = "not a text file";
}

FileStamp stamp_from(const struct stat& status) {
  return {static_cast<std::uint64_t>(status.st_dev), static_cast<std::uint64_t>(status.st_ino),
          static_cast<std::uint64_t>(status.st_size), status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
}

/// The kind of a file that is not regular.
std::string what_else(mode_t mode) { return S_ISDIR(mode) ? "it is a folder" : "it is not a regular file"; }

std::string too_large(std::size_t max_bytes) { return fmt::format("larger than {} bytes", max_bytes); }

/// Waits until there is something to read. False if `stop` was set meanwhile: reading itself would go on waiting, since
/// a signal restarts it.
bool wait_for_input(int descriptor, const StopFlag* stop) {
  if (stop == nullptr) return true;
  constexpr int kMillisecondsBetweenLooks = 100;
  pollfd waiting{descriptor, POLLIN, 0};
  while (!stop->is_set()) {
    const int ready = ::poll(&waiting, 1, kMillisecondsBetweenLooks);
    if (ready > 0 || (ready < 0 && errno != EINTR)) return true;  // read() tells what is wrong
  }
  return false;
}

/// Reads until the end; the limit also holds for a file that grows meanwhile.
void read_all(int descriptor, std::size_t max_bytes, TextFile& file, const StopFlag* stop = nullptr) {
  std::array<char, 65536> buffer{};
  while (true) {
    if (!wait_for_input(descriptor, stop)) {
      file.trouble = "interrupted";
      return;
    }
    const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      file.trouble = explain(errno);
      return;
    }
    if (count == 0) return;
    file.text.append(buffer.data(), static_cast<std::size_t>(count));
    if (file.text.size() > max_bytes) {
      file.trouble = too_large(max_bytes);
      return;
    }
  }
}

void read_open_file(const Descriptor& descriptor, std::size_t max_bytes, TextFile& file) {
  struct stat status {};
  if (!descriptor.is_open() || ::fstat(descriptor.get(), &status) != 0) {
    file.exists = errno != ENOENT && errno != ENOTDIR;
    file.trouble = explain(errno);
    return;
  }
  file.exists = true;
  file.stamp = stamp_from(status);
  if (!S_ISREG(status.st_mode)) {
    file.trouble = what_else(status.st_mode);
    return;
  }
  if (static_cast<std::uintmax_t>(status.st_size) > max_bytes) {
    file.trouble = too_large(max_bytes);
    return;
  }
  file.text.reserve(static_cast<std::size_t>(status.st_size) + 1);
  read_all(descriptor.get(), max_bytes, file);
}

// Without O_NONBLOCK, opening a pipe would wait for a writer before it could be refused.
constexpr int kReadFlags = O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY;

}  // namespace

TextFile read_text_file(const std::filesystem::path& path, std::size_t max_bytes) {
  TextFile file;
  read_open_file(Descriptor(::open(path.c_str(), kReadFlags)), max_bytes, file);
  look_for_text(file);
  return file;
}

TextFile read_text_file_at(int folder, const std::string& name, std::size_t max_bytes) {
  TextFile file = read_bytes_at(folder, name, max_bytes);
  look_for_text(file);
  return file;
}

TextFile read_bytes_at(int folder, const std::string& name, std::size_t max_bytes) {
  TextFile file;
  struct stat status {};
  // Opening a device may already have an effect (rewind a tape), so its kind is checked before.
  if (::fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 && !S_ISREG(status.st_mode)) {
    file.exists = true;
    file.trouble = what_else(status.st_mode);
    return file;
  }
  read_open_file(Descriptor(::openat(folder, name.c_str(), kReadFlags | O_NOFOLLOW)), max_bytes, file);
  return file;
}

TextFile read_standard_input(std::size_t max_bytes, const StopFlag* stop) {
  TextFile file{.text = {}, .trouble = {}, .hint = {}, .exists = true, .stamp = {}};
  read_all(STDIN_FILENO, max_bytes, file, stop);
  look_for_text(file);
  return file;
}

FileStamp stamp_of(const std::filesystem::path& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 ? stamp_from(status) : FileStamp{};
}

FileStamp stamp_at(int folder, const std::string& name) {
  struct stat status {};
  return ::fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 ? stamp_from(status) : FileStamp{};
}

}  // namespace isl::grammar
