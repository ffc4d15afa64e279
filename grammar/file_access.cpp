#include "grammar/file_access.h"

#include "grammar/replace_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace isl::grammar {
namespace {

namespace fs = std::filesystem;

/// Longer names are no names; messages show so much of them.
constexpr std::size_t kShownNameBytes = 200;

std::string names_of(const std::vector<fs::path>& folders) {
  std::string text;
  for (const fs::path& folder : folders) {
    if (!text.empty()) text += ", ";
    text += folder.empty() ? "." : folder.string();
  }
  return text;
}

/// Errors that only say that nothing is there by this name.
bool is_absence(const std::error_code& error) {
  return error == std::errc::no_such_file_or_directory || error == std::errc::not_a_directory ||
         error == std::errc::filename_too_long;
}

std::string explain(int code) { return std::generic_category().message(code); }

}  // namespace

std::string shown_name(std::string_view name) {
  return name.size() <= kShownNameBytes ? std::string(name) : std::string(name.substr(0, kShownNameBytes)) + "…";
}

FileAccess::FileAccess(std::vector<fs::path> search_path, const std::vector<fs::path>& write_folders)
    : search_path_(std::move(search_path)) {
  for (const fs::path& path : search_path_) {
    if (Folder folder(path); folder.is_open()) readable_.push_back(std::move(folder));
  }
  for (const fs::path& path : write_folders) {
    if (Folder folder(path); folder.is_open()) write_folders_.push_back(std::move(folder));
  }
}

void FileAccess::set_scene_folder(const fs::path& path) {
  scene_folder_ = path;
  if (Folder folder(path); folder.is_open()) readable_.push_back(std::move(folder));
}

void FileAccess::add_input(const FileStamp& stamp) { inputs_.emplace(stamp.device, stamp.inode); }

// ---- Reading --------------------------------------------------------------------------------------------------------

const Folder* FileAccess::readable_folder_of(const fs::path& canonical) const {
  for (const Folder& folder : readable_) {
    if (folder.holds(canonical)) return &folder;
  }
  if (!written_paths_.contains(canonical)) return nullptr;
  for (const Folder& folder : write_folders_) {
    if (folder.holds(canonical)) return &folder;
  }
  return nullptr;
}

FoundFile FileAccess::judge(const fs::path& candidate) const {
  FoundFile file;
  std::error_code error;
  file.shown = candidate.lexically_normal();
  file.canonical = fs::canonical(candidate, error);
  if (error) {
    file.problem.error = is_absence(error) ? AccessError::not_found : AccessError::refused;
    file.problem.message = fmt::format("cannot read `{}`: {}", shown_name(file.shown.string()), error.message());
    return file;
  }
  const Folder* const folder = readable_folder_of(file.canonical);
  if (folder == nullptr) {
    file.problem = {AccessError::refused,
                    fmt::format("`{}` is outside the folders that the scene may read", shown_name(candidate.string())),
                    "allow its folder with `-I`"};
    return file;
  }
  if (file.canonical == folder->path()) {
    file.problem = {AccessError::refused, fmt::format("cannot read `{}`: it is a folder", file.shown.string()), {}};
    return file;
  }
  file.folder = folder->open_folder(file.canonical.parent_path());
  if (!file.folder.is_open()) {
    file.problem = {AccessError::refused, fmt::format("cannot read `{}`: {}", file.shown.string(), explain(errno)), {}};
    return file;
  }
  file.stamp = stamp_at(file.folder.get(), file.canonical.filename());
  return file;
}

FoundFile FileAccess::find(std::string_view name, const fs::path& asking_folder) const {
  FoundFile found;
  if (name.empty()) {
    found.problem = {AccessError::not_found, "a file needs a name", {}};
    return found;
  }
  if (const auto memory = memory_.find(name); memory != memory_.end()) {
    found.shown = found.canonical = fs::path(name);
    found.stamp = memory->second.stamp;
    found.is_in_memory = true;
    return found;
  }
  if (const auto written = written_.find(name); written != written_.end()) return judge(written->second);

  std::vector<fs::path> folders{asking_folder};
  folders.insert(folders.end(), search_path_.begin(), search_path_.end());
  // A refusal tells more than "cannot find", but a later folder may hold a file that may be read.
  AccessProblem refusal;
  for (const fs::path& folder : folders) {
    found = judge(folder / name);
    if (found.problem.error == AccessError::none) return found;
    if (found.problem.error == AccessError::refused && refusal.error == AccessError::none) refusal = found.problem;
  }
  found.problem = refusal.error != AccessError::none
                      ? refusal
                      : AccessProblem{AccessError::not_found, fmt::format("cannot find `{}`", shown_name(name)),
                                      fmt::format("looked for it in {}", names_of(folders))};
  return found;
}

TextFile FileAccess::read(const FoundFile& file, std::size_t max_bytes) const {
  if (!file.is_in_memory) return read_text_file_at(file.folder.get(), file.canonical.filename(), max_bytes);
  const auto memory = memory_.find(file.canonical.string());
  return {.text = memory->second.text, .trouble = {}, .hint = {}, .exists = true, .stamp = memory->second.stamp};
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
  struct stat status {};
  if (::fstatat(place.folder.get(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) {
    if (errno == ENOENT) return place;
    return refuse(explain(errno));
  }
  if (S_ISLNK(status.st_mode)) return refuse("it is a symbolic link");
  if (S_ISDIR(status.st_mode)) return refuse("it is a folder");
  if (!S_ISREG(status.st_mode)) return refuse("it is not a regular file");
  if (inputs_.contains({status.st_dev, status.st_ino}) && !written_paths_.contains(place.canonical)) {
    return refuse("the scene is read from it");
  }
  if (::faccessat(place.folder.get(), name.c_str(), W_OK, 0) != 0) return refuse(explain(errno));
  return place;
}

WritablePlace FileAccess::find_writable(std::string_view name) const {
  if (name.empty())
    return {.problem = {AccessError::refused, "a file needs a name", {}}, .canonical = {}, .folder = {}};
  WritablePlace place = judge_place(scene_folder_ / name);
  if (fs::path(name).is_absolute()) return place;
  for (const Folder& folder : write_folders_) {
    // An open folder is an allowed one: the file may be written there, or something stands in the way.
    if (place.folder.is_open()) return place;
    place = judge_place(folder.path() / name);
  }
  return place;
}

WritablePlace FileAccess::in_memory(std::string_view name) {
  return {.problem = {}, .canonical = fs::path(name), .folder = {}};
}

TextFile FileAccess::read_existing(const WritablePlace& place, std::size_t max_bytes) const {
  if (place.folder.is_open()) return read_bytes_at(place.folder.get(), place.canonical.filename(), max_bytes);
  const auto memory = memory_.find(place.canonical.string());
  TextFile file;
  if (memory != memory_.end()) file.text = memory->second.text;
  return file;
}

std::string FileAccess::write(const WritablePlace& place, std::string_view name, std::string text) {
  if (!place.folder.is_open()) {
    FileStamp stamp;
    stamp.bytes = text.size();
    stamp.inode = ++memory_count_;
    memory_.insert_or_assign(std::string(name), MemoryFile{std::move(text), stamp});
    return "";
  }
  std::string trouble = replace_file(place.folder.get(), place.canonical.filename(), text);
  if (trouble.empty()) {
    written_.insert_or_assign(std::string(name), place.canonical);
    written_paths_.insert(place.canonical);
  }
  return trouble;
}

}  // namespace isl::grammar
