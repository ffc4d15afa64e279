// What every part of one evaluation shares: names, the stack of frames, the database in the making, and the ways to
// complain. Parts of the interpreter are functions that take a Context; it knows no construct of the language itself.
#pragma once

#include "base/diagnostic.h"
#include "grammar/ast.h"
#include "grammar/loader.h"
#include "grammar/symbols.h"
#include "interpreter/evaluate.h"
#include "interpreter/frames.h"
#include "interpreter/language_version.h"
#include "interpreter/open_files.h"
#include "interpreter/random_streams.h"
#include "interpreter/record_table.h"
#include "interpreter/shared_values.h"

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace isl::interpreter {

/// Thrown after a user error was reported: the statement that holds it is given up, the scene is read on.
struct Failed {};
/// Thrown after an error beyond which reading on makes no sense (a limit, #error, a missing include, too many errors).
struct Stopped {};

/// What one primitive's origin takes, about: its record and a link of its chain.
inline constexpr std::size_t kOriginBytes = 40;

/// The words of ours that are not reserved: they mean something only where a reader looks for them.
struct ContextualWords {
  explicit ContextualWords(grammar::SymbolTable& symbols);
  grammar::Symbol kernel, hardness, convolution, skeleton, solver, tolerance;
  grammar::Symbol hf;  ///< `.hf` of a pigment function: a height coded in red and green
};

class Context {
 public:
  Context(grammar::Loader& loader, grammar::SymbolTable& symbols, const grammar::Unit& unit,
          const EvaluateOptions& options, DiagnosticSink& sink);

  grammar::Loader& loader;
  grammar::SymbolTable& symbols;
  const grammar::Unit& main_unit;
  const EvaluateOptions& options;

  const ContextualWords words;
  MemoryAccount memory;
  Scopes scopes;
  std::vector<Frame> frames;
  std::vector<Slot*> argument_slots;  ///< of macro calls whose arguments are being evaluated
  RandomStreams random;
  OpenFiles files;
  scene::Database database;
  OriginTable origins;
  LanguageVersion version;
  bool has_noise_generator = false;  ///< the scene says which
  /// What #default says now; what an object without a texture of its own gets.
  scene::Texture default_texture;
  bool has_default_texture = false;
  Ref<CameraValue> default_camera;  ///< null: POV-Ray's own
  RecordTable<scene::Texture> texture_table;
  RecordTable<scene::Finish> finish_table;
  RecordTable<scene::Interior> interior_table;
  /// POV-Ray's own maps that the scene has come to need, by where their entries are.
  std::map<std::pair<const void*, std::size_t>, scene::PigmentMapId> default_maps;

  // ---- Complaints: each adds the macro and include chain ------------------------------------------------------------

  [[noreturn]] void fail(SourceSpan span, std::string message, std::string hint = {});
  [[noreturn]] void stop(SourceSpan span, std::string message, std::string hint = {});
  /// Reports and goes on; stops when there are too many.
  void error(SourceSpan span, std::string message, std::string hint = {});
  /// Reports, once for each place and text: a loop may warn a million times.
  void warn(SourceSpan span, std::string message, std::string hint = {});
  /// What is wrong with the text is reached: tells it, once, and fails where it stands for what could not be parsed.
  void meet(const grammar::Error& node);
  /// Tells a complaint about the text, unless that was done.
  void tell(const grammar::Complaint& complaint);
  /// At the end: tells what is wrong with the texts for certain, unless errors were told. What is skipped with --lenient
  /// is not executed.
  void tell_rest();
  /// The allocator gave up before the limit was reached.
  void report_out_of_memory();
  /// "`media` is not supported": an error, or with --lenient a warning. The caller skips the thing.
  void unsupported(SourceSpan span, std::string_view thing);

  /// The scene's, 1 to 3; where it does not say, the first for what was written for POV-Ray before 3.5.
  [[nodiscard]] int noise_generator() const {
    if (has_noise_generator) return database.settings.noise_generator;
    return version.number() < 3.5 ? 1 : 2;
  }

  // ---- Names --------------------------------------------------------------------------------------------------------

  [[nodiscard]] std::string_view text(grammar::Symbol symbol) const { return symbols.text(symbol); }
  /// Which file of the search path declares the name, or "did you mean `sphere`?" for the nearest declared name, or
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

  /// One more turn of a loop, or one more macro call: two calls in a macro double with every depth, and end as late as
  /// a loop does.
  void count_turn(SourceSpan span) {
    if (++turns_ >= next_look_) [[unlikely]]
      look_at_turns(span);
  }
  /// One more component, solid, group or light that takes `bytes`.
  void count_primitive(SourceSpan span, std::size_t bytes);
  /// Before something of `bytes` is made.
  void check_memory(SourceSpan span, std::size_t bytes);
  /// Counts what the loader keeps of files read since it held so many bytes.
  void charge_texts(SourceSpan span, std::size_t held_before);
  /// Native recursion, in units of kNestingBytes of stack (interpreter/nesting.h).
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
  void look_at_turns(SourceSpan span);
  [[noreturn]] void nested_too_deeply(SourceSpan span, std::size_t units);
  void check_stop(SourceSpan span);
  [[nodiscard]] OriginTable::Chain chain_of(std::uint32_t call);
  OriginTable::Chain make_chain(std::uint32_t call, OriginTable::Chain outer);

  DiagnosticSink& sink_;
  std::set<const grammar::Complaint*> told_;  ///< of the texts' own complaints
  std::set<std::tuple<std::uint32_t, std::uint32_t, std::string>> warnings_;  ///< said already
  std::size_t depth_ = 0;
  std::uint64_t turns_ = 0;
  std::uint64_t next_look_ = 1;  ///< at turns_
  double primitives_ = 0;
  std::size_t nesting_ = 0;
  std::size_t max_nesting_;
};

// ---- What every macro call and branch does --------------------------------------------------------------------------

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
