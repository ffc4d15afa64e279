#include "grammar/file_access.h"

#include "grammar/replace_file.h"
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

/// True for the errors that only say that no file has this name.
bool is_absence(const std::error_code& error) {
  return error == std::errc::no_such_file_or_directory || error == std::errc::not_a_directory ||
         error == std::errc::filename_too_long;
}

std::string explain(int code) { return std::generic_category().message(code); }

}  // namespace

std::string shown_name(std::string_view name) {
  // A name with a line end is a string whose quote is missing: its first line says enough.
  const std::size_t length = std::min(kShownNameBytes, name.find_first_of("\r\n"));
  return name.size() <= length ? std::string(name) : std::string(name.substr(0, length)) + "…";
}

FileAccess::FileAccess(std::vector<fs::path> search_path, const std::vector<fs::path>& write_folders)
    : search_path_(std::move(search_path)) {
  for (const fs::path& path : search_path_) readable_.add(path);
  for (const fs::path& path : write_folders) {
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

void FileAccess::add_input(const FileStamp& stamp) { inputs_.emplace(stamp.device, stamp.inode); }

// ---- Reading --------------------------------------------------------------------------------------------------------

ReadableFolders::Verdict FileAccess::verdict_on(const fs::path& canonical) const {
  const ReadableFolders::Verdict verdict = readable_.judge(canonical);
  if (verdict.folder != nullptr || !written_paths_.contains(canonical)) return verdict;
  for (const Folder& folder : write_folders_) {
    if (folder.holds(canonical)) return {&folder, false};
  }
  return verdict;
}

FoundFile FileAccess::judge(const fs::path& candidate) const {
  FoundFile file;
  std::error_code error;
  file.shown = candidate.lexically_normal();
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
  const ReadableFolders::Verdict verdict = verdict_on(file.canonical);
  if (verdict.folder == nullptr && verdict.is_in_version_control) {
    return refuse(
        fmt::format("`{}` belongs to version control; a scene may not read it", shown_name(file.shown.string())));
  }
  if (verdict.folder == nullptr) {
    return refuse(fmt::format("`{}` is outside the folders that the scene may read", shown_name(candidate.string())),
                  "allow its folder with `-I`");
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
  if (const auto memory = memory_.find(name); memory != memory_.end()) {
    found.shown = found.canonical = fs::path(name);
    found.stamp = memory->second.stamp;
    found.is_in_memory = true;
    return found;
  }
  if (const auto written = written_.find(name); written != written_.end()) return judge(written->second);

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
  const auto may_read = [this](const fs::path& file) { return verdict_on(file).folder != nullptr; };
  found.problem.hint = hint_of_similar_file(name, folders, may_read);
  if (found.problem.hint.empty()) found.problem.hint = fmt::format("looked for it in {}", names_of(folders));
  return found;
}

TextFile FileAccess::read(const FoundFile& file, std::size_t max_bytes) const {
  if (!file.is_in_memory) return read_text_file_at(file.folder.get(), file.canonical.filename(), max_bytes);
  const auto memory = memory_.find(file.canonical.string());
  return {.text = memory->second.text, .trouble = {}, .hint = {}, .exists = true, .stamp = memory->second.stamp};
}

TextFile FileAccess::read_bytes(const FoundFile& file, std::size_t max_bytes) const {
  if (file.is_in_memory) return read(file, max_bytes);
  return read_bytes_at(file.folder.get(), file.canonical.filename(), max_bytes);
}

std::string FileAccess::portable_name(const FoundFile& file) const {
  if (file.is_in_memory || written_paths_.contains(file.canonical)) return "";
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
  struct stat status {};
  if (::fstatat(place.folder.get(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) {
    if (errno == ENOENT) return place;
    return refuse(explain(errno));
  }
  if (S_ISLNK(status.st_mode)) return refuse("it is a symbolic link");
  if (S_ISDIR(status.st_mode)) return refuse("it is a folder");
  if (!S_ISREG(status.st_mode)) return refuse("it is not a regular file");
  if (inputs_.contains({status.st_dev, status.st_ino}) && !written_paths_.contains(place.canonical)) {
    return refuse("it is an input of the scene");
  }
  if (::faccessat(place.folder.get(), name.c_str(), W_OK, 0) != 0) return refuse(explain(errno));
  return place;
}

WritablePlace FileAccess::find_writable(std::string_view name) const {
  if (name.empty())
    return {.problem = {AccessError::refused, "the file name is empty", {}}, .canonical = {}, .folder = {}};
  WritablePlace place = judge_place(scene_folder_.value_or(fs::path()) / name);
  if (fs::path(name).is_absolute()) return place;
  for (const Folder& folder : write_folders_) {
    // The folder is open and allowed: the file may be written there, unless something stands in the way.
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
