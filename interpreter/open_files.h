// The files that a scene has open under the identifiers of `#fopen`. Output is kept in memory. When it is closed, the
// scene can read it; when the scene has been read, it becomes a file. Knows no directive (interpreter/files.h).
#pragma once

#include "grammar/data_file.h"
#include "grammar/file_access.h"
#include "interpreter/shared.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace isl::interpreter {

struct FileValue final : Shared {
  std::string name;                           ///< as the scene names it
  std::unique_ptr<grammar::DataFile> reader;  ///< null: the file is written
  grammar::WritablePlace place;
  std::string written;
  SourceSpan opened_at;
  bool is_open = true;

  [[nodiscard]] bool is_reader() const { return reader != nullptr; }
};

/// Every open file of one evaluation, including those whose identifier is gone, so that they are written all the same.
struct OpenFiles {
  /// Each file to be written keeps its folder open; systems allow a process some 1024.
  static constexpr std::size_t kMaxOpen = 64;

  std::vector<Ref<FileValue>> files;
  std::size_t bytes_written = 0;  ///< in all
};

}  // namespace isl::interpreter
