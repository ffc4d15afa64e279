// Runs every scene in tests/golden/<stage>/ through its stage and compares the result with the file beside it:
// okay_*.isl with .out, fail_*.isl with .err, and mistake_*.isl (scenes with errors or remarks) with .err. If
// ISL_ACCEPT is set in the environment, it writes those files instead.
#include "tests/golden/stages.h"
#include "tests/support/source_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace isl::test {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const Stage& stage) { return fs::path(ISL_SOURCE_DIR) / "tests" / "golden" / stage.name; }

struct Case {
  const Stage* stage;
  std::string name;  ///< without extension

  [[nodiscard]] bool is_mistake() const { return name.starts_with("mistake_"); }
  [[nodiscard]] bool should_fail() const { return name.starts_with("fail_"); }
  [[nodiscard]] fs::path expectation() const {
    return folder_of(*stage) / (name + (should_fail() || is_mistake() ? ".err" : ".out"));
  }
};

std::vector<Case> find_cases() {
  std::vector<Case> cases;
  for (const Stage& stage : stages()) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_of(stage))) {
      const std::string name = entry.path().stem().string();
      const bool is_case = entry.path().extension() == ".isl" &&
                           (name.starts_with("okay_") || name.starts_with("fail_") || name.starts_with("mistake_"));
      if (is_case) cases.push_back({&stage, name});
    }
  }
  std::sort(cases.begin(), cases.end(), [](const Case& a, const Case& b) { return a.expectation() < b.expectation(); });
  return cases;
}

std::string read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class Golden : public testing::TestWithParam<Case> {};

TEST_P(Golden, GivesWhatIsExpected) {
  const Case& test_case = GetParam();
  fs::current_path(folder_of(*test_case.stage));  // messages then name files without their folder
  const StageResult result = test_case.stage->run(test_case.name + ".isl");
  if (test_case.is_mistake()) {
    ASSERT_FALSE(result.text.starts_with("{")) << "the mistake is not reported";
  } else {
    ASSERT_EQ(result.is_okay, !test_case.should_fail()) << result.text;
  }
  if (std::getenv("ISL_ACCEPT") != nullptr) {
    std::ofstream(test_case.expectation(), std::ios::binary) << result.text;
    return;
  }
  ASSERT_TRUE(fs::exists(test_case.expectation())) << "run with ISL_ACCEPT=1, then look at what it wrote";
  EXPECT_EQ(result.text, read(test_case.expectation()));
}

std::string test_name(const testing::TestParamInfo<Case>& parameter) {
  return std::string(parameter.param.stage->name) + "_" + parameter.param.name;
}

INSTANTIATE_TEST_SUITE_P(Stages, Golden, testing::ValuesIn(find_cases()), test_name);

}  // namespace
}  // namespace isl::test
