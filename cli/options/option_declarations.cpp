#include "cli/options/option_declarations.h"

#include "cli/options/aovs.h"
#include "cli/options/option_values.h"
#include "cli/output/version.h"
#include "renderer/effects/effect.h"
#include "renderer/render.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string_view>

namespace isl::cli {
namespace {

constexpr std::string_view kFooter =
    "Exit codes: 0 done, 1 the scene has errors, 2 the command line has errors,\n"
    "            3 a file could not be read or written, 130 interrupted,\n"
    "            75 ended by SIGTERM, SIGHUP or --max-time";

/// An option whose text `parse` turns into a value for `store`; if it is given twice, the last one counts.
template <class Parse, class Store>
CLI::Option* add(CLI::App& app, const std::string& names, const std::string& type, const std::string& help, Parse parse,
                 Store store) {
  const auto read = [names, parse, store](const std::string& text) {
    const auto parsed = parse(text);
    if (!parsed.ok())
      throw BadValue{names.substr(names.find("--") == std::string::npos ? 0 : names.find("--")), parsed.message()};
    store(parsed.value());
  };
  return app.add_option_function<std::string>(names, read, help)->type_name(type)->take_last();
}

/// An option that may be given several times, with one value each time.
template <class T>
CLI::Option* add_list(CLI::App& app, const std::string& names, const std::string& type, const std::string& help,
                      std::vector<T>& values) {
  return app.add_option(names, values, help)->type_name(type)->allow_extra_args(false);
}

auto integer_from(std::int64_t low, std::int64_t high) {
  return [low, high](const std::string& text) { return parse_integer(text, low, high); };
}

auto number_from(double low, double high) {
  return [low, high](const std::string& text) { return parse_number(text, low, high); };
}

std::vector<std::string_view> names_of(const render::Aovs& aovs) {
  std::vector<std::string_view> names;
  for (const render::Aov* const aov : aovs) names.push_back(aov->name);
  return names;
}

/// In the order of all_aovs(), each once.
Parsed<render::Aovs> parse_layers(std::string_view text) {
  const Parsed<std::vector<std::string_view>> names = parse_names(text, "layer", names_of(all_aovs()));
  if (!names.ok()) return Parsed<render::Aovs>::error(names.message());
  render::Aovs layers;
  for (const render::Aov* const aov : all_aovs()) {
    if (std::ranges::find(names.value(), aov->name) != names.value().end()) layers.push_back(aov);
  }
  return layers;
}

Parsed<std::vector<std::string_view>> parse_effects(std::string_view text) {
  std::vector<std::string_view> known;
  for (const render::Effect& effect : render::all_effects()) known.push_back(effect.name);
  return parse_names(text, "effect", known);
}

/// The layers that are written as pictures of their own, too.
render::Aovs pictured_aovs() {
  render::Aovs pictured = all_aovs();
  std::erase_if(pictured, [](const render::Aov* aov) { return aov->picture.kind == render::AovPicture::Kind::none; });
  return pictured;
}

Parsed<int> parse_bits(const std::string& text) {
  if (text == "8") return 8;
  if (text == "16") return 16;
  return Parsed<int>::error(fmt::format("expected 8 or 16, found `{}`", text));
}

CLI::Option* add_format(CLI::App& app, std::string& format) {
  return app.add_option("--format", format, "Form of results and problems: text, or one JSON document [text]")
      ->type_name("text|json");
}

void add_scene_options(CLI::App& app, SceneOptions& scene, std::vector<std::string>& defines, std::string& format) {
  app.add_option("SCENE", scene.scene,
                 "The scene's file, .isl or .pov; or a file of options, .ini or .ini[SECTION]; `-` is standard input")
      ->type_name("")
      ->required();
  const std::string group = "The scene";
  add_list(app, "-I,--include", "DIR", "Add DIR to the search path; files in other folders cannot be read",
           scene.include_paths)
      ->group(group);
  add_list(app, "--allow-read", "DIR", "Let the scene read files below DIR, without searching there",
           scene.read_folders)
      ->group(group);
  app.add_flag_callback(
         "--no-system-libraries", [&scene] { scene.system_libraries = SystemLibraries::none; },
         "Do not search the system's copy of POV-Ray's include files")
      ->group(group);
  app.add_flag_callback(
         "--system-libraries-first", [&scene] { scene.system_libraries = SystemLibraries::before_ours; },
         "Search the system's copy of POV-Ray's include files before isl's files of the same names")
      ->group(group);
  add_list(app, "--allow-write", "DIR", "Let #fopen write files below DIR; may be given again [no writing]",
           scene.write_folders)
      ->group(group);
  add_list(app, "-D,--define", "NAME=VALUE", "Set a number or string before the scene's first line", defines)
      ->group(group);
  app.add_flag("--lenient", scene.lenient, "Skip unsupported features with a warning instead of an error")
      ->group(group);
  app.add_option_function<std::vector<std::string>>(
         "--without",
         [&scene](const std::vector<std::string>& lists) {
           for (const std::string& list : lists) {
             const auto names = parse_effects(list);
             if (!names.ok()) throw BadValue{"--without", names.message()};
             scene.without.insert(scene.without.end(), names.value().begin(), names.value().end());
           }
         },
         "Leave these effects out; `isl plan SCENE` lists their names")
      ->type_name("EFFECT,...")
      ->allow_extra_args(false)
      ->group(group);
  add(app, "--clock", "T", "Set the variable clock [0]", number_from(-kUnbounded, kUnbounded), [&scene](double v) {
    scene.clock = v;
    scene.clock_on = true;
  })->group(group);
  add(app, "--frame", "N", "Frame of an animation: sets the variable frame_number [0: none]",
      integer_from(0, std::numeric_limits<int>::max()),
      [&scene](std::int64_t v) {
        scene.frame = static_cast<int>(v);
        scene.clock_on = true;
      })
      ->group(group);
  add_format(app, format)->group(group);

  const std::string limits = "Limits against runaway scripts";
  interpreter::Limits& limit = scene.limits;
  add(app, "--max-depth", "N", "Nested macro calls and blocks [1000]", integer_from(1, 100'000),
      [&limit](std::int64_t v) { limit.max_depth = static_cast<std::size_t>(v); })
      ->group(limits);
  add(app, "--max-turns", "N", "Turns of all loops, and macro calls; steps of a pattern or function at a point [1e9]",
      number_from(0, kUnbounded), [&limit](double v) { limit.max_turns = v; })
      ->group(limits);
  add(app, "--max-primitives", "N", "Solids, blob components, groups and lights [1e7]", number_from(0, kUnbounded),
      [&limit](double v) { limit.max_primitives = v; })
      ->group(limits);
  add(app, "--max-memory", "SIZE",
      "Memory of the run, its texts, scene and pictures: 4G, or a percentage of the machine's [75%]", parse_memory,
      [&limit](std::size_t v) { limit.max_memory_bytes = v; })
      ->group(limits);
  add(app, "--max-time", "SECONDS", "Time of the run; a picture's finished part is written when it is over [no limit]",
      number_from(0, kUnbounded), [&scene](double v) { scene.max_seconds = v; })
      ->group(limits);
  add(app, "--max-ray-steps", "N",
      fmt::format("Steps of one ray in one blob; a ray that takes them all is undecided [{}]", kStepsOfRay),
      number_from(1, kUnbounded),
      [&scene](double v) { scene.steps_of_ray = static_cast<std::uint64_t>(std::min(v, 1e18)); })
      ->group(limits);
  add(app, "--max-include-depth", "N", "Nested includes [32]", integer_from(1, 1000), [&limit](std::int64_t v) {
    limit.max_include_depth = static_cast<std::size_t>(v);
  })->group(limits);
  add(app, "--max-files", "N", "Files that the scene writes [1000]", integer_from(0, 10'000'000),
      [&limit](std::int64_t v) { limit.max_files = static_cast<std::size_t>(v); })
      ->group(limits);
  add(app, "--max-debug", "SIZE", "Text that the scene prints with #debug: 64K, 4M [16M]", parse_bytes,
      [&limit](std::size_t v) { limit.max_debug_bytes = v; })
      ->group(limits);
}

void add_quality(CLI::App& app, int& quality, const std::string& group) {
  add(app, "--quality", "0..11", "POV-Ray's levels: up to 1 quick colours, from 4 shadows, from 8 reflection [9]",
      integer_from(0, 11), [&quality](std::int64_t v) { quality = static_cast<int>(v); })
      ->group(group);
}

void add_picture_options(CLI::App& app, PictureOptions& picture) {
  std::string group = "The picture";
  add_list(
      app, "-o,--output", "FILE",
      "File: png exr tif jpg ppm hdr by extension; `png:-` is standard output; may be given again [<scene name>.png]",
      picture.outputs)
      ->group(group);
  add(app, "--bits", "8|16", "Bits per channel of png and tif [16]; jpg and ppm have 8", parse_bits, [&picture](int v) {
    picture.bits = v;
  })->group(group);
  app.add_flag("--alpha", picture.alpha, "Make the background transparent")->group(group);
  app.add_flag("--skeleton", picture.unblended, "Render the components of blobs without blending")->group(group);
  add(app, "--aov", "LIST",
      fmt::format("Layers for an .exr, comma-separated: {}; {} also as NAME.LAYER.png beside NAME.png",
                  fmt::join(names_of(all_aovs()), " "), fmt::join(names_of(pictured_aovs()), " ")),
      parse_layers, [&picture](const render::Aovs& v) { picture.layers = v; })
      ->group(group);
  add(app, "--crop", "X0,Y0,X1,Y1", "Render only these pixels; column X1 and row Y1 are excluded", parse_crop,
      [&picture](const std::array<int, 4>& v) { picture.crop = v; })
      ->group(group);

  group = "Quality";
  add(app, "--aa", "T", "Take 16 samples where neighbouring pixels differ by more than T [0.1]",
      number_from(0, kUnbounded), [&picture](double v) { picture.aa_threshold = v; })
      ->group(group);
  add(app, "--samples", "N", "Take exactly N samples in every pixel; turns --aa off", integer_from(1, 65536),
      [&picture](std::int64_t v) { picture.samples = static_cast<int>(v); })
      ->group(group);
  add(app, "--max-noise", "E",
      fmt::format("Take samples in every pixel, at most {}, until its noise is below E, as a share of the display's "
                  "range [{} in scenes with soft light or focal blur]",
                  render::kMostSamples, kSoftNoise),
      number_from(kLeastNoise, 1), [&picture](double v) { picture.max_noise = v; })
      ->group(group);
  add_quality(app, picture.quality, group);
  add(app, "--solver", "NAME",
      fmt::format("{}; paper and iso take switches after commas: {} [hermite]", solvers_text(), solver_switches_text()),
      parse_solver, [&picture](const SolverChoice& v) { picture.solver = v; })
      ->group(group);
  add(app, "--tolerance", "T", "Largest error of a surface point, in pixels (0.05px) or scene units (1e-4) [0.05px]",
      parse_tolerance, [&picture](const render::Tolerance& v) { picture.tolerance = v; })
      ->group(group);

  group = "The run";
  add(app, "-t,--threads", "N", "Number of threads [all cores]", integer_from(1, 1024), [&picture](std::int64_t v) {
    picture.threads = static_cast<int>(v);
  })->group(group);
  app.add_option("--simd", picture.simd, "Use this vector instruction set, e.g. AVX2 [the best of this machine]")
      ->type_name("TARGET")
      ->group(group);
  app.add_option("--stats", picture.statistics, "Write times and counts to this file as JSON")
      ->type_name("FILE.json")
      ->group(group);
  app.add_flag("--strict", picture.strict, "Exit with 1 if a pixel could be off by more than the tolerance")
      ->group(group);
  app.add_flag("-q,--quiet", picture.quiet, "Print no progress bar and no closing line")->group(group);
}

void add_accuracy_options(CLI::App& app, AccuracyCommand& accuracy, std::vector<std::string>& settings) {
  app.add_option("-o,--output", accuracy.output, "Write NAME.html, NAME.json and NAME.csv [<scene name>.accuracy]")
      ->type_name("NAME");
  app.add_flag("--skeleton", accuracy.unblended, "Render the components of blobs without blending");
  app.add_flag("--shadows", accuracy.shadows, "Trace and compare shadow rays too");
  add_list(app, "--setting", "\"SOLVER [T]\"",
           "A setting to compare with the default, such as `march:0.2px` or `hermite 0.1px`; may be\n"
           "given again [a ladder of all methods]",
           settings);
  add(app, "--repeats", "N", "Largest number of timing rounds; slow settings run in fewer [5]", integer_from(1, 1000),
      [&accuracy](std::int64_t v) { accuracy.repeats = static_cast<int>(v); });
  add(app, "-t,--threads", "N", "Number of threads [all cores]", integer_from(1, 1024),
      [&accuracy](std::int64_t v) { accuracy.threads = static_cast<int>(v); });
}

}  // namespace

void declare_options(CLI::App& app, RawOptions& raw, std::string_view chosen) {
  app.require_subcommand(1);
  app.set_version_flag("--version", fmt::format("isl {}", kVersion));
  app.footer(std::string(kFooter));

  CLI::App* const render = app.add_subcommand("render", "Render a scene to image files");
  CLI::App* const check = app.add_subcommand("check", "Read and evaluate a scene; report its problems and contents");
  CLI::App* const plan =
      app.add_subcommand("plan", "List the effects that a scene calls for, and those that are left out");
  CLI::App* const dump = app.add_subcommand("dump", "Print a scene at one stage on its way to a picture");
  CLI::App* const accuracy =
      app.add_subcommand("accuracy", "Measure the error and the time of several solver settings");
  CLI::App* const library =
      app.add_subcommand("library", "List the standard library; explain a file, a macro or a declaration of it");
  // Commands have their own footers; this one belongs to the overview.
  app.footer("`isl help COMMAND` lists the options of a command.\n\n" + std::string(kFooter));
  // Declaring options takes longer than reading a small scene, and only those of the given command are needed.
  for (CLI::App* const command : {render, check, plan, dump, accuracy}) {
    if (command->get_name() != chosen) continue;
    command->allow_extras();  // our own messages name them
    add_scene_options(*command, raw.scene, raw.defines, raw.format);
    SceneOptions& scene = raw.scene;
    add(*command, "-s,--size", "WxH",
        fmt::format("Size of the picture in pixels [{}]", command == accuracy ? "400x300" : "800x600"), parse_size,
        [&scene](const PictureSize& v) { scene.size = v; })
        ->group("The picture");
    if (command == render) add_picture_options(*render, raw.picture);
    if (command == plan) {
      add_quality(*plan, raw.plan_quality, "The picture");
      plan->add_flag("--measure", raw.plan_measure,
                     "Render a small picture with and without each effect, and print what each costs")
          ->group("The picture");
    }
    if (command == accuracy) add_accuracy_options(*accuracy, raw.accuracy, raw.settings);
    if (command == dump)
      dump->add_option("--stage", raw.stage, "Stage to print")->type_name("tokens|ast|database|grid");
  }
  if (chosen == library->get_name()) {
    library->allow_extras();
    library->add_option("NAME", raw.library_name, "A file, or the name of a macro or a declaration [list all]")
        ->type_name("");
    add_format(*library, raw.format);
  }
}

}  // namespace isl::cli
