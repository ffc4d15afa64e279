// The state that all parts of one evaluation share: names, the stack of frames, the database in the making, and the
// functions that report. Parts of the interpreter are functions that take a Context; it knows no construct of the
// language.
#pragma once

#include "base/diagnostic.h"
#include "grammar/ast.h"
#include "grammar/loader.h"
#include "grammar/symbols.h"
#include "interpreter/evaluate.h"
#include "interpreter/fonts/font_shelf.h"
#include "interpreter/frames.h"
#include "interpreter/language_version.h"
#include "interpreter/open_files.h"
#include "interpreter/random_streams.h"
#include "interpreter/record_table.h"
#include "interpreter/routines/routine_table.h"
#include "interpreter/shared_values.h"
#include "interpreter/value_depths.h"

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace isl::interpreter {

/// Thrown after a warning: a number of an object or component is infinite or not a number, so that it is left out.
struct LeftOut {};
/// Thrown after a user error was reported: the statement with the error is given up, and reading goes on after it.
struct Failed {};
/// Thrown after an error beyond which reading on makes no sense (a limit, #error, a missing include, too many errors).
struct Stopped {};

/// Approximate size of one primitive's origin: its record and a link of its chain.
inline constexpr std::size_t kOriginBytes = 40;

/// Our words that are not reserved: they have a meaning only where a reader looks for them.
struct ContextualWords {
  explicit ContextualWords(grammar::SymbolTable& symbols);
  grammar::Symbol kernel, hardness, convolution, skeleton, solver, tolerance;
  grammar::Symbol hf;  ///< `.hf` of a pigment function: a height coded in red and green
};

class Context {
 public:
  Context(grammar::Loader& loader, grammar::SymbolTable& symbols, const grammar::Unit& unit,
          const EvaluateOptions& options, const RunLimits& run, MemoryAccount& memory, DiagnosticSink& sink);

  grammar::Loader& loader;
  grammar::SymbolTable& symbols;
  const grammar::Unit& main_unit;
  const EvaluateOptions& options;
  const RunLimits run;

  const ContextualWords words;
  MemoryAccount& memory;
  Scopes scopes;
  std::vector<Frame> frames;
  static constexpr std::size_t kNoStream = SIZE_MAX;
  /// Index of the bottom frame of the ElementStream that is being read.
  std::size_t stream_base = kNoStream;
  std::string_view left_out;         ///< what a LeftOut leaves out, in messages; empty if nobody catches it
  std::size_t abandoned_blocks = 0;  ///< after errors: blocks that no stream reads and whose `}` is still to come
  const grammar::Node* argument = nullptr;  ///< of a macro call, while it is evaluated (operators.h, TermsApart)
  std::vector<Slot*> argument_slots;        ///< for macro calls whose arguments are being evaluated
  RandomStreams random;
  OpenFiles files;
  FontShelf fonts;
  scene::Database database;
  render::ImageTable images;  ///< those of the database that called functions may look at
  ValueDepths depths;
  OriginTable origins;
  RoutineTable routines;
  LanguageVersion version;
  std::set<grammar::Symbol> noted_words;  ///< words of POV-Ray 3.8 that were remarked on
  bool has_noise_generator = false;       ///< the scene sets it
  /// The present #default texture; an object without a texture of its own gets it.
  scene::Texture default_texture;
  bool has_default_texture = false;
  bool is_default_stated = false;   ///< by the scene, so that `#version` no longer changes it
  Ref<CameraValue> default_camera;  ///< null: POV-Ray's own
  RecordTable<scene::Texture> texture_table;
  RecordTable<scene::Finish> finish_table;
  RecordTable<scene::Interior> interior_table;
  /// POV-Ray's built-in maps that the scene uses so far, by the address of their entries.
  std::map<std::pair<const void*, std::size_t>, scene::PigmentMapId> default_maps;

  // ---- Diagnostics: each adds the macro and include chain -----------------------------------------------------------

  [[noreturn]] void fail(SourceSpan span, std::string message, std::string hint = {});
  [[noreturn]] void stop(SourceSpan span, std::string message, std::string hint = {});
  /// `message` tells of a number that is infinite or not a number. In what can be left out it is a warning, and LeftOut
  /// is thrown.
  [[noreturn]] void fail_not_finite(SourceSpan span, const std::string& message);
  /// Reports and goes on; throws Stopped when there are too many.
  void error(SourceSpan span, std::string message, std::string hint = {});
  /// Reports once for each place and text: a loop may warn a million times.
  void warn(SourceSpan span, std::string message, std::string hint = {});
  /// The same for a remark.
  void note(SourceSpan span, std::string message, std::string hint = {});
  /// Execution reached a mistake in the text: reports it, once, and fails if the node replaces text that could not be
  /// parsed.
  void meet(const grammar::Error& node);
  /// Reports a complaint about the text, unless it was reported.
  void tell(const grammar::Complaint& complaint);
  /// Called at the end: reports the certain mistakes of the texts, unless there were errors. Statements skipped with
  /// --lenient are not executed.
  void tell_rest();
  [[nodiscard]] bool has_errors() const { return sink_.has_errors(); }
  /// Called when the allocator gave up before the limit was reached.
  void report_out_of_memory();
  /// "`media` is not supported": an error, or with --lenient a warning. The caller skips it.
  void unsupported(SourceSpan span, std::string_view thing);

  /// The scene's generator, 1 to 3; if it sets none, the first for a scene that was written for POV-Ray before 3.5.
  [[nodiscard]] int noise_generator() const {
    if (has_noise_generator) return database.settings.noise_generator;
    return version.number() < 3.5 ? 1 : 2;
  }

  // ---- Names --------------------------------------------------------------------------------------------------------

  [[nodiscard]] std::string_view text(grammar::Symbol symbol) const { return symbols.text(symbol); }
  /// The file of the search path that declares the name, or "did you mean `sphere`?" for the nearest declared name, or
  /// empty.
  [[nodiscard]] std::string suggest_declared(grammar::Symbol name) const;
  /// "`White` is declared in `colors.inc`", or empty.
  [[nodiscard]] std::string hint_of_library(grammar::Symbol name) const;

  // ---- Frames -------------------------------------------------------------------------------------------------------

  /// Pushes a frame over `items`. Blocks count as depth at `span`.
  Frame& push(Frame::Kind kind, grammar::Items items, const grammar::Node* node, SourceSpan span);
  /// Pushes the frame of a macro call or an include; macro calls count as depth. The caller enters its scope.
  void push_call(Frame::Kind kind, grammar::Items items, const grammar::Node& node, const grammar::Unit& unit,
                 std::uint32_t origin_name);
  /// Ends the innermost frame and, for a call, its scope.
  void pop();
  /// The file whose text is being executed.
  [[nodiscard]] const grammar::Unit& current_unit() const;
  [[nodiscard]] std::vector<ExpansionFrame> chain() const;

  // ---- Limits -------------------------------------------------------------------------------------------------------

  /// Counts one more turn of a loop, or one more macro call: a macro with two recursive calls doubles them with every
  /// depth, and so takes as long as an endless loop.
  void count_turn(SourceSpan span) {
    if (++turns_ >= next_look_) [[unlikely]]
      look_at_turns(span);
  }
  /// Counts one more component, solid, group or light that takes `bytes`.
  void count_primitive(SourceSpan span, std::size_t bytes);
  /// Called before an allocation of `bytes`.
  void check_memory(SourceSpan span, std::size_t bytes) {
    if (!memory.make_room(bytes)) [[unlikely]]
      no_memory_left(span);
  }
  /// Called now and then by work that takes long: ends the evaluation if the run is stopped.
  void check_stop(SourceSpan span);
  /// Fails if a value that was just read is deeper than values may be (renderer/scene/value_depth.h).
  void check_value_depth(SourceSpan span, std::uint32_t depth) {
    if (depth > scene::kMaxValueDepth) [[unlikely]]
      value_too_deep(span);
  }
  /// Counts the bytes that the scene is about to print.
  void count_debug(SourceSpan span, std::size_t bytes);
  /// Counts native recursion, in units of kNestingBytes of stack (interpreter/nesting.h).
  void nest(SourceSpan span, std::size_t units) {
    if ((nesting_ += units) > max_nesting_) [[unlikely]]
      nested_too_deeply(span, units);
  }
  void unnest(std::size_t units) { nesting_ -= units; }

  // ---- The database -------------------------------------------------------------------------------------------------

  [[nodiscard]] OriginId origin(SourceSpan span);

 private:
  void count_depth(SourceSpan span) {
    if (depth_ >= options.limits.max_depth) [[unlikely]]
      too_deep(span);
    ++depth_;
  }
  [[noreturn]] void too_deep(SourceSpan span);
  [[noreturn]] void value_too_deep(SourceSpan span);
  void look_at_turns(SourceSpan span);
  [[noreturn]] void nested_too_deeply(SourceSpan span, std::size_t units);
  [[noreturn]] void no_memory_left(SourceSpan span);
  /// Records the message at its place; true if the same message was recorded there before.
  [[nodiscard]] bool is_said(Severity severity, SourceSpan span, const std::string& message);
  [[nodiscard]] OriginTable::Chain chain_of(std::uint32_t call);
  OriginTable::Chain make_chain(std::uint32_t call, OriginTable::Chain outer);

  DiagnosticSink& sink_;
  std::set<const grammar::Complaint*> told_;                                        ///< complaints of the texts
  std::set<std::tuple<Severity, std::uint32_t, std::uint32_t, std::string>> said_;  ///< already reported
  std::size_t repeated_errors_ = 0;  ///< errors that were found again at their place, and not told again
  std::size_t depth_ = 0;
  std::uint64_t turns_ = 0;
  std::uint64_t next_look_ = 1;  ///< value of turns_ at the next look
  double primitives_ = 0;
  std::size_t debug_bytes_ = 0;
  std::size_t nesting_ = 0;
  std::size_t max_nesting_;
};

// ---- Inline: every macro call and branch runs these -----------------------------------------------------------------

inline Frame& Context::push(Frame::Kind kind, grammar::Items items, const grammar::Node* node, SourceSpan span) {
  if (kind == Frame::Kind::block) count_depth(span);
  const std::uint32_t call = frames.empty() ? Frame::kNoCall : frames.back().call;
  Frame& frame = frames.emplace_back();
  frame.kind = kind;
  frame.call = call;
  frame.node = node;
  frame.set_items(items);
  return frame;
}

inline void Context::push_call(Frame::Kind kind, grammar::Items items, const grammar::Node& node,
                               const grammar::Unit& unit, std::uint32_t origin_name) {
  if (kind == Frame::Kind::macro) count_depth(node.span);
  const auto call = static_cast<std::uint32_t>(frames.size());
  Frame& frame = frames.emplace_back();
  frame.kind = kind;
  frame.call = call;
  frame.node = &node;
  frame.set_items(items);
  frame.called = {&unit, origin_name, Frame::kNoChain};
}

inline void Context::pop() {
  const Frame::Kind kind = frames.back().kind;
  frames.pop_back();
  if (kind == Frame::Kind::macro || kind == Frame::Kind::include) scopes.leave();
  if (kind == Frame::Kind::macro || kind == Frame::Kind::block) --depth_;
}

}  // namespace isl::interpreter
