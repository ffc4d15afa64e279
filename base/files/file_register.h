// The files that a run reads and those that it will write. An output that is an input, or another output, would spoil a
// file that someone wants; it is refused when it is noted, which is before any work. Knows no option and no language.
#pragma once

#include "base/files/file_identity.h"

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <utility>

namespace isl {

class FileRegister {
 public:
  struct Entry {
    enum class Use : std::uint8_t { input, output };
    Use use = Use::input;
    std::string role;  ///< for messages: `the scene`, `-o a.png`

    [[nodiscard]] bool is_output() const { return use == Use::output; }
  };

  /// Notes a file. If it clashes with a use that was noted before, that one is returned and nothing changes; null: it
  /// does not clash. Many inputs may be one file; an output has its file for itself.
  const Entry* add_input(const FileIdentity& file, std::string role);
  const Entry* add_output(const FileIdentity& file, std::string role);

  /// The use of a file, under whatever name; null: none was noted.
  [[nodiscard]] const Entry* find(const FileIdentity& file) const;

 private:
  void add(const FileIdentity& file, Entry entry);

  std::deque<Entry> entries_;
  std::map<std::filesystem::path, const Entry*> by_path_;
  std::map<std::pair<std::uint64_t, std::uint64_t>, const Entry*> by_inode_;
};

}  // namespace isl
