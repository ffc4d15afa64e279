// `isl plan` lists the effects that a scene calls for, the statements that do so, and the effects that are left out.
#include "tests/cli/program/program_fixture.h"

#include <nlohmann/json.hpp>

#include <map>
#include <string>

namespace isl::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class PlanCommand : public ProgramTest {
 protected:
  PlanCommand() {
    write("a.df3", "");
    write("metal.inc",
          "#declare Metal = texture { pigment { density_file df3 \"a.df3\" }\n"
          "  finish { specular 1 metallic\n"
          "    reflection .5 } }\n");
    write("scene.isl",
          "#include \"metal.inc\"\n"
          "light_source { -9*z, rgb 1 }\n"
          "sphere { 0, 1 texture { Metal } }\n"
          "sphere { 2*x, 1 texture { Metal } }\n");
  }
};

/// The entry of an effect in one of the lists of the document.
json effect(const json& document, const char* list, const std::string& name) {
  for (const json& entry : document.at(list)) {
    if (entry.at("name") == name) return entry;
  }
  return nullptr;
}

TEST_F(PlanCommand, NamesTheStatementsThatAsked) {
  const ProcessResult result = run({"plan", "scene.isl"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(
      result.out,
      HasSubstr(
          "metallic    `metallic` at metal.inc:2:23, in file `metal.inc` at scene.isl:1:1, used at scene.isl:3:25"));
  EXPECT_THAT(result.out, HasSubstr("lighting    a light at scene.isl:2:1"));
  EXPECT_THAT(result.out, HasSubstr("called for, and not rendered yet\n  pigment_by_file  a pigment that depends on a "
                                    "density file at metal.inc:1:38"));
  EXPECT_THAT(result.out, HasSubstr("there is no sky_sphere"));
}

TEST_F(PlanCommand, LeavesOutWhatTheUserSays) {
  const ProcessResult result =
      run({"plan", "scene.isl", "--without", "reflection,pigment_by_file", "--without", "shadows"});
  EXPECT_THAT(result.out, HasSubstr("excluded by --without"));
  EXPECT_THAT(result.out, Not(HasSubstr("not rendered yet")));
  EXPECT_EQ(run({"render", "scene.isl", "-s", "8x6", "--without", "pigment_by_file"}).exit_code, 0);
}

TEST_F(PlanCommand, HasTheQualityOfAPicture) {
  const ProcessResult result = run({"plan", "scene.isl", "--quality", "1"});
  EXPECT_THAT(result.out, HasSubstr("plain_colours  the quality"));
  EXPECT_THAT(result.out, HasSubstr("`--quality` is too low for it"));
}

TEST_F(PlanCommand, AnswersInJson) {
  const json document = json::parse(run({"plan", "scene.isl", "--format", "json"}).out);
  const json reflection = effect(document, "called_for", "reflection");
  ASSERT_FALSE(reflection.is_null());
  const json& request = reflection.at("requests").at(0);
  EXPECT_EQ(request.at("what"), "`reflection`");
  EXPECT_EQ(request.at("place"), (json{{"file", "metal.inc"}, {"line", 3}, {"column", 5}}));
  EXPECT_EQ(request.at("used_at").at("file"), "scene.isl");
  EXPECT_FALSE(effect(document, "not_rendered", "pigment_by_file").is_null());
  EXPECT_EQ(effect(document, "left_out", "fog").at("reason"), "there is no fog");
}

TEST_F(PlanCommand, AnUnknownEffectIsACommandLineError) {
  const ProcessResult result = run({"plan", "scene.isl", "--without", "reflexion"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("unknown effect `reflexion`; did you mean `reflection`?"));
}

TEST_F(PlanCommand, ARefusalPointsAtTheWordAndAtTheTextureThatItBelongsTo) {
  const ProcessResult result = run({"check", "scene.isl"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err,
              HasSubstr("metal.inc:1:38: error: a pigment that depends on a density file is not rendered yet"));
  EXPECT_THAT(result.err, HasSubstr("scene.isl:3:25: note: it belongs to `Metal`, which is used here"));
}

TEST_F(PlanCommand, MeasuresWhatEachEffectAdds) {
  write("lit.isl",
        "camera { location -5*z }\n"
        "light_source { <-9, 0, -9>, rgb 1 }\n"
        "sphere { 0, 1 pigment { rgb 1 } finish { ambient .1 reflection .5 } }\n"
        "sphere { 2*x, 1 pigment { rgb 1 } }\n");
  const ProcessResult result = run({"plan", "lit.isl", "--measure", "-s", "40x30", "--format", "json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json measured = json::parse(result.out).at("measured");
  EXPECT_EQ(measured.at("width"), 40);
  EXPECT_GT(measured.at("seconds"), 0);
  std::map<std::string, std::int64_t> rays;
  for (const json& cost : measured.at("effects")) rays[cost.at("name")] = cost.at("rays");
  EXPECT_GT(rays.at("reflection"), 0) << "rays of mirrors";
  EXPECT_GT(rays.at("shadows"), 0);
  EXPECT_EQ(rays.at("ambient"), 0) << "spawns nothing";
  EXPECT_LT(rays.at("reflection") + rays.at("shadows"), measured.at("rays"));
  EXPECT_THAT(run({"plan", "lit.isl", "--measure", "-s", "40x30"}).out, HasSubstr("each effect adds\n  "));
  const ProcessResult refused = run({"plan", "scene.isl", "--measure"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, HasSubstr("is not rendered yet"));
}

TEST_F(PlanCommand, MeasuresWhatNoiseAndHalfOfItCost) {
  write("soft.isl",
        "light_source { <-2, 4, -4> rgb 1 area_light x, z, 4, 4 jitter }\nsphere { 3*z, 1 pigment { rgb 1 } }\n"
        "plane { y, -1 pigment { rgb 1 } }\n");
  const ProcessResult result = run({"plan", "soft.isl", "--measure", "-s", "40x30", "--format", "json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json noise = json::parse(result.out).at("measured").at("noise");
  ASSERT_EQ(noise.size(), 2u);
  EXPECT_EQ(noise[0].at("noise"), 2 * noise[1].at("noise").get<double>());
  EXPECT_LT(noise[0].at("samples_per_pixel"), noise[1].at("samples_per_pixel"));
  EXPECT_THAT(run({"plan", "soft.isl", "--measure", "-s", "40x30"}).out, HasSubstr("of noise takes"));
}

}  // namespace
}  // namespace isl::test
