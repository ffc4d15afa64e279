// The scenes of plain solids and their combinations look as POV-Ray draws them, in linear light. Only a few pixels at
// outlines differ, where one ray a pixel falls on one side or the other. Skipped if povray is not installed.
#include "tests/cli/program/ppm_values.h"
#include "tests/cli/program/program_fixture.h"
#include "tests/support/source_folder.h"

#include <cmath>
#include <cstdlib>

namespace isl::test {
namespace {

/// A picture of 4:3, for which cameras without a `right` agree too.
constexpr int kWidth = 320, kHeight = 240;

class PovrayPictures : public ProgramTest {
 protected:
  [[nodiscard]] std::vector<double> values(const std::string& name) const { return ppm_values(read(name)); }

  static double linear(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4); }

  /// The share of pixels that differ by more than one of our eight-bit steps.
  [[nodiscard]] double share_that_differs(const std::string& scene) const {
    const std::string file = std::string(ISL_SOURCE_DIR) + "/scenes/features/" + scene;
    const std::string size = std::to_string(kWidth) + "x" + std::to_string(kHeight);
    const ProcessResult ours =
        run({"render", file, "-s", size, "--samples", "1", "-D", "Beyond=0.001", "-o", "ours.ppm"});
    EXPECT_EQ(ours.exit_code, 0) << ours.err;
    const std::string command = "cd '" + folder().string() + "' && povray '+I" + file + "' +W" +
                                std::to_string(kWidth) + " +H" + std::to_string(kHeight) +
                                " -A -D +FP16 File_Gamma=1.0 Declare=Beyond=0.001 +Otheirs.ppm >/dev/null 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0);
    const std::vector<double> a = values("ours.ppm"), b = values("theirs.ppm");
    EXPECT_EQ(a.size(), std::size_t{3 * kWidth * kHeight});
    EXPECT_EQ(a.size(), b.size());
    if (a.size() != b.size()) return 1;
    int differing = 0;
    for (std::size_t i = 0; i < a.size(); i += 3) {
      double largest = 0;
      for (std::size_t k = i; k < i + 3; ++k) largest = std::max(largest, std::abs(linear(a[k]) - b[k]));
      if (largest > 0.02) ++differing;
    }
    return static_cast<double>(differing) / (kWidth * kHeight);
  }

  static bool has_povray() { return std::system("povray --version >/dev/null 2>&1") == 0; }
};

TEST_F(PovrayPictures, OfSolidsAgreeButForOutlines) {
  if (!has_povray()) GTEST_SKIP() << "povray is not installed";
  EXPECT_LT(share_that_differs("solids.isl"), 0.003);
}

TEST_F(PovrayPictures, OfEggsAgreeButForOutlines) {
  if (!has_povray()) GTEST_SKIP() << "povray is not installed";
  EXPECT_LT(share_that_differs("ovus.isl"), 0.003);
}

TEST_F(PovrayPictures, OfPatternsOnSurfacesAgreeButForOutlines) {
  if (!has_povray()) GTEST_SKIP() << "povray is not installed";
  EXPECT_LT(share_that_differs("uv_solids.isl"), 0.003);
}

TEST_F(PovrayPictures, OfTexturesMadeOfTexturesAgreeButForOutlines) {
  if (!has_povray()) GTEST_SKIP() << "povray is not installed";
  EXPECT_LT(share_that_differs("layers.isl"), 0.003);
}

TEST_F(PovrayPictures, OfCombinationsAgreeButForOutlines) {
  if (!has_povray()) GTEST_SKIP() << "povray is not installed";
  EXPECT_LT(share_that_differs("csg.isl"), 0.003);
}

}  // namespace
}  // namespace isl::test
