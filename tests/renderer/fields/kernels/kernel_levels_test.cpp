// The table of a kernel's values, compared with the kernel itself: both of its bounds hold, and they are near.
#include "renderer/fields/kernels/kernel_levels.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace isl::render {
namespace {

std::vector<KernelConstants> kernels_with_levels() {
  std::vector<KernelConstants> all = {
      kernel_constants({scene::KernelShape::quartic, scene::RadiusMeaning::support, 0})};
  for (const scene::KernelShape shape :
       {scene::KernelShape::quartic, scene::KernelShape::cubic, scene::KernelShape::gaussian, scene::KernelShape::soft,
        scene::KernelShape::metaball, scene::KernelShape::cauchy}) {
    for (const double hardness : {0.5, 4.0, 60.0, 500.0})
      all.push_back(kernel_constants({shape, scene::RadiusMeaning::surface, hardness}));
  }
  return all;
}

TEST(KernelLevels, BoundTheKernelAndTheDistanceOfItsLevels) {
  std::mt19937_64 bits(1);
  const auto unit = [&] { return static_cast<double>(bits() >> 11) * 0x1p-53; };
  for (const KernelConstants& kernel : kernels_with_levels()) {
    SCOPED_TRACE(static_cast<int>(kernel.shape));
    SCOPED_TRACE(kernel.support);
    const KernelLevels levels(kernel);
    // As far as the cores of cells allow for rounding (renderer/grid/field_cores.h).
    constexpr double kSlack = 0x1p-20;
    for (int i = 0; i < 4000; ++i) {
      const double v = unit() * kernel.support, value = kernel_profile(kernel, v);
      ASSERT_GE(levels.most_at(v), value * (1 - 1e-12));
      if (value > 0) {
        ASSERT_GE(levels.farthest_with(value * (1 - kSlack)), v);
      }
      // Not farther than the next two values of the table.
      const double beyond = v + kernel.support / 32;
      if (beyond < kernel.support) {
        ASSERT_LT(levels.most_at(beyond), value);
        ASSERT_LT(levels.farthest_with(value), beyond);
      }
    }
    EXPECT_EQ(levels.most_at(kernel.support), 0);
    EXPECT_EQ(levels.most_at(2 * kernel.support), 0);
    EXPECT_LT(levels.farthest_with(kernel_profile(kernel, 0) * 1.001), 0);
  }
}

}  // namespace
}  // namespace isl::render
