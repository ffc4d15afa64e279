#include "grammar/loader.h"

#include "base/content_hash.h"
#include "grammar/complaints.h"
#include "grammar/lexer.h"
#include "grammar/parse_state.h"
#include "grammar/parser.hh"
#include "grammar/parted_braces.h"
#include "grammar/similar_file.h"
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

/// A chain of `1 + 1 + …` may add this factor to the height of a tree beyond its brackets.
constexpr std::size_t kHeightPerNesting = 4;

constexpr std::string_view kMoreMemory = "`--max-memory` raises the limit";
constexpr std::string_view kTooMuchMemory = "the files of the scene take more memory than its limit";

/// A file's content, charged to the budget until nobody holds it any more.
struct HeldBytes {
  Charge charge;
  std::string bytes;
};

}  // namespace

Loader::Loader(SourceMap& map, SymbolTable& symbols, Arena& arena, DiagnosticSink& sink, LoaderOptions options)
    : map_(map),
      symbols_(symbols),
      arena_(arena),
      sink_(sink),
      options_(std::move(options)),
      access_(options_.folders, options_.outputs),
      texts_(options_.run.budget) {
  arena_.set_budget(options_.run.budget);
}

std::size_t Loader::max_file_bytes() const {
  return options_.run.budget ? std::min(options_.max_file_bytes, options_.run.budget->left()) : options_.max_file_bytes;
}

void Loader::explain(TextFile& file, std::size_t max_bytes) const {
  const bool is_too_large = std::max<std::uint64_t>(file.text.size(), file.stamp.bytes) > max_bytes;
  if (!file.trouble.empty() && is_too_large && max_bytes < options_.max_file_bytes) file.hint = kMoreMemory;
}

const Unit* Loader::fail(LoadError error, SourceSpan where, std::string message, std::string hint) {
  last_error_ = error;
  sink_.error(where, std::move(message), std::move(hint));
  return nullptr;
}

const Unit* Loader::parse(std::string name, fs::path file, std::string text, SourceSpan where) {
  AccessProblem problem;
  const std::optional<SourceSpan> span = keep_text(std::move(name), std::move(text), problem);
  if (!span) return fail(LoadError::too_large, where, std::move(problem.message), std::move(problem.hint));
  const std::size_t known_complaints = complaints_.size();
  try {
    Parsed parsed = parse(*span, {});
    if (parsed.has_unmatched_brace) {
      DiagnosticSink known;
      Lexer lexer(map_.text(*span), span->begin, symbols_, arena_, known);
      const std::vector<std::uint32_t> parted = find_parted_braces(lexer, options_.max_nesting);
      if (!parted.empty()) {
        complaints_.resize(known_complaints);
        parsed = parse(*span, parted);
      }
    }
    last_error_ = parsed.errors.empty() ? LoadError::none : LoadError::syntax;
    return &units_.emplace_back(Unit{*span, parsed.items, std::move(file), std::move(parsed.errors)});
  } catch (const std::bad_alloc&) {
    return fail(LoadError::too_large, where,
                fmt::format("`{}` takes more memory than the limit of the scene", map_.position(span->begin).file),
                std::string(kMoreMemory));
  }
}

Loader::Parsed Loader::parse(SourceSpan span, std::span<const std::uint32_t> parted_braces) {
  const auto max_height = std::min<std::size_t>(options_.max_nesting, std::numeric_limits<std::uint32_t>::max() / 8);
  Complaints complaints(complaints_, arena_);
  ParseState state(map_, arena_, complaints, static_cast<std::uint32_t>(max_height * kHeightPerNesting));
  Parsed parsed;
  try {
    DiagnosticSink scanned;
    Lexer lexer(map_.text(span), span.begin, symbols_, arena_, scanned);
    TokenStream tokens(lexer, scanned, symbols_, complaints, options_.max_nesting, parted_braces, options_.run.stop);
    if (Parser(tokens, state).parse() != 0) state.abandon(span);
    parsed.has_unmatched_brace = tokens.has_unmatched_brace();
  } catch (const ScannerFailure& failure) {
    state.failure(span, fmt::format("the text cannot be read: {}", failure.what()));
    state.finish({});
  }
  parsed.items = state.items();
  parsed.errors = complaints.outside();
  parsed.errors.insert(parsed.errors.end(), complaints.certain().begin(), complaints.certain().end());
  if (parsed.errors.size() > DiagnosticSink::kMaxErrors) parsed.errors.resize(DiagnosticSink::kMaxErrors);
  return parsed;
}

std::optional<SourceSpan> Loader::keep_text(std::string name, std::string text, AccessProblem& problem) {
  const std::size_t bytes = text.size();
  if (!texts_.grow(bytes)) {
    problem = {AccessError::refused, std::string(kTooMuchMemory), std::string(kMoreMemory)};
    return std::nullopt;
  }
  const std::optional<SourceSpan> span = map_.add(std::move(name), std::move(text));
  if (!span) {
    texts_.remove(bytes);
    problem = {AccessError::refused, "more than 4 GiB of text were read", {}};
  }
  return span;
}

const Unit* Loader::load_file(const FoundFile& found, SourceSpan where) {
  const std::size_t max_bytes = max_file_bytes();
  TextFile file = access_.read(found, max_bytes);
  explain(file, max_bytes);
  const std::string name = found.shown.string();
  if (!file.trouble.empty()) {
    return fail(LoadError::not_readable, where, fmt::format("cannot read `{}`: {}", name, file.trouble), file.hint);
  }
  AccessProblem problem;
  if (!note_input(found, file, problem)) {
    return fail(LoadError::not_readable, where, std::move(problem.message), std::move(problem.hint));
  }
  const Unit* const unit = parse(name, found.shown, std::move(file.text), where);
  if (unit != nullptr) cache_[found.canonical.string()] = {unit, last_error_, file.stamp};
  return unit;
}

const Unit* Loader::load_scene(const fs::path& file_or_dash) {
  const bool is_standard_input = file_or_dash == "-";
  const fs::path folder = is_standard_input ? fs::path(".") : file_or_dash.parent_path();
  if (is_standard_input) {
    access_.set_current_folder(folder);
  } else {
    access_.set_scene_folder(folder);
  }
  const std::size_t max_bytes = max_file_bytes();
  TextFile file =
      is_standard_input ? read_standard_input(max_bytes, options_.run.stop) : read_text_file(file_or_dash, max_bytes);
  explain(file, max_bytes);
  const std::string name = is_standard_input ? "standard input" : file_or_dash.string();
  if (!file.trouble.empty()) {
    const LoadError error = !file.exists               ? LoadError::not_found
                            : file.hint == kMoreMemory ? LoadError::too_large
                                                       : LoadError::not_readable;
    const auto may_list = [](const fs::path&) { return true; };  // the user names this file, not a scene
    if (!file.exists) file.hint = hint_of_similar_file(name, {folder, ""}, may_list);
    return fail(error, {}, fmt::format("cannot read `{}`: {}", name, file.trouble), file.hint);
  }
  const AccessProblem clash = is_standard_input ? AccessProblem() : access_.add_input(identity_of(file_or_dash), name);
  if (clash.error != AccessError::none) return fail(LoadError::not_readable, {}, clash.message, clash.hint);
  note_use(is_standard_input ? name : file_or_dash.filename().string(), name, file.text);
  return parse(name, is_standard_input ? fs::path("./standard input") : file_or_dash, std::move(file.text), {});
}

const Unit* Loader::load_text(std::string name, std::string text) {
  fs::path file = name;
  return parse(std::move(name), std::move(file), std::move(text), {});
}

void Loader::note_use(std::string name, fs::path shown, std::string_view content) {
  if (name.empty()) return;
  ContentHash hash;
  hash.add(content);
  if (!used_keys_.emplace(name, hash.value()).second) return;
  used_.push_back({std::move(name), std::move(shown), hash.value()});
}

bool Loader::note_input(const FoundFile& found, const TextFile& file, AccessProblem& problem) {
  if (!found.is_in_memory) {
    problem = access_.add_input({found.canonical, file.stamp.device, file.stamp.inode}, found.shown);
    if (problem.error != AccessError::none) return false;
  }
  note_use(access_.portable_name(found), found.shown, file.text);
  return true;
}

FoundFile Loader::find_include(std::string_view name, const Unit& from) const {
  const fs::path folder = from.file.parent_path();
  FoundFile found = access_.find(name, folder);
  if (found.problem.error != AccessError::not_found || fs::path(name).has_extension()) return found;
  // POV-Ray tries the same extensions.
  for (const std::string_view extension : {".inc", ".INC"}) {
    const std::string extended = fmt::format("{}{}", name, extension);
    if (access_.exists(extended, folder)) return access_.find(extended, folder);
  }
  return found;
}

const Unit* Loader::load_include(std::string_view name, SourceSpan where, const Unit& from) {
  FoundFile found = find_include(name, from);
  if (found.problem.error != AccessError::none) {
    const bool is_absent = found.problem.error == AccessError::not_found;
    return fail(is_absent ? LoadError::not_found : LoadError::not_readable, where, std::move(found.problem.message),
                std::move(found.problem.hint));
  }
  const auto cached = cache_.find(found.canonical.string());
  if (cached == cache_.end() || cached->second.stamp != found.stamp) return load_file(found, where);
  last_error_ = cached->second.error;
  return cached->second.unit;
}

std::unique_ptr<DataFile> Loader::open_data(std::string_view name, const Unit& from, AccessProblem& problem) {
  FoundFile found = access_.find(name, from.file.parent_path());
  problem = std::move(found.problem);
  if (problem.error != AccessError::none) return nullptr;
  const auto cached = data_.find(found.canonical.string());
  std::optional<SourceSpan> span;
  if (cached != data_.end() && cached->second.stamp == found.stamp) {
    span = cached->second.span;
  } else {
    const std::string shown = found.shown.string();
    const std::size_t max_bytes = max_file_bytes();
    TextFile file = access_.read(found, max_bytes);
    explain(file, max_bytes);
    if (!file.trouble.empty()) {
      problem = {AccessError::refused, fmt::format("cannot read `{}`: {}", shown, file.trouble), file.hint};
      return nullptr;
    }
    if (!note_input(found, file, problem)) return nullptr;
    span = keep_text(shown, std::move(file.text), problem);
    if (!span) return nullptr;
    data_[found.canonical.string()] = {*span, file.stamp};
  }
  return std::make_unique<DataFile>(map_.text(*span), span->begin, symbols_, arena_, sink_);
}

std::shared_ptr<const std::string> Loader::use_file(std::string_view name, const Unit& from, AccessProblem& problem) {
  const FoundFile found = access_.find(name, from.file.parent_path());
  problem = found.problem;
  if (problem.error != AccessError::none) return nullptr;
  CachedBytes& known = used_bytes_[found.canonical.string()];
  if (known.stamp == found.stamp) {
    if (auto bytes = known.bytes.lock()) return bytes;
  }
  const std::size_t max_bytes = max_file_bytes();
  TextFile file = access_.read_bytes(found, max_bytes);
  explain(file, max_bytes);
  if (!file.trouble.empty()) {
    problem = {AccessError::refused, fmt::format("cannot read `{}`: {}", found.shown.string(), file.trouble),
               file.hint};
    return nullptr;
  }
  if (!note_input(found, file, problem)) return nullptr;
  const auto held = std::make_shared<HeldBytes>(HeldBytes{Charge(options_.run.budget), std::move(file.text)});
  if (!held->charge.grow(held->bytes.size())) {
    problem = {AccessError::refused, std::string(kTooMuchMemory), std::string(kMoreMemory)};
    return nullptr;
  }
  std::shared_ptr<const std::string> bytes(held, &held->bytes);
  known = {bytes, file.stamp};
  return bytes;
}

bool Loader::exists(std::string_view name, const Unit& from) const {
  return access_.exists(name, from.file.parent_path());
}

const LibraryIndex& Loader::library() {
  if (!library_) library_.emplace(options_.folders.search_path);
  return *library_;
}

}  // namespace isl::grammar
