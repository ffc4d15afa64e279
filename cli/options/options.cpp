// CLI11 reads the arguments; the messages are ours, so that all have one form.
#include "cli/options/options.h"

#include "cli/options/ini_options.h"
#include "cli/options/option_declarations.h"
#include "cli/options/output_options.h"
#include "cli/options/povray_switches.h"
#include "cli/output/printable_text.h"
#include "grammar/suggest.h"
#include "grammar/text_file.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

namespace isl::cli {
namespace {

constexpr std::array<std::string_view, 7> kCommands{"render", "check", "plan", "dump", "accuracy", "library", "help"};

/// Enough rays to measure the errors of a picture; a larger size only takes longer.
constexpr PictureSize kAccuracySize{400, 300};

Finished bad_command_line(std::string_view message, std::string_view hint = {}) {
  std::string text = fmt::format("isl: error: {}\n", visible_name(message));
  if (!hint.empty()) text += fmt::format("  hint: {}\n", visible_name(hint));
  return {ExitCode::command_line_error, std::move(text)};
}

/// "did you mean", or the list of options if it is short enough to help.
std::string similar_option(const CLI::App& app, const std::string& unknown) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  const std::vector<std::string_view> views(names.begin(), names.end());
  const auto found = grammar::closest(unknown.substr(0, unknown.find('=')), views);
  return found ? fmt::format("did you mean `{}`?", *found)
               : fmt::format("`isl {} --help` lists the options", app.get_name());
}

/// `found` is the one argument of its kind (`scene`) that the command takes.
std::optional<Finished> check_rest(const CLI::App& app, std::string_view kind, const std::string& found) {
  for (const std::string& rest : app.remaining()) {
    if (rest.size() > 1 && rest.front() == '-') {
      return bad_command_line(fmt::format("unknown option `{}`", rest), similar_option(app, rest));
    }
  }
  if (!app.remaining().empty()) {
    return bad_command_line(
        fmt::format("expected one {}, found `{}` after `{}`", kind, app.remaining().front(), found));
  }
  return std::nullopt;
}

std::optional<Finished> read_format(const std::string& text, OutputFormat& format) {
  if (text != "text" && text != "json") {
    return bad_command_line(fmt::format("--format: expected text or json, found `{}`", text));
  }
  format = text == "json" ? OutputFormat::json : OutputFormat::text;
  return std::nullopt;
}

std::optional<Finished> finish_scene_options(const CLI::App& app, const std::vector<std::string>& defines,
                                             const std::string& format, SceneOptions& scene) {
  for (const std::string& text : defines) {
    const auto define = parse_define(text);
    if (!define.ok()) return bad_command_line("-D: " + define.message());
    scene.defines.push_back(define.value());
  }
  if (app.count("--no-system-libraries") > 0 && app.count("--system-libraries-first") > 0) {
    return bad_command_line("--system-libraries-first: --no-system-libraries leaves these libraries out",
                            "leave out one of the two");
  }
  return read_format(format, scene.format);
}

std::optional<Finished> check_picture_options(const SceneOptions& scene, const PictureOptions& picture) {
  if (picture.crop && ((*picture.crop)[2] > scene.size.width || (*picture.crop)[3] > scene.size.height)) {
    return bad_command_line(fmt::format("--crop: {} reaches beyond the picture of {}x{} pixels",
                                        fmt::join(*picture.crop, ","), scene.size.width, scene.size.height));
  }
  if (picture.solver && picture.solver->name == render::SolverName::exact && picture.tolerance) {
    return bad_command_line("--tolerance: the solver exact takes no tolerance", "leave out one of the two");
  }
  if (picture.max_noise && (picture.samples || picture.aa_threshold)) {
    return bad_command_line(fmt::format("--max-noise: {} is another rule for the number of samples",
                                        picture.samples ? "--samples" : "--aa"),
                            "leave out one of the two");
  }
  if (const auto complaint = check_output_options(picture, scene.format)) {
    return bad_command_line(complaint->message, complaint->hint);
  }
  return std::nullopt;
}

/// CLI11's own errors, which are all of one kind here: an option without its value.
Finished from_cli11(const CLI::Error& error) {
  const std::string what = error.what();
  return bad_command_line(fmt::format("{} needs a value", what.substr(0, what.find(':'))));
}

std::optional<Finished> check_first_word(std::span<const std::string> arguments) {
  if (arguments.empty())
    return bad_command_line("no command given", "`isl render SCENE` renders a scene; `isl --help` lists the commands");
  if (const auto switches = find_povray_switches(arguments)) {
    std::string hint = fmt::format("isl's form is: {}", switches->equivalent);
    if (!switches->ignored.empty()) hint += fmt::format("  ({}: no counterpart)", switches->ignored);
    return bad_command_line(fmt::format("`{}` is a switch of POV-Ray's", switches->first), hint);
  }
  const std::string& word = arguments.front();
  if (word.starts_with('-') || std::find(kCommands.begin(), kCommands.end(), word) != kCommands.end())
    return std::nullopt;
  std::string hint = fmt::format("the commands are {}", fmt::join(kCommands, ", "));
  if (word.ends_with(".isl") || word.ends_with(".pov") || ini_name(word)) {
    hint = fmt::format("write `isl render {}`", word);
  } else if (word == "test") {
    hint = "`./isl test` in a source checkout builds and runs the tests";
  } else if (const auto similar = grammar::closest(word, kCommands)) {
    hint = fmt::format("did you mean `{}`?", *similar);
  }
  return bad_command_line(fmt::format("unknown command `{}`", word), hint);
}

/// Replaces `help` and `help COMMAND` by the options that CLI11 knows; keeps other arguments.
std::vector<std::string> with_help_as_option(std::span<const std::string> arguments) {
  if (arguments.empty() || arguments.front() != "help") return {arguments.begin(), arguments.end()};
  if (arguments.size() == 1 || arguments[1] == "help" || arguments[1].starts_with('-')) return {"--help"};
  return {arguments[1], "--help"};
}

/// Lets CLI11 read the arguments and converts its exceptions to a result.
std::optional<Finished> parse(CLI::App& app, std::span<const std::string> arguments) {
  // Only --help and --version may precede the command.
  const auto unknown_option = [](const std::string& option) {
    return bad_command_line(fmt::format("unknown option `{}`", option),
                            "write options after the command; `isl --help` lists the commands");
  };
  try {
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());  // CLI11 takes them from the back
    app.parse(reversed);
    return std::nullopt;
  } catch (const CLI::CallForHelp&) {
    return Finished{ExitCode::done, app.help()};
  } catch (const CLI::CallForVersion& version) {
    return Finished{ExitCode::done, std::string(version.what()) + "\n"};
  } catch (const BadValue& bad) {
    return bad_command_line(fmt::format("{}: {}", bad.option, bad.message));
  } catch (const CLI::RequiredError&) {
    if (app.get_subcommands().empty()) return unknown_option(arguments.front());
    return bad_command_line("no scene given",
                            fmt::format("write `isl {} SCENE`", app.get_subcommands().front()->get_name()));
  } catch (const CLI::ExtrasError&) {
    return unknown_option(arguments.front());
  } catch (const CLI::Error& error) {
    return from_cli11(error);
  }
}

/// Reads the settings of a scene that is an .ini file. Options of the command line override them.
std::optional<Finished> read_ini_file(const CLI::App& app, SceneOptions& scene, PictureOptions& picture) {
  constexpr std::size_t kMaxBytes = 1 << 20;  // more than any settings need
  const std::optional<IniName> name = ini_name(scene.scene);
  if (!name) return std::nullopt;
  grammar::TextFile file = grammar::read_text_file(name->file, kMaxBytes);
  if (!file.trouble.empty()) {
    const std::string hint = file.hint.empty() ? "" : fmt::format("  hint: {}\n", file.hint);
    return Finished{ExitCode::file_error, fmt::format("isl: error: cannot read `{}`: {}\n{}",
                                                      visible_name(name->file.string()), file.trouble, hint)};
  }
  const auto is_said = [&app](const std::string& option) {
    const CLI::Option* const found = app.get_option_no_throw(option);
    return found != nullptr && found->count() > 0;
  };
  apply_ini(*name, std::move(file.text), is_said, scene, picture);
  return std::nullopt;
}

std::optional<DumpStage> stage_named(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, DumpStage>, 4> kStages{{{"tokens", DumpStage::tokens},
                                                                           {"ast", DumpStage::ast},
                                                                           {"database", DumpStage::database},
                                                                           {"grid", DumpStage::grid}}};
  for (const auto& [stage_name, stage] : kStages) {
    if (stage_name == name) return stage;
  }
  return std::nullopt;
}

Command library_command(const CLI::App& app, const RawOptions& raw) {
  LibraryCommand command{raw.library_name};
  if (auto finished = check_rest(app, "name", raw.library_name)) return *std::move(finished);
  if (auto finished = read_format(raw.format, command.format)) return *std::move(finished);
  return command;
}

}  // namespace

Command parse_command_line(std::span<const std::string> given) {
  const std::vector<std::string> arguments = with_help_as_option(given);
  if (auto finished = check_first_word(arguments)) return *std::move(finished);

  CLI::App app("Renders scenes of implicit surfaces, written in a small language in the style of POV-Ray's.", "isl");
  RawOptions raw;
  raw.scene.limits.max_memory_bytes = parse_memory("75%").value();
  declare_options(app, raw, arguments.front());
  if (auto finished = parse(app, arguments)) return *std::move(finished);

  const CLI::App& command = *app.get_subcommands().front();
  if (command.get_name() == "library") return library_command(command, raw);
  SceneOptions& scene = raw.scene;
  if (auto finished = check_rest(command, "scene", scene.scene.string())) return *std::move(finished);
  if (auto finished = finish_scene_options(command, raw.defines, raw.format, scene)) return *std::move(finished);
  if (command.get_name() == "accuracy" && command.count("--size") == 0) scene.size = kAccuracySize;
  scene.is_size_known = command.count("--size") > 0 || command.get_name() == "render";
  scene.named_folders = scene.include_paths;
  scene.named_folders.insert(scene.named_folders.end(), scene.read_folders.begin(), scene.read_folders.end());
  if (auto finished = read_ini_file(command, scene, raw.picture)) return *std::move(finished);
  if (command.get_name() == "check") return CheckCommand{std::move(scene)};
  if (command.get_name() == "plan") return PlanCommand{std::move(scene), raw.plan_quality, raw.plan_measure};
  if (command.get_name() == "render") {
    if (auto finished = check_picture_options(scene, raw.picture)) return *std::move(finished);
    return RenderCommand{std::move(scene), std::move(raw.picture)};
  }
  if (command.get_name() == "accuracy") {
    for (const std::string& text : raw.settings) {
      const auto setting = parse_setting(text);
      if (!setting.ok()) return bad_command_line("--setting: " + setting.message());
      raw.accuracy.settings.push_back(setting.value());
    }
    raw.accuracy.scene = std::move(scene);
    return std::move(raw.accuracy);
  }
  const std::optional<DumpStage> stage = stage_named(raw.stage);
  if (!stage) {
    return bad_command_line(fmt::format("--stage: expected tokens, ast, database or grid, found `{}`", raw.stage));
  }
  return DumpCommand{std::move(scene), *stage};
}

}  // namespace isl::cli
