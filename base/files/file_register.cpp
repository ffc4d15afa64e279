#include "base/files/file_register.h"

namespace isl {

const FileRegister::Entry* FileRegister::find(const FileIdentity& file) const {
  if (file.exists()) {
    const auto found = by_inode_.find({file.device, file.inode});
    if (found != by_inode_.end()) return found->second;
  }
  const auto found = by_path_.find(file.path);
  return found == by_path_.end() ? nullptr : found->second;
}

void FileRegister::add(const FileIdentity& file, Entry entry) {
  const Entry& kept = entries_.emplace_back(std::move(entry));
  if (!file.path.empty()) by_path_.emplace(file.path, &kept);
  if (file.exists()) by_inode_.emplace(std::pair(file.device, file.inode), &kept);
}

const FileRegister::Entry* FileRegister::add_input(const FileIdentity& file, std::string role) {
  const Entry* const before = find(file);
  if (before != nullptr) return before->is_output() ? before : nullptr;
  add(file, {Entry::Use::input, std::move(role)});
  return nullptr;
}

const FileRegister::Entry* FileRegister::add_output(const FileIdentity& file, std::string role) {
  if (const Entry* const before = find(file)) return before;
  add(file, {Entry::Use::output, std::move(role)});
  return nullptr;
}

}  // namespace isl
