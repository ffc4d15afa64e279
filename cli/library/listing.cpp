#include "cli/library/listing.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string_view>

namespace isl::cli {
namespace {

/// The usual width of a terminal.
constexpr std::size_t kColumns = 80;

/// The words of the text in lines that begin with `indent`; the first line begins with `first`, which has its width.
std::string wrapped(std::string_view first, std::string_view indent, const std::string& text) {
  std::string result(first), word;
  std::size_t column = first.size();
  bool is_first = true;
  for (std::istringstream words(text); words >> word; is_first = false) {
    if (!is_first && column + 1 + word.size() > kColumns) {
      result += fmt::format("\n{}", indent);
      column = indent.size();
    } else if (!is_first) {
      result += ' ';
      ++column;
    }
    result += word;
    column += word.size();
  }
  return result + "\n";
}

/// Every line with two spaces before it; empty lines stay empty.
std::string indented(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line.empty() ? "\n" : fmt::format("  {}\n", line);
  return text;
}

/// The names of each kind, the kinds in the order in which the file has them.
std::string names_by_kind(const LibraryFile& file) {
  std::vector<std::string> kinds;
  for (const LibraryEntry& entry : file.entries) {
    if (std::ranges::find(kinds, entry.kind) == kinds.end()) kinds.push_back(entry.kind);
  }
  std::string text;
  for (const std::string& kind : kinds) {
    std::string names;
    for (const LibraryEntry& entry : file.entries) names += entry.kind == kind ? entry.name + " " : "";
    const std::string first = fmt::format("  {:<11}", kind);
    text += wrapped(first, std::string(first.size(), ' '), names);
  }
  return text;
}

std::string include_line(const LibraryFile& file) { return fmt::format("#include \"{}\"", file.name); }

/// `Name(A, B)` of a macro, else the name.
std::string signature(const LibraryEntry& entry) {
  return entry.kind == "macro" ? fmt::format("{}({})", entry.name, fmt::join(entry.parameters, ", ")) : entry.name;
}

}  // namespace

std::string overview_text(const Catalogue& catalogue) {
  std::string text =
      "The libraries that `#include` finds by itself. `isl library NAME` explains a\n"
      "file, a macro or a declaration.\n";
  bool is_ours = true;
  for (const LibraryFile& file : catalogue.files()) {
    if (is_ours && !file.is_ours()) text += "\nFiles with the names and identifiers of POV-Ray's:\n\n";
    is_ours = file.is_ours();
    if (is_ours) {
      text += fmt::format("\n{}\n", file.name) + wrapped("  ", "  ", first_sentence(file.head)) + names_by_kind(file);
    } else {
      text += wrapped(fmt::format("{:<14} ", file.name), std::string(15, ' '), first_sentence(file.head));
    }
  }
  return text;
}

std::string library_text(const LibraryFile& file) {
  std::string text = fmt::format("{}\n\n", file.name) + indented(file.head);
  for (const LibraryEntry& entry : file.entries) {
    text += entry.kind == "macro" ? fmt::format("\n{}\n", signature(entry))
                                  : fmt::format("\n{}: {}\n", entry.name, entry.kind);
    text += indented(entry.text);
  }
  return text;
}

std::string entry_text(const LibraryFile& file, const LibraryEntry& entry) {
  std::string text = fmt::format("{}\n  {} of {}\n\n", signature(entry), entry.kind, file.name) + indented(entry.text) +
                     fmt::format("\n{}\n", include_line(file));
  if (!entry.example.empty()) text += "\nExample:\n\n" + indented(entry.example);
  return text;
}

nlohmann::ordered_json library_json(const LibraryFile& file, const std::vector<LibraryEntry>& entries) {
  auto list = nlohmann::ordered_json::array();
  for (const LibraryEntry& entry : entries) {
    nlohmann::ordered_json row;
    row["name"] = entry.name;
    row["kind"] = entry.kind;
    row["parameters"] = entry.parameters;
    row["text"] = fmt::format("{}", fmt::join(entry.text, "\n"));
    row["example"] = nullptr;
    if (!entry.example.empty()) row["example"] = fmt::format("{}", fmt::join(entry.example, "\n"));
    row["line"] = entry.line;
    list.push_back(std::move(row));
  }
  return {{"file", file.name},
          {"include", include_line(file)},
          {"purpose", first_sentence(file.head)},
          {"comment", fmt::format("{}", fmt::join(file.head, "\n"))},
          {"entries", std::move(list)}};
}

}  // namespace isl::cli
