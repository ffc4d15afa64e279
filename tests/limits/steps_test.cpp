// Patterns and functions that take for ever at a single point: each ends with its place, and the option that raises the
// limit.
#include "tests/limits/attack_fixture.h"

#include <fmt/format.h>

namespace isl::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr std::string_view kStepsView = "camera { location <0, 0, -4> look_at 0 } light_source { -5, 1 }\n";

class Steps : public AttackTest {
 protected:
  [[nodiscard]] ProcessResult render(const std::string& text, const std::vector<std::string>& options) {
    std::vector<std::string> command{
        "render", write("scene.isl", std::string(kStepsView) + text), "-q", "-s", "32x24", "-o", "a.png"};
    command.insert(command.end(), options.begin(), options.end());
    ProcessOptions process;
    process.limit = kTimeBound;
    return run(command, process);
  }

  /// Renders the scene; it must be refused at a place of its text.
  void expect_refusal(const std::string& text, const std::vector<std::string>& options = {"--max-turns", "1e6"}) {
    const ProcessResult result = render(text, options);
    EXPECT_EQ(result.exit_code, 1) << text << "\n" << result.err;
    EXPECT_THAT(result.err, AllOf(HasSubstr("scene.isl:2:"), HasSubstr("error:"), HasSubstr("`--max-turns`"))) << text;
    EXPECT_FALSE(exists("a.png"));
  }

  static std::string nested(std::string_view kind, std::string_view map) {
    return fmt::format(
        "#declare P = {0} {{ gradient x {1} {{ [0 rgb 0] [1 rgb 1] }} }} "
        "#for (I, 1, 60) #declare P = {0} {{ gradient x {1} {{ [0 P] [1 P] }} }} #end sphere {{ 0, 1 {0} {{ P }} }}",
        kind, map);
  }
};

TEST_F(Steps, OfNestedMapsAreCounted) {
  expect_refusal(nested("pigment", "pigment_map"));
  expect_refusal(
      "#declare P = pigment { gradient x } #for (I, 1, 60) #declare P = pigment { average pigment_map { [1 P] [1 P] } "
      "} "
      "#end sphere { 0, 1 pigment { P } }");
  expect_refusal(
      "#declare T = texture { pigment { gradient x } } #for (I, 1, 60) "
      "#declare T = texture { gradient x texture_map { [0 T] [1 T] } } #end sphere { 0, 1 texture { T } }");
  expect_refusal(
      "#declare T = texture { pigment { rgb 1 } } #for (I, 1, 60) "
      "#declare T = texture { average texture_map { [1 T] [1 T] } } #end sphere { 0, 1 texture { T } }");
}

TEST_F(Steps, OfTheSkyAreCounted) {
  expect_refusal(
      "#declare P = pigment { gradient x } #for (I, 1, 60) #declare P = pigment { average pigment_map { [1 P] [1 P] } "
      "} "
      "#end sky_sphere { pigment { P } }");
}

TEST_F(Steps, OfFractalsAreCounted) {
  expect_refusal("sphere { 0, 1 pigment { mandel 2000000000 } }");
  expect_refusal("sphere { 0, 1 pigment { julia <0, 0>, 4000000000 } }");
  expect_refusal("#declare F = function { pattern { mandel 2000000000 } } #declare A = F(0, 0, 0);");
}

TEST_F(Steps, OfSumsAreCounted) {
  constexpr std::string_view kSums =
      "#declare F = function { sum(I, 1, 1e5, sum(J, 1, 1e5, sum(K, 1, 1e5, x + I * J * K))) } ";
  expect_refusal(std::string(kSums) + "#declare A = F(1, 2, 3);");
  expect_refusal(std::string(kSums) + "sphere { 0, 1 pigment { function { F(x, y, z) } } }");
}

TEST_F(Steps, OfUnionsAroundObjectsAreCounted) {
  expect_refusal(
      "#declare U = sphere { 0, 1 } #for (I, 1, 5000) #declare U = union { object { U } } #end "
      "#for (I, 1, 15) #declare U = union { object { U } object { U translate x } } #end object { U }");
}

/// The places are in the box of each part and in no part, so that every part is asked.
TEST_F(Steps, OfInsidesAreCounted) {
  constexpr std::string_view kUnion =
      "#declare U = sphere { <1.2, 1.2, -1.2>, 1 } "
      "#for (I, 1, 60) #declare U = union { object { U } object { U } } #end ";
  expect_refusal(std::string(kUnion) + "#declare A = inside(U, <0.5, 0.5, -0.5>);");
  expect_refusal(std::string(kUnion) + "sphere { 0, 1 pigment { object { U rgb 1 rgb 0 } } }");
}

}  // namespace
}  // namespace isl::test
