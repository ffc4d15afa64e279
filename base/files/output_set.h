// All that one run writes, as one transaction: every file is complete and synced under a temporary name before the
// first takes its place, so that after a kill each of them is whole, old or new. The set also holds the register of
// inputs and outputs, which keeps a run from writing over a file that it needs.
#pragma once

#include "base/files/descriptor.h"
#include "base/files/file_register.h"
#include "base/files/staged_file.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace isl {

class OutputSet {
 public:
  OutputSet() = default;
  OutputSet(const OutputSet&) = delete;
  OutputSet& operator=(const OutputSet&) = delete;

  [[nodiscard]] FileRegister& files() { return files_; }

  /// The reason why `file` could not be written, as a message that names it, or "". Leaves nothing behind, and removes
  /// what killed runs left in its folder.
  [[nodiscard]] std::string why_not_writable(const std::filesystem::path& file);

  /// Writes `bytes` beside `file`, synced. If that fails, they are kept elsewhere (refuge.h), and the message that is
  /// returned says where; "": there was no failure.
  [[nodiscard]] std::string stage(const std::filesystem::path& file, std::span<const unsigned char> bytes);

  /// The open folder as one that files are staged in; the same for the same folder. Removes what killed runs left
  /// there.
  [[nodiscard]] std::shared_ptr<const OutputFolder> folder(const Descriptor& open, const std::filesystem::path& path);

  /// Writes a file of such a folder, without another place and without syncing: sync() does that for many files at
  /// once. Returns the reason of a failure alone.
  [[nodiscard]] std::string stage_at(const std::shared_ptr<const OutputFolder>& folder, const std::string& name,
                                     std::span<const unsigned char> bytes);
  struct Failure {
    std::filesystem::path file;
    std::string reason;
  };
  /// Waits until those files are on the disk. Returns the first failure.
  [[nodiscard]] std::optional<Failure> sync();

  /// Every staged file takes its place. Where one cannot, the others do all the same, and it is kept elsewhere. Returns
  /// the failures as messages.
  [[nodiscard]] std::vector<std::string> commit();

 private:
  using FolderKey = std::pair<std::uint64_t, std::uint64_t>;  ///< device and inode

  struct Staged {
    StagedFile file;
    std::string shown;  ///< the file as the user names it
    bool is_synced;
  };

  [[nodiscard]] std::shared_ptr<const OutputFolder> shared(OutputFolder folder);

  FileRegister files_;
  std::map<FolderKey, std::shared_ptr<const OutputFolder>> folders_;
  std::vector<Staged> staged_;
};

}  // namespace isl
