#include "interpreter/context.h"

#include "grammar/suggest.h"
#include "interpreter/nesting.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

namespace isl::interpreter {

using grammar::Symbol;

ContextualWords::ContextualWords(grammar::SymbolTable& symbols)
    : kernel(symbols.intern("kernel")),
      hardness(symbols.intern("hardness")),
      convolution(symbols.intern("convolution")),
      skeleton(symbols.intern("skeleton")),
      solver(symbols.intern("solver")),
      tolerance(symbols.intern("tolerance")),
      hf(symbols.intern("hf")) {}

namespace {

/// True for POV-Ray's file types: such a scene without `#version` is drawn as POV-Ray draws it, one of our own type in
/// the newest version. Files from DOS have names in capitals.
bool is_of_povray(const std::filesystem::path& file) {
  static constexpr std::string_view kExtensions[] = {".pov", ".inc", ".POV", ".INC"};
  return std::ranges::find(kExtensions, file.extension().string()) != std::end(kExtensions);
}

/// The first part of a hint: it names the statements that replace an unsupported feature. Empty if none does.
std::string_view replacement_of(std::string_view thing) {
  return thing == "radiosity" ? "light from the sky and from surfaces comes from `sky_light` and `bounce_light`; " : "";
}

}  // namespace

Context::Context(grammar::Loader& loader_, grammar::SymbolTable& symbols_, const grammar::Unit& unit,
                 const EvaluateOptions& options_, const RunLimits& run_, MemoryAccount& memory_, DiagnosticSink& sink)
    : loader(loader_),
      symbols(symbols_),
      main_unit(unit),
      options(options_),
      run(run_),
      words(symbols_),
      memory(memory_),
      scopes(&memory_),
      version(!is_of_povray(unit.file)),
      sink_(sink),
      max_nesting_(max_nesting(options_.limits)) {}

// ---- Complaints -----------------------------------------------------------------------------------------------------

bool Context::is_said(Severity severity, SourceSpan span, const std::string& message) {
  return !said_.emplace(severity, span.begin, span.end, message).second;
}

void Context::error(SourceSpan span, std::string message, std::string hint) {
  // Loops and macros meet the same mistake again and again. One that only repeats it must still end.
  constexpr std::size_t kMaxRepeatedErrors = 1000;
  if (is_said(Severity::error, span, message)) {
    if (++repeated_errors_ == kMaxRepeatedErrors) throw Stopped{};
    return;
  }
  sink_.report({Severity::error, span, std::move(message), std::move(hint), {}, chain()});
  if (sink_.is_full()) throw Stopped{};
}

void Context::fail(SourceSpan span, std::string message, std::string hint) {
  error(span, std::move(message), std::move(hint));
  throw Failed{};
}

void Context::fail_not_finite(SourceSpan span, const std::string& message) {
  if (left_out.empty()) fail(span, message);
  warn(span, fmt::format("{}; {} is left out", message, left_out));
  throw LeftOut{};
}

void Context::stop(SourceSpan span, std::string message, std::string hint) {
  error(span, std::move(message), std::move(hint));
  throw Stopped{};
}

void Context::warn(SourceSpan span, std::string message, std::string hint) {
  if (sink_.is_full_of_warnings() || is_said(Severity::warning, span, message)) return;
  sink_.report({Severity::warning, span, std::move(message), std::move(hint), {}, chain()});
}

void Context::note(SourceSpan span, std::string message, std::string hint) {
  if (is_said(Severity::note, span, message)) return;
  sink_.report({Severity::note, span, std::move(message), std::move(hint), {}, chain()});
}

void Context::tell(const grammar::Complaint& complaint) {
  if (!told_.insert(&complaint).second) return;
  Diagnostic diagnostic = complaint.diagnostic;
  if (!complaint.is_error()) return warn(diagnostic.span, std::move(diagnostic.message), std::move(diagnostic.hint));
  diagnostic.chain = chain();
  sink_.report(std::move(diagnostic));
  if (sink_.is_full()) throw Stopped{};
}

void Context::meet(const grammar::Error& node) {
  const grammar::Complaint* complaint = node.complaint;
  if (complaint && !complaint->is_error()) return tell(*complaint);
  for (; complaint; complaint = complaint->next) tell(*complaint);
  if (!node.gives_up) return;
  // A node without a complaint follows one that was reported before, or that comes later in the text. Either way a
  // scene must not go on as if nothing were wrong.
  if (!node.complaint) tell_rest();
  if (!node.complaint && !sink_.has_errors()) error(node.span, "this text cannot be read");
  throw Failed{};
}

void Context::tell_rest() {
  if (sink_.has_errors()) return;
  for (const grammar::Unit& unit : loader.units()) {
    for (const grammar::Complaint* complaint : unit.errors) tell(*complaint);
  }
}

void Context::report_out_of_memory() {
  sink_.report({Severity::error, {}, "the system has no memory left for the scene", {}, {}, {}});
}

void Context::unsupported(SourceSpan span, std::string_view thing) {
  std::string message = fmt::format("`{}` is not supported", thing);
  if (options.lenient) {
    warn(span, message + "; skipped");
  } else {
    error(span, std::move(message), fmt::format("{}`--lenient` skips unsupported features", replacement_of(thing)));
  }
}

std::string Context::hint_of_library(Symbol name) const {
  const auto file = loader.library().file_that_declares(text(name));
  return file ? fmt::format("`{0}` is declared in `{1}`: write `#include \"{1}\"` before this", text(name), *file)
              : std::string();
}

std::string Context::suggest_declared(Symbol name) const {
  if (std::string hint = hint_of_library(name); !hint.empty()) return hint;
  std::vector<std::string_view> names;
  for (const Symbol declared : scopes.declared()) names.push_back(text(declared));
  const auto nearest = grammar::closest(text(name), names);
  return nearest ? fmt::format("did you mean `{}`?", *nearest) : std::string();
}

// ---- Frames ---------------------------------------------------------------------------------------------------------

const grammar::Unit& Context::current_unit() const {
  if (frames.empty() || frames.back().call == Frame::kNoCall) return main_unit;
  return *frames[frames.back().call].called.unit;
}

std::vector<ExpansionFrame> Context::chain() const {
  std::vector<ExpansionFrame> result;
  std::uint32_t call = frames.empty() ? Frame::kNoCall : frames.back().call;
  while (call != Frame::kNoCall) {
    const Frame& frame = frames[call];
    const bool is_macro = frame.kind == Frame::Kind::macro;
    result.push_back({is_macro ? ExpansionFrame::Kind::macro : ExpansionFrame::Kind::include,
                      origins.name(frame.called.origin_name), frame.node->span});
    call = call == 0 ? Frame::kNoCall : frames[call - 1].call;
  }
  return result;
}

OriginTable::Chain Context::make_chain(std::uint32_t call, OriginTable::Chain outer) {
  Frame& frame = frames[call];
  const auto kind = frame.kind == Frame::Kind::macro ? ExpansionFrame::Kind::macro : ExpansionFrame::Kind::include;
  frame.called.chain = origins.extend(outer, kind, frame.called.origin_name, frame.node->span);
  return frame.called.chain;
}

OriginTable::Chain Context::chain_of(std::uint32_t call) {
  // The enclosing call usually has its chain already.
  const std::uint32_t outer = call == 0 ? Frame::kNoCall : frames[call - 1].call;
  if (outer == Frame::kNoCall || frames[outer].called.chain != Frame::kNoChain)
    return make_chain(call, outer == Frame::kNoCall ? 0 : frames[outer].called.chain);
  // Iterative, because recursion in a scene must not become recursion here: find the calls without a chain, then make
  // their chains from the outside in.
  std::uint32_t known = call;
  std::vector<std::uint32_t> missing;
  while (known != Frame::kNoCall && frames[known].called.chain == Frame::kNoChain) {
    missing.push_back(known);
    known = known == 0 ? Frame::kNoCall : frames[known - 1].call;
  }
  OriginTable::Chain chain = known == Frame::kNoCall ? 0 : frames[known].called.chain;
  for (; !missing.empty(); missing.pop_back()) chain = make_chain(missing.back(), chain);
  return chain;
}

OriginId Context::origin(SourceSpan span) {
  const std::uint32_t call = frames.empty() ? Frame::kNoCall : frames.back().call;
  if (call == Frame::kNoCall) return origins.add(span, 0);
  const OriginTable::Chain chain = frames[call].called.chain;
  return origins.add(span, chain != Frame::kNoChain ? chain : chain_of(call));
}

// ---- Limits ---------------------------------------------------------------------------------------------------------

void Context::too_deep(SourceSpan span) {
  stop(span, fmt::format("more than {} macro calls and blocks are open at once", options.limits.max_depth),
       "possible infinite recursion; `--max-depth` raises the limit");
}

void Context::value_too_deep(SourceSpan span) {
  fail(span, fmt::format("this value holds others more than {} deep within one another", scene::kMaxValueDepth),
       "pigments, normals, textures, functions and arrays have this limit; objects have none");
}

void Context::look_at_turns(SourceSpan span) {
  // The number of turns is exact as a double: no run reaches 2⁵³.
  constexpr std::uint64_t kTurnsBetweenLooks = 1024;
  if (static_cast<double>(turns_) > options.limits.max_turns) {
    stop(span, fmt::format("loops and macro calls have made more than {:g} turns", options.limits.max_turns),
         "possible infinite loop; `--max-turns` raises the limit");
  }
  check_stop(span);
  next_look_ = turns_ + 1;
  const double left = options.limits.max_turns - static_cast<double>(turns_);
  if (left > kTurnsBetweenLooks) next_look_ = turns_ + kTurnsBetweenLooks;
}

void Context::nested_too_deeply(SourceSpan span, std::size_t units) {
  unnest(units);
  stop(span,
       fmt::format("expressions and macro calls are nested too deeply for a depth of {}", options.limits.max_depth),
       "`--max-depth` raises the limit");
}

void Context::check_stop(SourceSpan span) {
  if (is_set(run.stop)) stop(span, "interrupted");
}

void Context::count_primitive(SourceSpan span, std::size_t bytes) {
  if (++primitives_ > options.limits.max_primitives) {
    stop(span, fmt::format("the scene has more than {:g} primitives", options.limits.max_primitives),
         "`--max-primitives` raises the limit");
  }
  if ((static_cast<std::uint64_t>(primitives_) & 255u) == 0) check_stop(span);
  check_memory(span, bytes);
  memory.add(bytes);
}

void Context::count_debug(SourceSpan span, std::size_t bytes) {
  debug_bytes_ += bytes;
  const std::size_t limit = options.limits.max_debug_bytes;
  if (debug_bytes_ <= limit) return;
  stop(span, fmt::format("the scene prints more than {} bytes with `#debug`", limit),
       "possible infinite loop; `--max-debug` raises the limit");
}

void Context::no_memory_left(SourceSpan span) {
  stop(span,
       fmt::format("the scene takes more than {:.3g} GB of memory", static_cast<double>(run.budget->limit()) * 1e-9),
       "`--max-memory` raises the limit");
}

}  // namespace isl::interpreter
