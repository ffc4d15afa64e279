#include "grammar/library_index.h"

#include "grammar/text_file.h"

#include <algorithm>
#include <cctype>
#include <system_error>
#include <utility>

namespace isl::grammar {
namespace {

namespace fs = std::filesystem;

/// The largest of POV-Ray's include files has 0.4 MB; a larger file is data.
constexpr std::size_t kMaxFileBytes = 2u << 20;
/// POV-Ray has 81 files. A folder with more than this is not a library, and reading it would delay the message.
constexpr std::size_t kMaxFiles = 500;

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Walks over a text's words and directives; skips comments and strings.
class Walk {
 public:
  explicit Walk(std::string_view text) : text_(text) {}

  std::vector<std::string_view> names() {
    while (i_ < text_.size()) {
      if (text_[i_] == '/' && skip_comment()) continue;
      if (text_[i_] == '"') {
        skip_string();
      } else if (text_[i_] == '#') {
        ++i_;
        follow(next_word());
      } else {
        ++i_;
      }
    }
    return std::move(names_);
  }

 private:
  void follow(std::string_view directive) {
    static constexpr std::string_view kOpening[] = {"if", "ifdef", "ifndef", "while", "for", "switch"};
    if (directive == "macro") {
      const std::string_view name = next_word();
      if (!is_in_macro()) names_.push_back(name);
      open_.push_back(true);
    } else if (std::ranges::find(kOpening, directive) != std::end(kOpening)) {
      open_.push_back(false);
    } else if (directive == "end") {
      if (!open_.empty()) open_.pop_back();
    } else if (directive == "declare" && !is_in_macro()) {
      names_.push_back(next_word());
    }
  }

  [[nodiscard]] bool is_in_macro() const { return std::ranges::find(open_, true) != open_.end(); }

  std::string_view next_word() {
    while (i_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[i_])) != 0) ++i_;
    const std::size_t begin = i_;
    while (i_ < text_.size() && is_word(text_[i_])) ++i_;
    return text_.substr(begin, i_ - begin);
  }

  void skip_string() {
    for (++i_; i_ < text_.size() && text_[i_] != '"'; ++i_) {
      if (text_[i_] == '\\') ++i_;
    }
    ++i_;
  }

  /// Returns false if the `/` begins no comment.
  bool skip_comment() {
    const std::string_view pair = text_.substr(i_, 2);
    if (pair == "//") {
      i_ = std::min(text_.find('\n', i_), text_.size());
      return true;
    }
    if (pair != "/*") return false;
    int depth = 0;
    do {
      const std::string_view here = text_.substr(i_, 2);
      depth += here == "/*" ? 1 : here == "*/" ? -1 : 0;
      i_ += here == "/*" || here == "*/" ? 2 : 1;
    } while (depth > 0 && i_ < text_.size());
    return true;
  }

  std::string_view text_;
  std::size_t i_ = 0;
  std::vector<bool> open_;  ///< one entry for each directive that `#end` closes, true for macros
  std::vector<std::string_view> names_;
};

/// The files of a folder that may be libraries: first those of POV-Ray's ending, so that a name that both kinds declare
/// is found where scenes for either program find it.
std::vector<fs::path> includes_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const fs::path extension = entry->path().extension();
    if ((extension == ".inc" || extension == ".isl") && entry->is_regular_file(error)) files.push_back(entry->path());
  }
  std::ranges::sort(files, {}, [](const fs::path& file) { return std::pair(file.extension() != ".inc", file); });
  return files;
}

}  // namespace

std::vector<std::string_view> names_declared_in(std::string_view text) { return Walk(text).names(); }

LibraryIndex::LibraryIndex(const std::vector<fs::path>& folders) {
  for (const fs::path& folder : folders) {
    for (const fs::path& file : includes_in(folder)) {
      if (files_.size() == kMaxFiles) return;
      add_file(file);
    }
  }
}

void LibraryIndex::add_file(const fs::path& file) {
  const TextFile text = read_text_file(file, kMaxFileBytes);
  if (!text.trouble.empty()) return;
  for (const std::string_view name : names_declared_in(text.text))
    file_of_.try_emplace(std::string(name), files_.size());
  files_.push_back(file.filename().string());
}

std::optional<std::string_view> LibraryIndex::file_that_declares(std::string_view name) const {
  const auto found = file_of_.find(std::string(name));
  if (found == file_of_.end()) return std::nullopt;
  return files_[found->second];
}

}  // namespace isl::grammar
