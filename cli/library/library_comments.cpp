#include "cli/library/library_comments.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

namespace isl::cli {
namespace {

constexpr std::string_view kBlanks = " \t\r";

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(kBlanks), text.size());
  return text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

/// The text without the blanks at its end, and without at most `count` spaces at its beginning.
std::string without_indent(std::string_view text, std::size_t count) {
  text = text.substr(0, text.find_last_not_of(kBlanks) + 1);
  return std::string(text.substr(std::min({text.find_first_not_of(' '), count, text.size()})));
}

/// Removes `start` from the front of the text and returns true, if it stands there.
bool take(std::string_view& text, std::string_view start) {
  if (!text.starts_with(start)) return false;
  text.remove_prefix(start.size());
  return true;
}

/// Removes an identifier from the front of the text; "" if none stands there.
std::string_view take_word(std::string_view& text) {
  const auto is_part = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  const auto end = std::find_if_not(text.begin(), text.end(), is_part);
  const std::string_view word = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(word.size());
  return word;
}

std::string_view take_line(std::string_view& text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(line.size() + 1, text.size()));
  return line;
}

/// The names between commas.
std::vector<std::string> names_in(std::string_view list) {
  std::vector<std::string> names;
  while (!list.empty()) {
    const std::string_view part = list.substr(0, list.find(','));
    list.remove_prefix(std::min(part.size() + 1, list.size()));
    if (const std::string_view name = trimmed(part); !name.empty()) names.emplace_back(name);
  }
  return names;
}

/// The lines directly before a directive, each without its `//`.
using Comment = std::span<const std::string_view>;

/// `parameters` is the text between the macro's brackets.
std::optional<LibraryEntry> entry_of_macro(std::string_view name, std::string_view parameters, Comment comment) {
  const std::string head = std::string(name) + "(" + std::string(parameters) + ")";
  const auto is_head = [&head](std::string_view line) { return trimmed(line) == head; };
  const auto is_example = [](std::string_view line) { return trimmed(line).starts_with("Example:"); };
  const auto first = std::ranges::find_if(comment, is_head);
  const auto example = std::ranges::find_if(comment, is_example);
  if (first == comment.end() || example == comment.end()) return std::nullopt;

  LibraryEntry entry;
  entry.name = name;
  entry.kind = "macro";
  entry.parameters = names_in(parameters);
  for (auto line = first + 1; line < example; ++line) entry.text.emplace_back(trimmed(*line));
  std::string_view code = trimmed(*example);
  take(code, "Example:");
  if (!trimmed(code).empty()) entry.example.emplace_back(trimmed(code));
  // Further lines of an example begin with `//` and three spaces.
  for (auto line = example + 1; line < comment.end(); ++line) entry.example.push_back(without_indent(*line, 3));
  return entry;
}

std::optional<LibraryEntry> entry_of_declaration(std::string_view name, Comment comment) {
  for (std::size_t i = 0; i < comment.size(); ++i) {
    std::string_view rest = trimmed(comment[i]);
    if (!take(rest, name) || !take(rest, ": ")) continue;
    const std::string_view kind = take_word(rest);
    if (kind.empty() || !take(rest, ". ") || rest.empty()) continue;
    LibraryEntry entry;
    entry.name = name;
    entry.kind = kind;
    entry.text.emplace_back(rest);
    for (const std::string_view line : comment.subspan(i + 1)) entry.text.emplace_back(trimmed(line));
    return entry;
  }
  return std::nullopt;
}

/// `prefix` begins the names that serve the file alone.
std::optional<LibraryEntry> entry_at(std::string_view line, std::string_view prefix, Comment comment) {
  const bool is_macro = take(line, "#macro ");
  if (!is_macro && !take(line, "#declare ")) return std::nullopt;
  const std::string_view name = take_word(line);
  if (name.empty() || name.starts_with(prefix)) return std::nullopt;
  if (!is_macro) return entry_of_declaration(name, comment);
  line = trimmed(line);
  if (!take(line, "(") || line.find(')') == std::string_view::npos) return std::nullopt;
  return entry_of_macro(name, line.substr(0, line.find(')')), comment);
}

std::string own_prefix(std::string_view stem) {
  std::string prefix(stem);
  if (!prefix.empty() && prefix[0] >= 'a' && prefix[0] <= 'z') prefix[0] = static_cast<char>(prefix[0] - 'a' + 'A');
  return prefix + "_Isl_";
}

}  // namespace

std::vector<LibraryEntry> library_entries(std::string_view stem, std::string_view text) {
  const std::string prefix = own_prefix(stem);
  std::vector<LibraryEntry> entries;
  std::vector<std::string_view> comment;
  for (std::size_t number = 1; !text.empty(); ++number) {
    std::string_view line = take_line(text);
    if (take(line, "//")) {
      comment.push_back(line);
      continue;
    }
    if (std::optional<LibraryEntry> entry = entry_at(line, prefix, comment)) {
      entry->line = number;
      entries.push_back(*std::move(entry));
    }
    comment.clear();
  }
  return entries;
}

std::vector<std::string> head_comment(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    std::string_view line = take_line(text);
    if (!take(line, "//")) break;
    lines.push_back(without_indent(line, 1));
  }
  while (!lines.empty() && lines.back().empty()) lines.pop_back();
  return lines;
}

std::string first_sentence(const std::vector<std::string>& comment) {
  std::string paragraph;
  for (const std::string& line : comment) {
    if (line.empty()) break;
    if (!paragraph.empty()) paragraph += ' ';
    paragraph += trimmed(line);
  }
  const std::size_t end = paragraph.find(". ");
  return end == std::string::npos ? paragraph : paragraph.substr(0, end + 1);
}

}  // namespace isl::cli
