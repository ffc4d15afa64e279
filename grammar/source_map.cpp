#include "grammar/source_map.h"

#include "grammar/line_ends.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace isl::grammar {
namespace {

std::vector<std::uint32_t> find_line_starts(std::string_view text) {
  std::vector<std::uint32_t> starts{0};
  for (std::size_t at = text.find_first_of(kLineEndBytes); at != std::string_view::npos;
       at = text.find_first_of(kLineEndBytes, starts.back())) {
    starts.push_back(static_cast<std::uint32_t>(at + line_end_size(text, at)));
  }
  return starts;
}

bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0u) == 0x80u; }

}  // namespace

std::optional<SourceSpan> SourceMap::add(std::string name, std::string text) {
  if (text.size() >= std::numeric_limits<std::uint32_t>::max() - next_begin_) return std::nullopt;
  const std::uint32_t begin = next_begin_;
  const auto size = static_cast<std::uint32_t>(text.size());
  files_.push_back({std::move(name), std::move(text), begin, {}});
  next_begin_ = begin + size + 1;
  return SourceSpan{begin, begin + size};
}

const SourceMap::File* SourceMap::find(std::uint32_t offset) const {
  if (offset == 0 || offset >= next_begin_) return nullptr;
  const auto after = std::upper_bound(files_.begin(), files_.end(), offset,
                                      [](std::uint32_t place, const File& file) { return place < file.begin; });
  File& file = *std::prev(after);
  if (file.line_starts.empty()) file.line_starts = find_line_starts(file.text);
  return &file;
}

std::size_t SourceMap::line_index(const File& file, std::uint32_t place) {
  const auto after = std::upper_bound(file.line_starts.begin(), file.line_starts.end(), place);
  return static_cast<std::size_t>(after - file.line_starts.begin()) - 1;
}

SourcePosition SourceMap::position(std::uint32_t offset) const {
  const File* const file = find(offset);
  if (file == nullptr) return {};
  const std::uint32_t place = offset - file->begin;
  const std::size_t line = line_index(*file, place);
  const auto from = file->text.begin() + file->line_starts[line];
  const auto before = std::count_if(from, file->text.begin() + place, [](char c) { return !continues_character(c); });
  return {file->name, line + 1, static_cast<std::size_t>(before) + 1};
}

std::string_view SourceMap::line_text(std::uint32_t offset) const {
  const File* const file = find(offset);
  if (file == nullptr) return {};
  const std::uint32_t begin = file->line_starts[line_index(*file, offset - file->begin)];
  const std::string_view rest = std::string_view(file->text).substr(begin);
  return rest.substr(0, rest.find_first_of(kLineEndBytes));
}

std::string_view SourceMap::text(SourceSpan span) const {
  const File* const file = find(span.begin);
  if (file == nullptr || span.end < span.begin) return {};
  return std::string_view(file->text).substr(span.begin - file->begin, span.end - span.begin);
}

}  // namespace isl::grammar
