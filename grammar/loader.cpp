#include "grammar/loader.h"

#include "grammar/lexer.h"
#include "grammar/parse_state.h"
#include "grammar/parser.hh"
#include "grammar/text_file.h"
#include "grammar/token_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <system_error>
#include <utility>

namespace isl::grammar {
namespace {

namespace fs = std::filesystem;

/// What a chain of `1 + 1 + …` may add to a tree beyond its brackets.
constexpr std::size_t kHeightPerNesting = 4;

bool is_below(const fs::path& file, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

std::string names_of(const std::vector<fs::path>& folders) {
  std::string text;
  for (const fs::path& folder : folders) {
    if (!text.empty()) text += ", ";
    text += folder.empty() ? "." : folder.string();
  }
  return text;
}

}  // namespace

Loader::Loader(SourceMap& map, SymbolTable& symbols, Arena& arena, DiagnosticSink& sink, LoaderOptions options)
    : map_(map), symbols_(symbols), arena_(arena), sink_(sink), options_(std::move(options)) {
  for (const fs::path& folder : options_.include_paths) allow(folder);
}

void Loader::allow(const fs::path& folder) {
  std::error_code error;
  const fs::path canonical = fs::canonical(folder.empty() ? "." : folder, error);
  if (!error) allowed_.push_back(canonical);
}

bool Loader::may_read(const fs::path& canonical) const {
  return std::any_of(allowed_.begin(), allowed_.end(),
                     [&](const fs::path& folder) { return is_below(canonical, folder); });
}

const Unit* Loader::fail(LoadError error, SourceSpan where, std::string message, std::string hint) {
  last_error_ = error;
  sink_.error(where, std::move(message), std::move(hint));
  return nullptr;
}

const Unit* Loader::parse(std::string name, fs::path file, std::string text, SourceSpan where) {
  const std::size_t errors_before = sink_.error_count();
  const std::optional<SourceSpan> span = map_.add(std::move(name), std::move(text));
  if (!span) return fail(LoadError::not_readable, where, "more than 4 GiB of text were read");
  const auto max_height = std::min<std::size_t>(options_.max_nesting, std::numeric_limits<std::uint32_t>::max() / 8);
  ParseState state(map_, arena_, sink_, static_cast<std::uint32_t>(max_height * kHeightPerNesting));
  try {
    Lexer lexer(map_.text(*span), span->begin, symbols_, arena_, sink_);
    TokenStream tokens(lexer, symbols_, arena_, sink_, options_.max_nesting);
    Parser(tokens, state).parse();
  } catch (const ScannerFailure& failure) {
    sink_.error(*span, fmt::format("the text cannot be read: {}", failure.what()));
  }
  last_error_ = sink_.error_count() > errors_before ? LoadError::syntax : LoadError::none;
  return &units_.emplace_back(Unit{*span, state.items(), std::move(file)});
}

const Unit* Loader::load_file(const fs::path& found, const fs::path& canonical, SourceSpan where) {
  TextFile file = read_text_file(canonical, options_.max_file_bytes);
  const std::string name = found.string();
  if (!file.trouble.empty()) {
    return fail(LoadError::not_readable, where, fmt::format("cannot read `{}`: {}", name, file.trouble), file.hint);
  }
  const Unit* const unit = parse(name, found, std::move(file.text), where);
  if (unit != nullptr) cache_[canonical.string()] = {unit, last_error_, file.stamp};
  return unit;
}

const Unit* Loader::load_scene(const fs::path& file_or_dash) {
  const bool is_standard_input = file_or_dash == "-";
  const fs::path folder = is_standard_input ? fs::path(".") : file_or_dash.parent_path();
  allow(folder);
  TextFile file = is_standard_input ? read_standard_input(options_.max_file_bytes)
                                    : read_text_file(file_or_dash, options_.max_file_bytes);
  const std::string name = is_standard_input ? "standard input" : file_or_dash.string();
  if (!file.trouble.empty()) {
    const LoadError error = file.exists ? LoadError::not_readable : LoadError::not_found;
    return fail(error, {}, fmt::format("cannot read `{}`: {}", name, file.trouble), file.hint);
  }
  return parse(name, is_standard_input ? fs::path("./standard input") : file_or_dash, std::move(file.text), {});
}

const Unit* Loader::load_text(std::string name, std::string text) {
  fs::path file = name;
  return parse(std::move(name), std::move(file), std::move(text), {});
}

const Unit* Loader::load_include(std::string_view name, SourceSpan where, const Unit& from) {
  if (name.empty()) return fail(LoadError::not_found, where, "an include needs a file name");
  std::vector<fs::path> folders{from.file.parent_path()};
  folders.insert(folders.end(), options_.include_paths.begin(), options_.include_paths.end());
  bool found_outside = false;
  for (const fs::path& folder : folders) {
    std::error_code error;
    const fs::path found = (folder / name).lexically_normal();
    const fs::path canonical = fs::canonical(folder / name, error);
    if (error) continue;
    if (!may_read(canonical)) {
      found_outside = true;
      continue;
    }
    const auto cached = cache_.find(canonical.string());
    if (cached == cache_.end() || cached->second.stamp != stamp_of(canonical))
      return load_file(found, canonical, where);
    last_error_ = cached->second.error;
    return cached->second.unit;
  }
  if (found_outside) {
    return fail(LoadError::not_readable, where,
                fmt::format("`{}` is outside the folders that the scene may read", name), "allow its folder with `-I`");
  }
  return fail(LoadError::not_found, where, fmt::format("cannot find `{}`", name),
              fmt::format("looked for it in {}", names_of(folders)));
}

void Loader::forget(const fs::path& file) {
  std::error_code error;
  const fs::path canonical = fs::canonical(file, error);
  if (!error) cache_.erase(canonical.string());
}

}  // namespace isl::grammar
