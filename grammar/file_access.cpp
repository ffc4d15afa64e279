#include "grammar/file_access.h"

#include "base/shell_word.h"
#include "base/system_message.h"
#include "grammar/similar_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace isl::grammar {
namespace {

namespace fs = std::filesystem;

/// Roles in the register of files.
constexpr std::string_view kInputRole = "an input of the scene";
constexpr std::string_view kOutputRole = "#fopen";

/// A longer name is surely a mistake; messages show this many bytes of it.
constexpr std::size_t kShownNameBytes = 200;

std::string names_of(const std::vector<fs::path>& folders) {
  std::string text;
  for (const fs::path& folder : folders) {
    if (!text.empty()) text += ", ";
    text += folder.empty() ? "." : folder.string();
  }
  return text;
}

/// An absolute folder as an argument in a shell: from the current folder, if that is shorter.
std::string as_typed(const fs::path& folder) {
  std::error_code error;
  const fs::path relative = fs::proximate(folder, error);
  const bool is_shorter = !error && relative.native().size() < folder.native().size();
  return shell_word((is_shorter ? relative : folder).native());
}

/// True for the errors that only say that no file has this name.
bool is_absence(const std::error_code& error) {
  return error == std::errc::no_such_file_or_directory || error == std::errc::not_a_directory ||
         error == std::errc::filename_too_long;
}

}  // namespace

std::string shown_name(std::string_view name) {
  // A name with a line end is a string whose quote is missing: its first line says enough.
  const std::size_t length = std::min(kShownNameBytes, name.find_first_of("\r\n"));
  return name.size() <= length ? std::string(name) : std::string(name.substr(0, length)) + "…";
}

FileAccess::FileAccess(AllowedFolders allowed, std::shared_ptr<OutputSet> outputs)
    : search_path_(std::move(allowed.search_path)), outputs_(std::move(outputs)) {
  for (const fs::path& path : search_path_) readable_.add(path);
  for (const fs::path& path : allowed.read) readable_.add(path);
  for (const fs::path& path : allowed.write) {
    if (Folder folder(path); folder.is_open()) write_folders_.push_back(std::move(folder));
  }
}

void FileAccess::set_current_folder(const fs::path& path) {
  scene_folder_ = path;
  readable_.add(path);
}

void FileAccess::set_scene_folder(const fs::path& path) {
  set_current_folder(path);
  if (const fs::path tree = working_tree_of(path); !tree.empty()) readable_.add(tree);
}

AccessProblem FileAccess::add_input(const FileIdentity& file, const fs::path& shown) {
  const FileRegister::Entry* const output = outputs_->files().add_input(file, std::string(kInputRole));
  if (output == nullptr) return {};
  return {AccessError::refused,
          fmt::format("cannot read `{}`: this run will replace it ({})", shown_name(shown.string()), output->role),
          "give the output another name"};
}

// ---- Reading --------------------------------------------------------------------------------------------------------

FoundFile FileAccess::as_found(const WrittenFile& file, fs::path shown) {
  FoundFile result;
  result.shown = std::move(shown);
  result.canonical = file.place;
  result.stamp = file.stamp;
  result.is_in_memory = true;
  return result;
}

FoundFile FileAccess::judge(const fs::path& candidate) const {
  FoundFile file;
  std::error_code error;
  file.shown = candidate.lexically_normal();
  if (!written_.empty()) {
    const auto written = written_.find(canonical_path(candidate));
    if (written != written_.end()) return as_found(written->second, file.shown);
  }
  file.canonical = fs::canonical(candidate, error);
  const auto refuse = [&](std::string message, std::string hint = {}) {
    file.problem = {AccessError::refused, std::move(message), std::move(hint)};
    return std::move(file);
  };
  if (error) {
    const AccessError kind = is_absence(error) ? AccessError::not_found : AccessError::refused;
    file.problem = {kind, fmt::format("cannot read `{}`: {}", shown_name(file.shown.string()), error.message()), {}};
    return file;
  }
  const ReadableFolders::Verdict verdict = readable_.judge(file.canonical);
  if (verdict.folder == nullptr && verdict.is_in_version_control) {
    return refuse(
        fmt::format("`{}` belongs to version control; a scene may not read it", shown_name(file.shown.string())));
  }
  if (verdict.folder == nullptr) {
    return refuse(fmt::format("`{}` is outside the folders that the scene may read", shown_name(candidate.string())),
                  fmt::format("allow its folder with `-I {}`", as_typed(file.canonical.parent_path())));
  }
  if (file.canonical == verdict.folder->path()) {
    return refuse(fmt::format("cannot read `{}`: it is a folder", file.shown.string()));
  }
  file.folder = verdict.folder->open_folder(file.canonical.parent_path());
  if (!file.folder.is_open()) return refuse(fmt::format("cannot read `{}`: {}", file.shown.string(), explain(errno)));
  file.stamp = stamp_at(file.folder.get(), file.canonical.filename());
  return file;
}

std::vector<fs::path> FileAccess::folders_for(const fs::path& asking_folder) const {
  std::vector<fs::path> folders{asking_folder};
  const auto append = [&](const fs::path& folder) {
    if (std::ranges::find(folders, folder) == folders.end()) folders.push_back(folder);
  };
  // POV-Ray looks in the folder where it was started, which usually is the scene's folder, and not beside the asking
  // file.
  if (scene_folder_) append(*scene_folder_);
  for (const fs::path& folder : search_path_) append(folder);
  return folders;
}

FoundFile FileAccess::search(std::string_view name, const std::vector<fs::path>& folders) const {
  FoundFile found;
  if (name.empty()) {
    found.problem = {AccessError::not_found, "the file name is empty", {}};
    return found;
  }
  if (const auto written = names_.find(name); written != names_.end()) {
    return as_found(written_.at(written->second), fs::path(name));
  }

  // A refusal tells more than "cannot find", but a later folder may hold a readable file.
  AccessProblem refusal;
  for (const fs::path& folder : folders) {
    found = judge(folder / name);
    if (found.problem.error == AccessError::none) return found;
    if (found.problem.error == AccessError::refused && refusal.error == AccessError::none) refusal = found.problem;
  }
  found.problem = refusal.error != AccessError::none
                      ? refusal
                      : AccessProblem{AccessError::not_found, fmt::format("cannot find `{}`", shown_name(name)), {}};
  return found;
}

bool FileAccess::exists(std::string_view name, const fs::path& asking_folder) const {
  return search(name, folders_for(asking_folder)).problem.error == AccessError::none;
}

FoundFile FileAccess::find(std::string_view name, const fs::path& asking_folder) const {
  const std::vector<fs::path> folders = folders_for(asking_folder);
  FoundFile found = search(name, folders);
  if (found.problem.error != AccessError::not_found || name.empty()) return found;
  const auto may_read = [this](const fs::path& file) { return readable_.judge(file).folder != nullptr; };
  found.problem.hint = hint_of_similar_file(name, folders, may_read);
  if (found.problem.hint.empty()) found.problem.hint = fmt::format("looked for it in {}", names_of(folders));
  return found;
}

TextFile FileAccess::read(const FoundFile& file, std::size_t max_bytes) const {
  if (!file.is_in_memory) return read_text_file_at(file.folder.get(), file.canonical.filename(), max_bytes);
  const WrittenFile& written = written_.at(file.canonical);
  return {.text = written.text, .trouble = {}, .hint = {}, .exists = true, .stamp = written.stamp};
}

TextFile FileAccess::read_bytes(const FoundFile& file, std::size_t max_bytes) const {
  if (file.is_in_memory) return read(file, max_bytes);
  return read_bytes_at(file.folder.get(), file.canonical.filename(), max_bytes);
}

std::string FileAccess::portable_name(const FoundFile& file) const {
  if (file.is_in_memory) return "";
  const auto canonical = [](const fs::path& folder) {
    std::error_code error;
    fs::path path = fs::canonical(folder.empty() ? "." : folder, error);
    return error ? fs::path() : path;
  };
  const fs::path scene = scene_folder_ ? canonical(*scene_folder_) : fs::path();
  // Relative to the innermost of the folders: a library may lie below the scene's folder.
  fs::path name = file.canonical.lexically_relative(scene);
  bool is_below = !name.empty() && *name.begin() != "..";
  for (const fs::path& folder : search_path_) {
    const fs::path root = canonical(folder);
    const fs::path relative = root.empty() ? fs::path() : file.canonical.lexically_relative(root);
    if (relative.empty() || *relative.begin() == "..") continue;
    if (!is_below || relative.native().size() < name.native().size()) name = relative;
    is_below = true;
  }
  return name.string();
}

// ---- Writing --------------------------------------------------------------------------------------------------------

WritablePlace FileAccess::judge_place(const fs::path& candidate) const {
  WritablePlace place;
  const auto refuse = [&](std::string why, std::string hint = {}) {
    place.problem = {AccessError::refused,
                     fmt::format("`{}` may not be written: {}", shown_name(candidate.lexically_normal().string()), why),
                     std::move(hint)};
    return std::move(place);
  };
  const fs::path name = candidate.filename();
  if (name.empty() || name == "." || name == "..") return refuse("it is a folder");
  std::error_code error;
  const fs::path parent = candidate.has_parent_path() ? candidate.parent_path() : fs::path(".");
  const fs::path folder_path = fs::canonical(parent, error);
  if (error) return refuse(fmt::format("its folder: {}", error.message()));
  const auto allowed = std::find_if(write_folders_.begin(), write_folders_.end(),
                                    [&](const Folder& folder) { return folder.holds(folder_path); });
  if (allowed == write_folders_.end()) {
    return refuse("it is outside the folders that `--allow-write` names", "allow its folder with `--allow-write`");
  }
  place.canonical = folder_path / name;
  place.folder = allowed->open_folder(folder_path);
  if (!place.folder.is_open()) return refuse(explain(errno));
  // Other programs run the commands that such a folder names.
  if (is_in_version_control(allowed->below(place.canonical))) return refuse("it belongs to version control");
  if (is_shared_mark(name)) return refuse("it decides which files other scenes may read");
  struct stat status {};
  const bool exists = ::fstatat(place.folder.get(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0;
  if (!exists && errno != ENOENT) return refuse(explain(errno));
  if (exists && S_ISLNK(status.st_mode)) return refuse("it is a symbolic link");
  if (exists && S_ISDIR(status.st_mode)) return refuse("it is a folder");
  if (exists && !S_ISREG(status.st_mode)) return refuse("it is not a regular file");
  if (!places_.contains(place.canonical)) {
    const FileIdentity identity{place.canonical, exists ? status.st_dev : 0, exists ? status.st_ino : 0};
    const FileRegister::Entry* const other = outputs_->files().find(identity);
    if (other != nullptr && other->is_output()) return refuse(fmt::format("{} writes it, too", other->role));
    if (other != nullptr) return refuse(fmt::format("it is {}", other->role));
    place.identity = identity;
  }
  if (exists && ::faccessat(place.folder.get(), name.c_str(), W_OK, 0) != 0) return refuse(explain(errno));
  return place;
}

WritablePlace FileAccess::search_place(std::string_view name) const {
  if (name.empty())
    return {
        .problem = {AccessError::refused, "the file name is empty", {}}, .canonical = {}, .identity = {}, .folder = {}};
  WritablePlace place = judge_place(scene_folder_.value_or(fs::path()) / name);
  if (fs::path(name).is_absolute()) return place;
  for (const Folder& folder : write_folders_) {
    // The folder is open and allowed: the file may be written there, unless something stands in the way.
    if (place.folder.is_open()) return place;
    place = judge_place(folder.path() / name);
  }
  return place;
}

WritablePlace FileAccess::find_writable(std::string_view name) {
  WritablePlace place = search_place(name);
  if (place.problem.error == AccessError::none && places_.insert(place.canonical).second) {
    outputs_->files().add_output(place.identity, std::string(kOutputRole));
  }
  return place;
}

WritablePlace FileAccess::in_memory(std::string_view name) {
  places_.insert(fs::path(name));
  return {.problem = {}, .canonical = fs::path(name), .identity = {}, .folder = {}};
}

TextFile FileAccess::read_existing(const WritablePlace& place, std::size_t max_bytes) const {
  if (const auto written = written_.find(place.canonical); written != written_.end()) {
    TextFile file;
    file.text = written->second.text;
    return file;
  }
  if (place.folder.is_open()) return read_bytes_at(place.folder.get(), place.canonical.filename(), max_bytes);
  return {};
}

void FileAccess::write(const WritablePlace& place, std::string_view name, std::string text, SourceSpan opened_at) {
  WrittenFile& file = written_[place.canonical];
  written_bytes_ += text.size() - file.text.size();
  FileStamp stamp;
  stamp.bytes = text.size();
  stamp.inode = ++versions_;
  std::shared_ptr<const OutputFolder> folder;
  if (place.folder.is_open()) folder = outputs_->folder(place.folder, place.canonical.parent_path());
  file = {std::move(folder), place.canonical, std::string(name), std::move(text), stamp, opened_at};
  names_.insert_or_assign(std::string(name), place.canonical);
}

std::vector<WriteFailure> FileAccess::stage_written() {
  std::vector<WriteFailure> failures;
  for (auto& [path, file] : written_) {
    if (!file.folder) continue;
    const std::span<const unsigned char> bytes(reinterpret_cast<const unsigned char*>(file.text.data()),
                                               file.text.size());
    std::string reason = outputs_->stage_at(file.folder, path.filename(), bytes);
    if (!reason.empty()) failures.push_back({file.name, file.opened_at, std::move(reason)});
    file.text = {};
  }
  if (std::optional<OutputSet::Failure> failure = outputs_->sync()) {
    const auto file = written_.find(failure->file);
    const bool is_known = file != written_.end();  // a folder may be mounted at two places
    failures.push_back({is_known ? file->second.name : failure->file.string(),
                        is_known ? file->second.opened_at : SourceSpan{}, std::move(failure->reason)});
  }
  return failures;
}

}  // namespace isl::grammar
