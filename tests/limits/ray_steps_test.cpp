// Rays that no digits decide soon: fields that are nearly flat, that overflow, or that cancel. Each ends at its bound
// of steps, and hears the clock before.
#include "tests/limits/attack_fixture.h"

#include <fmt/format.h>

#include <chrono>

namespace isl::test {
namespace {

using testing::HasSubstr;

constexpr std::string_view kLightAndCamera = "light_source { <5, 5, -5> rgb 1 } camera { location -4*z look_at 0 }\n";

struct FlatField {
  const char* name;
  const char* blob;
};

constexpr FlatField kFlatFields[] = {
    {"TinyHardness", R"(blob { kernel "metaball" hardness 1e-170 sphere { 0, 1 } cone { 0, 0.5, x, 0.2 } })"},
    {"GreatStrength",
     R"(blob { kernel "soft" hardness 2 triangle { 0, x, y, 0.1 strength -1e308 } disc { y, 2*z, 1.5, 0.25 } })"},
    {"CancellingStrengths",
     R"(blob { kernel "gaussian" hardness 4 sphere { 0, 1 strength 1e15 } sphere { 0, 1 strength -1e15 } sphere { 0.1*x, 1 } })"},
    {"NearlyConstant",
     R"(blob { kernel "cauchy" hardness 1e-12 sphere { 0, 1 } sphere { x, 1 } disc { 0, y, 1, 0.1 } })"},
    {"Denormal", R"(blob { kernel "gaussian" hardness 1e-308 sphere { 0, 1 } sphere { 1.01*x, 0.01 } })"},
    {"EyeOnTheSurface", R"(blob { kernel "gaussian" hardness 4 plane { y, 0, 0.1 } translate -0.1*y })"}};

class RaySteps : public AttackTest {
 protected:
  [[nodiscard]] ProcessResult render(const FlatField& field, std::vector<std::string> options) {
    std::vector<std::string> command{"render", write("scene.isl", std::string(kLightAndCamera) + field.blob), "-o",
                                     "a.png"};
    command.insert(command.end(), options.begin(), options.end());
    ProcessOptions process;
    process.limit = kTimeBound;
    return run(command, process);
  }
};

TEST_F(RaySteps, HearTheClock) {
  for (const FlatField& field : kFlatFields) {
    const auto begin = std::chrono::steady_clock::now();
    const ProcessResult result = render(field, {"-s", "640x480", "--max-time", "1"});
    EXPECT_TRUE(result.exit_code == 75 || result.exit_code == 0) << field.name << ": " << result.err;
    // A busy machine may take some seconds to start and to write.
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10)) << field.name;
  }
}

TEST_F(RaySteps, EndByThemselves) {
  for (const FlatField& field : kFlatFields) {
    const ProcessResult result = render(field, {"-s", "32x24", "--stats", "a.json"});
    EXPECT_EQ(result.exit_code, 0) << field.name << ": " << result.err;
  }
}

/// A picture of such rays gives all of them a tenth of their bound, whatever the threads.
TEST_F(RaySteps, OfAHardPictureAreTheSameOnAllThreads) {
  const FlatField& field = kFlatFields[5];
  ASSERT_EQ(render(field, {"-s", "48x36", "-t", "1"}).exit_code, 0);
  const std::string one = read("a.png");
  const ProcessResult again = render(field, {"-s", "48x36", "-t", "3"});
  EXPECT_THAT(again.err, HasSubstr("a greater `--max-ray-steps` may decide them"));
  EXPECT_TRUE(one == read("a.png"));
}

}  // namespace
}  // namespace isl::test
