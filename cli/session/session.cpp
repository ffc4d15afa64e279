#include "cli/session/session.h"

#include "base/check.h"
#include "cli/output/console.h"
#include "cli/output/run_end.h"
#include "cli/output/stopwatch.h"
#include "cli/session/search_path.h"
#include "cli/session/shared_folders.h"
#include "renderer/queries/faint.h"
#include "renderer/queries/object_queries.h"

#include <fmt/format.h>

#include <unistd.h>

#include <filesystem>
#include <system_error>

namespace isl::cli {

namespace {

/// The folders below which the scene may read: those that the command line names, and the shared folder of the scene.
std::vector<std::filesystem::path> readable_folders(const SceneOptions& options) {
  std::vector<std::filesystem::path> folders = options.read_folders;
  if (options.scene == "-") return folders;
  if (std::filesystem::path shared = shared_folder_of(options.scene); !shared.empty())
    folders.push_back(std::move(shared));
  return folders;
}

}  // namespace

Session::Session(const SceneOptions& options)
    : options_(options),
      budget_(options.limits.max_memory_bytes),
      limits_{&budget_, &stop_flag(), interpreter::steps_at_point(options.limits), options.steps_of_ray},
      loader_(sources_, symbols_, arena_, sink_,
              {.folders = {.search_path = include_search_path(options.include_paths, options.system_libraries),
                           .read = readable_folders(options),
                           .write = options.write_folders},
               .outputs = outputs_,
               .run = limits_}) {
  note_inputs();
  if (options.max_seconds) end_after(*options.max_seconds);
  if (options.ini) tell(*options.ini);
}

void Session::note_inputs() {
  FileRegister& files = outputs_->files();
  if (options_.ini) files.add_input(identity_of(options_.ini->name), "the file of options");
  if (options_.scene != "-") {
    files.add_input(identity_of(options_.scene), "the scene");
  } else if (const auto redirected = identity_of_stream(STDIN_FILENO)) {
    files.add_input(*redirected, "the scene");
  }
}

void Session::tell(const IniText& ini) {
  const std::optional<SourceSpan> text = sources_.add(ini.name, ini.text);
  ISL_CHECK(text.has_value(), "{}", ini.text.size());
  for (const IniRemark& remark : ini.remarks) {
    const auto offset = [&](std::size_t place) { return text->begin + static_cast<std::uint32_t>(place); };
    sink_.report({remark.severity, {offset(remark.begin), offset(remark.end)}, remark.message, remark.hint, {}, {}});
  }
}

std::string Session::name() const { return options_.scene == "-" ? "stdin" : options_.scene.stem().string(); }

std::string Session::display_name() const { return options_.scene == "-" ? "standard input" : options_.scene.string(); }

const grammar::Unit& Session::unit() const {
  ISL_CHECK(unit_ != nullptr);
  return *unit_;
}

const interpreter::EvaluatedScene& Session::scene() const {
  ISL_CHECK(scene_.has_value());
  return *scene_;
}

bool Session::are_folders(std::string_view option, std::span<const std::filesystem::path> paths) {
  for (const std::filesystem::path& path : paths) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) continue;
    sink_.error({}, fmt::format("{}: `{}` is not a folder", option, path.string()));
    return false;
  }
  return true;
}

void Session::remember() {
  for (const NewSharedFolder& added : remember_shared_folders(options_.named_folders)) {
    const std::string found = fmt::format("`{}` has an `{}`", added.folder.string(), grammar::kSharedFolderMark);
    if (added.trouble.empty()) {
      sink_.report({Severity::note,
                    {},
                    fmt::format("{}: from now on, every scene below it may read it", found),
                    fmt::format("`{}` lists such folders", shared_folders_list().string()),
                    {},
                    {}});
    } else {
      sink_.warning({}, fmt::format("{}, but cannot be remembered: {}", found, added.trouble));
    }
  }
}

ExitCode Session::load() {
  if (sink_.has_errors()) return ExitCode::command_line_error;
  if (!are_folders("--allow-read", options_.read_folders) || !are_folders("--allow-write", options_.write_folders))
    return ExitCode::file_error;
  for (const std::filesystem::path& folder : options_.include_paths) {
    std::error_code error;
    if (!std::filesystem::is_directory(folder, error))
      sink_.warning({}, fmt::format("the search path names `{}`, which is not a folder", folder.string()));
  }
  remember();
  const Stopwatch stopwatch;
  unit_ = loader_.load_scene(options_.scene);
  parse_seconds_ = stopwatch.seconds();
  if (stop_flag().is_set()) return exit_code_of(stop_flag().reason());
  // No tree means that there was no text to parse (missing, not readable, not text), or more than the limit allows.
  if (unit_ == nullptr && loader_.last_error() != grammar::LoadError::too_large) return ExitCode::file_error;
  return sink_.has_errors() ? ExitCode::scene_error : ExitCode::done;
}

ExitCode Session::load_text() {
  if (const ExitCode code = load(); code != ExitCode::done) return code;
  for (const grammar::Complaint* complaint : unit_->errors) sink_.report(complaint->diagnostic);
  return sink_.has_errors() ? ExitCode::scene_error : ExitCode::done;
}

ExitCode Session::evaluate() {
  if (const ExitCode code = load(); code != ExitCode::done) return code;
  interpreter::EvaluateOptions options;
  options.limits = options_.limits;
  options.defines = options_.defines;
  options.lenient = options_.lenient;
  options.clock = options_.clock;
  options.clock_on = options_.clock_on;
  options.frame = options_.frame;
  options.image_width = options_.size.width;
  options.image_height = options_.size.height;
  options.is_size_known = options_.is_size_known;
  options.print_debug = [](std::string_view text) { print_content(Stream::error, text); };
  options.run = limits_;
  render::ObjectQueries queries(limits_);
  options.queries = &queries;
  options.images = &images_;

  const Stopwatch stopwatch;
  scene_ = interpreter::evaluate(loader_, symbols_, *unit_, options, sink_);
  evaluate_seconds_ = stopwatch.seconds();
  if (stop_flag().is_set()) return exit_code_of(stop_flag().reason());
  if (!sink_.has_errors()) check_result();
  return sink_.has_errors() ? ExitCode::scene_error : ExitCode::done;
}

/// Checks that need the whole scene.
void Session::check_result() {
  const scene::Database& database = scene_->database;
  warn_of_faint_components();
  const scene::Settings& settings = database.settings;
  const auto complain = [this](const auto& parsed, OriginId place) {
    if (parsed.ok()) return;
    const interpreter::Origin origin = scene_->origins.resolve(place);
    sink_.report({Severity::error, origin.span, "global_settings: " + parsed.message(), {}, {}, origin.chain});
  };
  if (!settings.solver.empty()) complain(parse_solver(settings.solver), settings.solver_origin);
  if (!settings.tolerance.empty()) complain(parse_tolerance(settings.tolerance), settings.tolerance_origin);
  if (database.objects.empty()) sink_.warning({}, fmt::format("{} holds no object", display_name()));
}

void Session::warn_of_faint_components() {
  const std::optional<render::FaintComponents> faint = render::faint_components(scene_->database);
  if (!faint) return;
  const interpreter::Origin origin = scene_->origins.resolve(faint->first);
  const char* const what =
      faint->skeleton == scene::Skeleton::circle ? "`torus` is too small" : "`cylinder` is too short";
  Diagnostic warning{Severity::warning,
                     origin.span,
                     fmt::format("this {} to have a surface by itself: convolved, it reaches {:.3g} of the threshold",
                                 what, faint->greatest),
                     {},
                     {},
                     origin.chain};
  if (faint->count > 1) warning.hint = fmt::format("{} components have none, this is the first", faint->count);
  sink_.report(std::move(warning));
}

}  // namespace isl::cli
