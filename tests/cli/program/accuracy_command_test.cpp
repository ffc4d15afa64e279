// `isl accuracy`: its files, its table and its advice.
#include "tests/cli/program/program_fixture.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace isl::test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::string_view kBlob = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <-3, 1, -4> look_at 0 }
light_source { <5, 5, -5> rgb 1 }
blob { kernel "gaussian" hardness 3 sphere { 0, 0.7 } cylinder { <-1, 0, 0>, <1, 0.4, 0>, 0.3 } pigment { rgb 1 } }
)";

class AccuracyCommand : public ProgramTest {
 protected:
  AccuracyCommand() { write("blob.isl", kBlob); }

  [[nodiscard]] ProcessResult measure(std::vector<std::string> options) const {
    options.insert(options.begin(), {"accuracy", "blob.isl", "-s", "48x36", "--repeats", "2"});
    return run(options);
  }
};

TEST_F(AccuracyCommand, TellsATableAndEndsWithAdvice) {
  const ProcessResult result = measure({});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "") << "no progress without a terminal";
  for (const char* text :
       {"paper:2", "paper:16", "hermite 0.05px", "exact", "default", "worst px", "48x36 camera rays"})
    EXPECT_THAT(result.out, HasSubstr(text));
  EXPECT_THAT(result.out, HasSubstr("on 1728 of 1728 rays"));
  const std::string last = result.out.substr(result.out.rfind('\n', result.out.size() - 2) + 1);
  EXPECT_THAT(last, HasSubstr("cheapest setting"));
  EXPECT_THAT(last, HasSubstr("--solver "));
}

TEST_F(AccuracyCommand, WritesTheSameNumbersAsJsonAndCsv) {
  const ProcessResult result = measure({"-o", "numbers", "--format", "json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json document = json::parse(read("numbers.json"));
  const json& settings = document.at("settings");
  ASSERT_GT(settings.size(), 10u);
  const std::string csv = read("numbers.csv");
  EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), settings.size() + 1);
  int defaults = 0, front = 0;
  for (const json& setting : settings) {
    EXPECT_THAT(csv,
                HasSubstr(setting.at("setting").get<std::string>() + "," + setting.at("options").get<std::string>()));
    EXPECT_GT(setting.at("relative_time"), 0.0);
    EXPECT_GT(setting.at("field_evaluations_per_ray"), 0.0);
    defaults += setting.at("default").get<bool>() ? 1 : 0;
    front += setting.at("pareto").get<bool>() ? 1 : 0;
    if (setting.at("family") == "hermite" && setting.at("options") != "--solver hermite --tolerance 1px") {
      EXPECT_LT(setting.at("error").at("worst_px"), 0.3) << setting.at("setting");
      EXPECT_EQ(setting.at("missed"), 0) << setting.at("setting");
    }
  }
  const auto digits = std::ranges::find(settings, "hermite:digits",
                                        [](const json& setting) { return setting.at("setting").get<std::string>(); });
  ASSERT_NE(digits, settings.end());
  EXPECT_LT(digits->at("error").at("worst_px"), 1e-11) << "the extended numbers are judged too";
  EXPECT_EQ(defaults, 1);
  EXPECT_GE(front, 1);
  EXPECT_EQ(document.at("reference").at("proven"), 48 * 36);
  EXPECT_EQ(json::parse(result.out).at("advice"), document.at("advice"));
  EXPECT_THAT(document.at("command").get<std::string>(), HasSubstr("isl accuracy blob.isl -s 48x36 --repeats 2"));
}

TEST_F(AccuracyCommand, WritesAPageThatNeedsNothingElse) {
  ASSERT_EQ(measure({"-o", "numbers"}).exit_code, 0);
  const std::string page = read("numbers.html");
  const json settings = json::parse(read("numbers.json")).at("settings");
  const auto count = [&page](std::string_view text) {
    std::size_t found = 0;
    for (std::size_t at = page.find(text); at != std::string::npos; at = page.find(text, at + 1)) ++found;
    return found;
  };
  EXPECT_EQ(count("<g class=\"point\""), settings.size()) << "a point in the chart for each";
  EXPECT_EQ(count("<tr data-rung="), settings.size());
  EXPECT_EQ(count("data:image/png;base64,iVBOR"), 2 * settings.size() + 1);
  EXPECT_EQ(count("http"), 0u);
  EXPECT_THAT(page, HasSubstr("isl accuracy blob.isl -s 48x36"));
}

TEST_F(AccuracyCommand, ComparesShadowsWhereAsked) {
  const ProcessResult result = measure({"-o", "numbers", "--shadows"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("shadow rays"));
  const json settings = json::parse(read("numbers.json")).at("settings");
  for (const json& setting : settings) {
    EXPECT_GT(setting.at("shadows").at("rays"), 50);
    EXPECT_TRUE(setting.at("family") != "exact" || setting.at("shadows").at("leaks") == 0);
  }
  EXPECT_THAT(read("numbers.html"), HasSubstr("false shadows"));
  EXPECT_THAT(read("numbers.json"), HasSubstr("--shadows"));
}

TEST_F(AccuracyCommand, NamesItsFilesAfterTheScene) {
  ASSERT_EQ(measure({}).exit_code, 0);
  EXPECT_THAT(files(), ElementsAre("blob.accuracy.csv", "blob.accuracy.html", "blob.accuracy.json", "blob.isl"));
}

TEST_F(AccuracyCommand, ChecksThePlacesFirst) {
  const ProcessResult result = measure({"-o", "nowhere/numbers"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("nowhere/numbers"));
}

TEST_F(AccuracyCommand, MeasuresSolidsToo) {
  write("ball.isl", kSmallScene);
  const ProcessResult result = run({"accuracy", "ball.isl", "-s", "24x18", "--repeats", "1"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("meet a solid or a combination"));
}

}  // namespace
}  // namespace isl::test
