#include "cli/options/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isl::cli {
namespace {

using testing::HasSubstr;

Command parse(std::vector<std::string> arguments) { return parse_command_line(arguments); }

RenderCommand render(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "render");
  const Command command = parse(arguments);
  if (const auto* finished = std::get_if<Finished>(&command)) ADD_FAILURE() << finished->text;
  return std::holds_alternative<RenderCommand>(command) ? std::get<RenderCommand>(command) : RenderCommand{};
}

/// The message for a command line that is refused.
std::string refusal(std::vector<std::string> arguments) {
  const Command command = parse(std::move(arguments));
  const auto* finished = std::get_if<Finished>(&command);
  if (finished == nullptr || finished->code != ExitCode::command_line_error) return "not refused";
  return finished->text;
}

std::vector<std::string_view> names_of(const render::Aovs& aovs) {
  std::vector<std::string_view> names;
  for (const render::Aov* const aov : aovs) names.push_back(aov->name);
  return names;
}

TEST(Options, DefaultsAreThoseOfTheManual) {
  const RenderCommand command = render({"a.isl"});
  EXPECT_EQ(command.scene.scene, "a.isl");
  EXPECT_EQ(command.scene.size, (PictureSize{800, 600}));
  EXPECT_EQ(command.scene.limits.max_depth, 1000u);
  EXPECT_EQ(command.scene.limits.max_include_depth, 32u);
  EXPECT_EQ(command.scene.format, OutputFormat::text);
  EXPECT_FALSE(command.picture.aa_threshold.has_value());
  EXPECT_FALSE(command.picture.max_noise.has_value());
  EXPECT_EQ(command.picture.threads, 0);
  EXPECT_EQ(command.picture.quality, 9);
  EXPECT_FALSE(command.picture.samples.has_value());
  EXPECT_FALSE(command.picture.solver.has_value());
  EXPECT_FALSE(command.picture.tolerance.has_value());
  EXPECT_TRUE(command.picture.outputs.empty());
}

TEST(Options, RepeatedOptionsTakeOneValueEach) {
  const RenderCommand command =
      render({"-o", "a.png", "-o", "b.exr", "-I", "lib", "a.isl", "-D", "N=3", "-D", "K=soft"});
  EXPECT_EQ(command.scene.scene, "a.isl");
  EXPECT_THAT(command.picture.outputs, testing::ElementsAre("a.png", "b.exr"));
  EXPECT_THAT(command.scene.include_paths, testing::ElementsAre("lib"));
  ASSERT_EQ(command.scene.defines.size(), 2u);
  EXPECT_EQ(std::get<double>(command.scene.defines[0].second), 3);
  EXPECT_EQ(std::get<std::string>(command.scene.defines[1].second), "soft");
}

TEST(Options, TheLastOfASingleOptionCounts) {
  EXPECT_EQ(render({"a.isl", "--samples", "2", "--samples", "5"}).picture.samples, 5);
}

TEST(Options, AMinusIsStandardInputAndNegativeNumbersAreValues) {
  const RenderCommand command = render({"-", "--clock", "-0.5", "-D", "A=-1"});
  EXPECT_EQ(command.scene.scene, "-");
  EXPECT_EQ(command.scene.clock, -0.5);
}

TEST(Options, LayersAreInCanonicalOrderEachOnce) {
  const RenderCommand command = render({"a.isl", "-o", "a.exr", "--aov", "normal,depth,normal"});
  EXPECT_THAT(names_of(command.picture.layers), testing::ElementsAre("depth", "normal"));
}

TEST(Options, HelpAndVersionAreNoErrors) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"--help"}, {"--version"}, {"render", "--help"}, {"check", "-h"}}) {
    const Command command = parse(arguments);
    ASSERT_TRUE(std::holds_alternative<Finished>(command));
    EXPECT_EQ(std::get<Finished>(command).code, ExitCode::done);
    EXPECT_FALSE(std::get<Finished>(command).text.empty());
  }
  EXPECT_THAT(std::get<Finished>(parse({"render", "--help"})).text, HasSubstr("--tolerance"));
}

TEST(Options, HelpIsACommandToo) {
  const auto text = [](std::vector<std::string> arguments) {
    return std::get<Finished>(parse(std::move(arguments))).text;
  };
  EXPECT_EQ(text({"help"}), text({"--help"}));
  EXPECT_EQ(text({"help", "help"}), text({"--help"}));
  EXPECT_THAT(text({"help"}), HasSubstr("isl help COMMAND"));
  for (const char* command : {"render", "check", "dump", "accuracy", "library"}) {
    EXPECT_EQ(text({"help", command}), text({command, "--help"}));
    EXPECT_THAT(text({"help", command}), HasSubstr(command));
  }
  EXPECT_THAT(refusal({"help", "rendr"}), HasSubstr("did you mean `render`?"));
  EXPECT_THAT(refusal({"hlep"}), HasSubstr("did you mean `help`?"));
}

TEST(Options, BitsAreThoseOfAFormatThatHasThem) {
  EXPECT_EQ(render({"a.isl"}).picture.bits, 0);
  EXPECT_EQ(render({"a.isl", "--bits", "8"}).picture.bits, 8);
  EXPECT_EQ(render({"a.isl", "--bits", "16", "-o", "a.tif"}).picture.bits, 16);
  EXPECT_EQ(render({"a.isl", "--bits", "8", "-o", "a.jpg", "-o", "b.ppm"}).picture.bits, 8);
  EXPECT_EQ(render({"a.isl", "--bits", "8", "-o", "a.png", "-o", "b.exr"}).picture.bits, 8) << "of the PNG";
  EXPECT_THAT(refusal({"render", "a.isl", "--bits", "12"}), HasSubstr("--bits: expected 8 or 16, found `12`"));
  for (const char* format : {"jpg", "ppm"}) {
    EXPECT_THAT(refusal({"render", "a.isl", "--bits", "16", "-o", "a.png", "-o", std::string("a.") + format}),
                HasSubstr(std::string("--bits: ") + format + " has 8 bits"));
  }
  for (const char* name : {"a.exr", "a.hdr", "exr:-"}) {
    EXPECT_THAT(refusal({"render", "a.isl", "--bits", "8", "-o", name}), HasSubstr("floating-point")) << name;
  }
}

TEST(Options, StandardOutputIsForOnePictureAlone) {
  EXPECT_THAT(render({"a.isl", "-o", "png:-"}).picture.outputs, testing::ElementsAre("png:-"));
  EXPECT_THAT(refusal({"render", "a.isl", "-o", "-"}), HasSubstr("as in `-o png:-`"));
  EXPECT_THAT(refusal({"render", "a.isl", "-o", "png:-", "--format", "json"}), HasSubstr("--format json"));
  EXPECT_THAT(refusal({"render", "a.isl", "-o", "png:-", "--aov", "cost"}), HasSubstr("--aov"));
  EXPECT_THAT(names_of(render({"a.isl", "-o", "exr:-", "--aov", "depth"}).picture.layers),
              testing::ElementsAre("depth"));
  EXPECT_THAT(names_of(render({"a.isl", "-o", "png:-", "-o", "a.exr", "--aov", "depth"}).picture.layers),
              testing::ElementsAre("depth"));
}

TEST(Options, OfTheSystemsLibrariesExcludeOneAnother) {
  EXPECT_EQ(render({"a.isl"}).scene.system_libraries, SystemLibraries::after_ours);
  EXPECT_EQ(render({"a.isl", "--no-system-libraries"}).scene.system_libraries, SystemLibraries::none);
  EXPECT_EQ(render({"a.isl", "--system-libraries-first"}).scene.system_libraries, SystemLibraries::before_ours);
  for (const char* const command : {"render", "check", "plan", "accuracy"}) {
    EXPECT_THAT(refusal({command, "a.isl", "--no-system-libraries", "--system-libraries-first"}),
                HasSubstr("leave out one of the two"))
        << command;
  }
}

TEST(Options, OfTheLibraryAreOneNameAndAFormat) {
  const Command command = parse({"library", "curves", "--format", "json"});
  ASSERT_TRUE(std::holds_alternative<LibraryCommand>(command));
  EXPECT_EQ(std::get<LibraryCommand>(command).name, "curves");
  EXPECT_EQ(std::get<LibraryCommand>(command).format, OutputFormat::json);
  EXPECT_EQ(std::get<LibraryCommand>(parse({"library"})).name, "");
  EXPECT_THAT(refusal({"library", "curves", "skins"}), HasSubstr("expected one name, found `skins` after `curves`"));
  EXPECT_THAT(refusal({"library", "--formt", "json"}), HasSubstr("did you mean `--format`?"));
  EXPECT_THAT(refusal({"library", "--format", "xml"}), HasSubstr("`xml`"));
}

TEST(Options, MistakesAreNamedAndAnswered) {
  EXPECT_THAT(refusal({}), HasSubstr("no command"));
  EXPECT_THAT(refusal({"rendr", "a.isl"}), HasSubstr("did you mean `render`?"));
  EXPECT_THAT(refusal({"a.isl"}), HasSubstr("isl render a.isl"));
  EXPECT_THAT(refusal({"plant", "a.isl"}), HasSubstr("did you mean `plan`?"));
  EXPECT_THAT(refusal({"render"}), HasSubstr("no scene given"));
  EXPECT_THAT(refusal({"render", "a.isl", "b.isl"}), HasSubstr("`b.isl`"));
  EXPECT_THAT(refusal({"render", "a.isl", "--tolerence", "1"}), HasSubstr("did you mean `--tolerance`?"));
  EXPECT_THAT(refusal({"render", "a.isl", "--samples", "0"}), HasSubstr("--samples: expected a whole number from 1"));
  EXPECT_THAT(refusal({"render", "a.isl", "-s", "640"}), HasSubstr("--size: expected WIDTHxHEIGHT"));
  EXPECT_THAT(refusal({"render", "a.isl", "--samples"}), HasSubstr("--samples needs a value"));
  EXPECT_THAT(refusal({"render", "a.isl", "--solver", "newton"}), HasSubstr("unknown solver `newton`"));
  EXPECT_THAT(refusal({"render", "a.isl", "--crop", "0,0,801,10"}), HasSubstr("800x600"));
  EXPECT_THAT(refusal({"render", "a.isl", "--aov", "depht", "-o", "a.exr"}), HasSubstr("unknown layer `depht`"));
  EXPECT_THAT(refusal({"render", "a.isl", "--aov", "depth"}), HasSubstr(".exr"));
  EXPECT_THAT(refusal({"render", "a.isl", "--aov", "cost,depth"}), HasSubstr(".exr"));
  EXPECT_THAT(names_of(render({"a.isl", "--aov", "missed,cost"}).picture.layers),
              testing::ElementsAre("cost", "missed"));
  EXPECT_THAT(refusal({"render", "a.isl", "--solver", "exact", "--tolerance", "1px"}), HasSubstr("--tolerance"));
  EXPECT_THAT(refusal({"render", "a.isl", "-D", "Levels"}), HasSubstr("expected NAME=VALUE"));
  EXPECT_THAT(refusal({"check", "a.isl", "--format", "xml"}), HasSubstr("`xml`"));
  EXPECT_THAT(refusal({"dump", "a.isl"}), HasSubstr("--stage"));
  EXPECT_THAT(refusal({"dump", "a.isl", "--stage", "pixels"}), HasSubstr("`pixels`"));
  EXPECT_THAT(refusal({"--frobnicate"}), HasSubstr("--frobnicate"));
}

TEST(Options, MessagesAreLowerCaseWithoutAFullStop) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"render"}, {"render", "a.isl", "-t", "0"}, {"bogus"}, {"render", "a.isl", "--nope"}}) {
    const std::string text = refusal(arguments);
    EXPECT_TRUE(text.starts_with("isl: error: ")) << text;
    const std::string first_line = text.substr(0, text.find('\n'));
    EXPECT_NE(first_line.back(), '.') << text;
  }
}

}  // namespace
}  // namespace isl::cli
