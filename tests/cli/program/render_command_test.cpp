// `isl render`: the files it writes, the files it leaves alone, and its messages.
#include "tests/cli/program/program_fixture.h"

#include <nlohmann/json.hpp>

#include <csignal>
#include <thread>

namespace isl::test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

namespace fs = std::filesystem;

constexpr std::string_view kPngStart = "\x89PNG";

class RenderCommand : public ProgramTest {
 protected:
  RenderCommand() { write("ball.isl", kSmallScene); }

  /// `isl render ball.isl -s 48x36 …`
  [[nodiscard]] ProcessResult render(std::vector<std::string> options, const ProcessOptions& how = {}) const {
    options.insert(options.begin(), {"render", "ball.isl", "-s", "48x36"});
    return run(options, how);
  }
};

TEST_F(RenderCommand, NamesThePictureAfterTheScene) {
  const ProcessResult result = render({});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(files(), ElementsAre("ball.isl", "ball.png"));
  EXPECT_TRUE(read("ball.png").starts_with(kPngStart));
}

TEST_F(RenderCommand, WritesSeveralFiles) {
  EXPECT_EQ(render({"-o", "a.png", "-o", "b.exr", "--aov", "depth,normal", "-o", "c.ppm"}).exit_code, 0);
  EXPECT_THAT(files(), ElementsAre("a.png", "b.exr", "ball.isl", "c.ppm"));
  EXPECT_TRUE(read("b.exr").starts_with("v/1\x01"));
  EXPECT_TRUE(read("c.ppm").starts_with("P6"));
}

TEST_F(RenderCommand, ShowsCostsAndErrorsInPicturesOfTheirOwn) {
  const ProcessResult result = render({"-o", "a.png", "-o", "b.exr", "--aov", "missed,cost,error", "--format", "json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(files(), ElementsAre("a.cost.png", "a.error.png", "a.missed.png", "a.png", "b.exr", "ball.isl"));
  for (const char* name : {"a.cost.png", "a.error.png", "a.missed.png"}) EXPECT_TRUE(read(name).starts_with(kPngStart));
  for (const char* channel : {"cost.evaluations", "cost.seconds", "error.pixels", "error.units", "missed.kind"})
    EXPECT_THAT(read("b.exr"), HasSubstr(channel));
  EXPECT_EQ(json::parse(result.out).at("outputs").size(), 5u);
}

TEST_F(RenderCommand, MeasuringLayersLeavesThePictureAsItIs) {
  ASSERT_EQ(render({"-o", "plain.ppm"}).exit_code, 0);
  ASSERT_EQ(render({"-o", "measured.ppm", "--aov", "cost,error,solver_steps,missed"}).exit_code, 0);
  EXPECT_TRUE(read("plain.ppm") == read("measured.ppm"));
  EXPECT_TRUE(exists("measured.solver_steps.ppm"));
}

TEST_F(RenderCommand, ChecksThePlacesOfLayersToo) {
  fs::create_directory(folder() / "a.cost.png");
  EXPECT_EQ(render({"-o", "a.png", "--aov", "cost"}).exit_code, 3);
  EXPECT_EQ(render({"-o", "b.png", "-o", "b.error.png", "--aov", "error"}).exit_code, 2);
  EXPECT_FALSE(exists("b.png"));
}

TEST_F(RenderCommand, GivesTheSameBytesWhateverTheThreads) {
  ASSERT_EQ(render({"-o", "one.png", "-o", "one.exr", "-t", "1"}).exit_code, 0);
  ASSERT_EQ(render({"-o", "two.png", "-o", "two.exr", "-t", "2"}).exit_code, 0);
  EXPECT_TRUE(read("one.png") == read("two.png"));
  EXPECT_TRUE(read("one.exr") == read("two.exr"));
}

TEST_F(RenderCommand, PutsTheSceneAndTheOptionsIntoTheFileAndNoPlaces) {
  ASSERT_EQ(render({"--samples", "2", "-t", "2", "-o", "sub_picture.png"}).exit_code, 0);
  const std::string picture = read("sub_picture.png");
  EXPECT_THAT(picture, HasSubstr("isl 0."));
  EXPECT_THAT(picture, HasSubstr("ball"));
  EXPECT_THAT(picture, HasSubstr("--samples 2"));
  EXPECT_THAT(picture, Not(HasSubstr(folder().string())));
  EXPECT_THAT(picture, Not(HasSubstr("-t 2")));
}

TEST_F(RenderCommand, PicturesOfOtherOptionsDiffer) {
  ASSERT_EQ(render({"-o", "a.ppm"}).exit_code, 0);
  ASSERT_EQ(render({"-o", "b.ppm", "--quality", "0"}).exit_code, 0);
  EXPECT_FALSE(read("a.ppm") == read("b.ppm"));
}

TEST_F(RenderCommand, LeavesAnExistingPictureAloneWhenTheSceneHasErrors) {
  write("out.png", "precious");
  const auto before = fs::last_write_time(folder() / "out.png");
  write("bad.isl", "sphere { 0, Nothing }\n");
  EXPECT_EQ(run({"render", "bad.isl", "-o", "out.png"}).exit_code, 1);
  EXPECT_EQ(read("out.png"), "precious");
  EXPECT_EQ(fs::last_write_time(folder() / "out.png"), before);
  EXPECT_THAT(files(), ElementsAre("bad.isl", "ball.isl", "out.png"));
}

TEST_F(RenderCommand, ChecksThePlacesBeforeTracing) {
  write("dear.isl", "#debug \"evaluated\"\nsphere { 0, 1 }\n");
  for (const char* place : {"nowhere/out.png", "ball.isl/out.png"}) {
    const ProcessResult result =
        run({"render", "dear.isl", "-o", place, "-s", "20000x20000"}, {.limit = std::chrono::seconds(20)});
    EXPECT_EQ(result.exit_code, 3) << place;
    EXPECT_THAT(result.err, HasSubstr(place));
    EXPECT_THAT(result.err, Not(HasSubstr("evaluated"))) << "the error is reported before the scene is read";
  }
  fs::create_directory(folder() / "folder.png");
  EXPECT_EQ(render({"-o", "folder.png"}).exit_code, 3);
  EXPECT_EQ(render({"--stats", "nowhere/stats.json"}).exit_code, 3);
}

TEST_F(RenderCommand, RefusesFormatsItDoesNotHave) {
  for (const char* name : {"out.gif", "out", "out.png.txt"}) {
    const ProcessResult result = render({"-o", name});
    EXPECT_EQ(result.exit_code, 2) << name;
    EXPECT_THAT(result.err, HasSubstr("png"));
  }
  EXPECT_EQ(render({"-o", "a.png", "-o", "./a.png"}).exit_code, 2) << "the same file twice";
}

TEST_F(RenderCommand, CtrlCKeepsWhatIsDoneAndThePictureThatWasThere) {
  write("ball.png", "precious");
  // Rendering takes long enough on any machine; it has begun when the scene's last line has printed.
  write("ball.isl", std::string(kSmallScene) + "#debug \"tracing\\n\"\n");
  const ProcessResult result = run({"render", "ball.isl", "-s", "3000x2000", "--samples", "256"},
                                   {.when_marked =
                                        [](int pid) {
                                          std::this_thread::sleep_for(std::chrono::milliseconds(700));
                                          kill(pid, SIGINT);
                                        },
                                    .err_marker = "tracing",
                                    .limit = std::chrono::seconds(60)});
  EXPECT_EQ(result.exit_code, 130) << result.err;
  EXPECT_EQ(read("ball.png"), "precious");
  EXPECT_TRUE(read("ball.partial.png").starts_with(kPngStart));
  EXPECT_THAT(result.err, HasSubstr("ball.partial.png"));
  EXPECT_THAT(files(), ElementsAre("ball.isl", "ball.partial.png", "ball.png"));
}

TEST_F(RenderCommand, CtrlCWhileEvaluatingWritesNothing) {
  write("ball.isl", "#debug \"looping\\n\"\n#while (1)\n#end\n");
  const ProcessResult result = run(
      {"render", "ball.isl"},
      {.when_marked = [](int pid) { kill(pid, SIGINT); }, .err_marker = "looping", .limit = std::chrono::seconds(60)});
  EXPECT_EQ(result.exit_code, 130);
  EXPECT_THAT(files(), ElementsAre("ball.isl"));
}

TEST_F(RenderCommand, StatisticsHaveTheShapeOfTheManual) {
  ASSERT_EQ(render({"--stats", "stats.json", "-t", "2", "--samples", "3", "--tolerance", "1e-5"}).exit_code, 0);
  const json stats = json::parse(read("stats.json"));
  EXPECT_EQ(stats.at("scene").at("primitives"), 1);
  EXPECT_EQ(stats.at("scene").at("solids"), 1);
  EXPECT_EQ(stats.at("scene").at("fields"), 0);
  EXPECT_EQ(stats.at("scene").at("lights"), 1);
  for (const char* phase : {"parse", "evaluate", "compile", "trace", "write"})
    EXPECT_GE(stats.at("time").at(phase), 0.0) << phase;
  EXPECT_EQ(stats.at("rays").at("camera"), 48 * 36 * 3);
  for (const char* kind : {"shadow", "reflection", "refraction"})
    EXPECT_TRUE(stats.at("rays").at(kind).is_number()) << kind;
  EXPECT_EQ(stats.at("solver").at("name"), "hermite");
  EXPECT_EQ(stats.at("solver").at("tolerance"), "1e-05");
  EXPECT_TRUE(stats.at("solver").at("field_evaluations").is_number());
  EXPECT_EQ(stats.at("solver").at("uncertified_steps"), 0);
  EXPECT_GT(stats.at("memory").at("peak_bytes"), 1'000'000);
  EXPECT_GT(stats.at("memory").at("database_bytes"), 0);
  EXPECT_TRUE(stats.at("memory").at("grid_bytes").is_number());
  EXPECT_TRUE(stats.at("effects").at("called_for").is_array());
  EXPECT_TRUE(stats.at("effects").at("left_out").is_array());
  EXPECT_EQ(stats.at("threads"), 2);
  EXPECT_EQ(stats.at("samples_per_pixel"), 3.0);
}

constexpr const char* kSoftScene =
    "light_source { <-2, 4, -4> rgb 1 area_light x, z, 4, 4 jitter }\n"
    "camera { location <0, 1, -4> look_at 0 }\n"
    "plane { y, -1 pigment { rgb 1 } }\nsphere { 0, 1 pigment { rgb 1 } }\n";

TEST_F(RenderCommand, ScenesWithSomethingSoftStopByTheirNoise) {
  write("ball.isl", kSoftScene);
  ASSERT_EQ(render({"--stats", "stats.json"}).exit_code, 0);
  const json stats = json::parse(read("stats.json"));
  EXPECT_EQ(stats.at("noise").at("asked"), 0.01);
  EXPECT_EQ(stats.at("noise").at("noisy_pixels"), 0);
  EXPECT_GT(stats.at("samples_per_pixel"), 8.0);
  // A fixed number of samples shares the points of the light, and so does the one sample of even pixels.
  ASSERT_EQ(render({"--stats", "stats.json", "--samples", "1"}).exit_code, 0);
  const json fixed = json::parse(read("stats.json"));
  EXPECT_FALSE(fixed.contains("noise"));
  EXPECT_GT(fixed.at("rays").at("shadow"), fixed.at("rays").at("camera"));
  // The picture says by what it was made.
  ASSERT_EQ(render({"--max-noise", "0.2"}).exit_code, 0);
  EXPECT_THAT(read("ball.png"), HasSubstr("--max-noise 0.2"));
}

TEST_F(RenderCommand, AWrongNoiseIsToldAndSoAreTwoRulesForSamples) {
  for (const char* noise : {"0", "-1", "2", "much"}) {
    const ProcessResult result = render({"--max-noise", noise});
    EXPECT_EQ(result.exit_code, 2) << noise;
    EXPECT_THAT(result.err, HasSubstr("--max-noise")) << noise;
  }
  for (const char* other : {"--samples", "--aa"}) {
    const ProcessResult result = render({"--max-noise", "0.1", other, "4"});
    EXPECT_EQ(result.exit_code, 2) << other;
    EXPECT_THAT(result.err, HasSubstr(other));
  }
}

TEST_F(RenderCommand, ABlackPictureIsExplained) {
  const char* const rest = "light_source { <50, 90, -90> rgb 1 }\ncamera { location <0, 0, -4> look_at 0 }\n";
  // The camera stands in what is left of a box around a hole.
  write("ball.isl",
        std::string(rest) + "difference { box { -9, 9 } sphere { 0, 2 } pigment { rgb 1 } finish { ambient 0 } }\n");
  EXPECT_THAT(render({}).err, HasSubstr("the picture is black: the camera is inside an object"));
  write("ball.isl", std::string(rest) + "sphere { 0, 1 pigment { rgb 0 } }\n");
  EXPECT_THAT(render({}).err, Not(HasSubstr("black")));
}

TEST_F(RenderCommand, TellsHowManyPixelsStayNoisy) {
  // Specks far smaller than a pixel: the mean of 4,096 of them still varies by 0.005.
  write("ball.isl",
        "camera { location <0, 1, -4> look_at -y }\n"
        "plane { y, -1 pigment { cells scale 1e-5 } finish { ambient 1 } }\n");
  const ProcessResult result = render({"--max-noise", "0.0001", "-s", "4x3", "--stats", "stats.json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const int noisy = json::parse(read("stats.json")).at("noise").at("noisy_pixels");
  EXPECT_GT(noisy, 0);
  EXPECT_THAT(result.err, HasSubstr(std::to_string(noisy) + " pixel"));
  EXPECT_THAT(result.err, HasSubstr("after 4096 samples"));
}

TEST_F(RenderCommand, TellsHowManyPixelsAreUncertainAndFailsIfItIsStrict) {
  EXPECT_THAT(render({"--strict"}).err, Not(HasSubstr("could be off")));
  // One ray runs in the surface of the cylinder: all along it the field is the threshold itself, (1 - 1/4)^2.
  write("ball.isl",
        "camera { orthographic location -10*z direction z up 2.25*y right 3*x }\n"
        "blob { threshold 0.5625 cylinder { <1/32, 1/32, -1>, <1/32, 1/32, 1>, 2, 1 } }\n");
  const ProcessResult result = render({"--stats", "stats.json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const json stats = json::parse(read("stats.json"));
  const int undecided = stats.at("solver").at("undecided_pixels"), refuted = stats.at("solver").at("refuted_pixels");
  const int uncertain = undecided + refuted;
  EXPECT_GT(undecided, 0);
  EXPECT_THAT(result.err, HasSubstr(std::to_string(uncertain) + (uncertain == 1 ? " pixel" : " pixels") +
                                    " could be off by more than the tolerance"));
  const ProcessResult strict = render({"--strict", "-q"});
  EXPECT_EQ(strict.exit_code, 1);
  EXPECT_THAT(strict.err, HasSubstr("error: "));
  EXPECT_TRUE(exists("ball.png"));
}

TEST_F(RenderCommand, PartsThatMeetInAUnionLeaveNoPixelUncertain) {
  // Limbs that begin or end as one: where their sums are equal it is of no account which of them is met.
  write("ball.isl",
        "camera { location <0, 1.5, -6> look_at <0, 0.5, 0> angle 36 }\n"
        "blob { kernel \"gaussian\" hardness 3 sphere { 0, 0.6 }\n"
        "  union { cone { <-0.1, 0, 0>, 0.25, <-0.45, 1.6, 0>, 0.12 }\n"
        "    cone { <0.1, 0, 0>, 0.25, <0.45, 1.6, 0>, 0.12 } } }\n");
  EXPECT_EQ(run({"render", "ball.isl", "-s", "160x120", "--strict"}).exit_code, 0);
  write("ball.isl",
        "camera { location <0, 2, -6> look_at 0 angle 30 }\n"
        "blob { kernel \"quartic\"\n"
        "  union { cone { <-1, 0, 0>, .3, <0, .8, 0>, .2 } cone { <0, .8, 0>, .2, <1, 0, 0>, .1 } } }\n");
  EXPECT_EQ(run({"render", "ball.isl", "-s", "160x120", "--strict"}).exit_code, 0);
}

TEST_F(RenderCommand, TheCommandLineGoesBeforeTheScene) {
  write("ball.isl", "global_settings { solver \"paper:3\" tolerance \"0.5px\" }\n" + std::string(kSmallScene));
  const ProcessResult by_scene = render({"--stats", "scene.json"});
  ASSERT_EQ(by_scene.exit_code, 0) << by_scene.err;
  EXPECT_EQ(json::parse(read("scene.json")).at("solver").at("name"), "paper:3");
  EXPECT_EQ(json::parse(read("scene.json")).at("solver").at("tolerance"), "0.5px");
  ASSERT_EQ(render({"--stats", "line.json", "--solver", "hermite", "--tolerance", "0.1px"}).exit_code, 0);
  EXPECT_EQ(json::parse(read("line.json")).at("solver").at("name"), "hermite");
  EXPECT_EQ(json::parse(read("line.json")).at("solver").at("tolerance"), "0.1px");
}

TEST_F(RenderCommand, AnUnknownInstructionSetIsACommandLineError) {
  const ProcessResult result = render({"--simd", "ABACUS"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("ABACUS"));
}

TEST_F(RenderCommand, AnswersInJson) {
  const ProcessResult result = render({"--format", "json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json document = json::parse(result.out);
  EXPECT_EQ(document.at("outputs"), json({"ball.png"}));
  EXPECT_EQ(document.at("statistics").at("scene").at("primitives"), 1);
}

}  // namespace
}  // namespace isl::test
