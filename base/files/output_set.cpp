#include "base/files/output_set.h"

#include "base/files/refuge.h"
#include "base/files/temporary_file.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <system_error>

namespace isl {
namespace {

namespace fs = std::filesystem;

/// Each file that is synced alone costs a write of the file system's journal, some 5 ms; beyond this number, one sync
/// of the file system is quicker, although other programs may have written to it, too.
constexpr std::ptrdiff_t kMostSyncedAlone = 32;

/// The message for a result that is not where it belongs.
std::string failure(const char* doing, const std::string& shown, const std::string& reason, const std::string& name,
                    std::span<const unsigned char> bytes) {
  const fs::path kept = keep_elsewhere(name, bytes);
  const std::string rest = kept.empty() ? "it could not be kept anywhere else" : "it is kept as " + kept.string();
  return fmt::format("cannot {} {}: {}; {}", doing, shown, reason, rest);
}

/// Why a file cannot be written. Of a missing folder the system says the same as of a missing file.
std::string reason_for(const fs::path& file, const std::string& reason) {
  const fs::path folder = file.parent_path();
  std::error_code error;
  if (folder.empty() || fs::exists(folder, error) || error) return reason;
  return fmt::format("there is no folder {}", folder.string());
}

}  // namespace

std::shared_ptr<const OutputFolder> OutputSet::shared(OutputFolder folder) {
  struct stat status {};
  if (!folder.is_open() || ::fstat(folder.get(), &status) != 0)
    return std::make_shared<OutputFolder>(std::move(folder));
  auto& known = folders_[{status.st_dev, status.st_ino}];
  if (!known) {
    remove_leftovers(folder.get());
    known = std::make_shared<OutputFolder>(std::move(folder));
  }
  return known;
}

std::string OutputSet::why_not_writable(const fs::path& file) {
  const fs::path target = canonical_path(file);
  const std::string reason = shared(OutputFolder(target.parent_path()))->why_not_writable(target.filename());
  return reason.empty() ? "" : fmt::format("cannot write {}: {}", file.string(), reason_for(file, reason));
}

std::string OutputSet::stage(const fs::path& file, std::span<const unsigned char> bytes) {
  const fs::path target = canonical_path(file);
  StagedFile staged(shared(OutputFolder(target.parent_path())), target.filename(), bytes, StagedFile::Sync::now);
  if (!staged.error().empty())
    return failure("write", file.string(), reason_for(file, staged.error()), target.filename(), bytes);
  staged_.push_back({std::move(staged), file.string(), true});
  return "";
}

std::shared_ptr<const OutputFolder> OutputSet::folder(const Descriptor& open, const fs::path& path) {
  return shared(OutputFolder(open, path));
}

std::string OutputSet::stage_at(const std::shared_ptr<const OutputFolder>& folder, const std::string& name,
                                std::span<const unsigned char> bytes) {
  StagedFile staged(folder, name, bytes, StagedFile::Sync::later);
  std::string reason = staged.error();
  if (reason.empty()) staged_.push_back({std::move(staged), (folder->path() / name).string(), false});
  return reason;
}

std::optional<OutputSet::Failure> OutputSet::sync() {
  std::set<const OutputFolder*> waiting;
  std::ptrdiff_t count = 0;
  for (const Staged& staged : staged_) {
    if (staged.is_synced) continue;
    waiting.insert(&staged.file.folder());
    ++count;
  }
  const bool is_done = count > kMostSyncedAlone &&
                       std::all_of(waiting.begin(), waiting.end(), [](const auto* f) { return f->sync_file_system(); });
  for (Staged& staged : staged_) {
    if (std::exchange(staged.is_synced, true) || is_done) continue;
    if (std::string reason = staged.file.sync(); !reason.empty()) return Failure{staged.shown, std::move(reason)};
  }
  return std::nullopt;
}

std::vector<std::string> OutputSet::commit() {
  std::vector<std::string> failures;
  std::set<const OutputFolder*> changed;
  for (Staged& staged : staged_) {
    const std::string reason = staged.file.take_place();
    changed.insert(&staged.file.folder());
    if (reason.empty()) continue;
    failures.push_back(failure("replace", staged.shown, reason, staged.file.path().filename(), staged.file.content()));
  }
  for (const OutputFolder* const folder : changed) folder->sync();
  staged_.clear();
  return failures;
}

}  // namespace isl
