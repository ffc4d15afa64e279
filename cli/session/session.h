// One scene, read and evaluated once: every command starts with it. Owns everything that spans and symbols point into.
#pragma once

#include "base/diagnostic.h"
#include "base/files/output_set.h"
#include "base/run_limits.h"
#include "cli/options/options.h"
#include "cli/output/exit_code.h"
#include "grammar/arena.h"
#include "grammar/loader.h"
#include "grammar/source_map.h"
#include "grammar/symbols.h"
#include "interpreter/evaluate.h"
#include "renderer/image/image_library.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace isl::cli {

class Session {
 public:
  explicit Session(const SceneOptions& options);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Parses the scene's file and reports its errors, except those in branches and bodies, which only execution reaches.
  ExitCode load_text();

  /// Parses the scene's file and executes it, which reports the errors that it reaches; the code of the stop flag's
  /// reason if that was set meanwhile.
  ExitCode evaluate();

  /// Precondition: one of the above got as far as a unit, evaluate() as far as a database.
  [[nodiscard]] const grammar::Unit& unit() const;
  [[nodiscard]] const interpreter::EvaluatedScene& scene() const;

  [[nodiscard]] const SceneOptions& options() const { return options_; }
  /// The memory, time and steps that are left to this run. Everything that works on the scene gets them.
  [[nodiscard]] const RunLimits& limits() const { return limits_; }
  /// The scene's images, decoded when the first part of the program needs them.
  [[nodiscard]] render::ImageSource& images() { return images_; }
  [[nodiscard]] DiagnosticSink& sink() { return sink_; }
  [[nodiscard]] const grammar::SourceMap& sources() const { return sources_; }
  [[nodiscard]] grammar::SymbolTable& symbols() { return symbols_; }

  /// All that the run writes, those files of the scene included that were written without errors. They take their
  /// places when the command commits them.
  [[nodiscard]] OutputSet& outputs() { return *outputs_; }

  /// The base name of the picture: the file's name without folder and extension; "stdin" for standard input.
  [[nodiscard]] std::string name() const;
  /// The scene's name as the user gave it, for messages.
  [[nodiscard]] std::string display_name() const;

  /// Every file that the scene depends on, in the order of first use.
  [[nodiscard]] const std::vector<grammar::UsedFile>& used_files() const { return loader_.used_files(); }

  /// Seconds of parsing and executing; files included are read and parsed while evaluating.
  [[nodiscard]] double parse_seconds() const { return parse_seconds_; }
  [[nodiscard]] double evaluate_seconds() const { return evaluate_seconds_; }

 private:
  /// Any code but `done`: the file could not be read, or not be parsed.
  ExitCode load();
  /// Reports the first of the option's paths that is not a folder.
  bool are_folders(std::string_view option, std::span<const std::filesystem::path> paths);
  /// Notes the shared folders that the command line names, and tells that.
  void remember();
  void tell(const IniText& ini);
  /// The files that the command line names; others are noted when they are read.
  void note_inputs();
  void check_result();
  void warn_of_faint_components();

  const SceneOptions& options_;
  std::shared_ptr<OutputSet> outputs_ = std::make_shared<OutputSet>();
  Budget budget_;
  RunLimits limits_;
  render::ImageLibrary images_{limits_};
  grammar::SourceMap sources_;
  grammar::SymbolTable symbols_;
  grammar::Arena arena_;
  DiagnosticSink sink_;
  grammar::Loader loader_;
  const grammar::Unit* unit_ = nullptr;
  std::optional<interpreter::EvaluatedScene> scene_;
  double parse_seconds_ = 0;
  double evaluate_seconds_ = 0;
};

}  // namespace isl::cli
