// The kernels' bounds of their derivatives, and of those of f along a ray, compared with dense samples of the
// definitions.
#include "renderer/fields/kernels/kernels-inl.h"
#include "tests/renderer/fields/kernels/kernel_definition.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace isl::render {
namespace {

namespace lanes = HWY_NAMESPACE;

double first_lane(const lanes::Octet& x) {
  alignas(64) double out[lanes::kOctet];
  lanes::store(x, out);
  return out[0];
}

KernelDefinition definition_of(const scene::Kernel& kernel, double border) {
  if (kernel.mode == scene::FieldMode::sheet) {
    return kernel.shape == scene::KernelShape::quartic ? cubic_definition(kernel.hardness, border)
                                                       : cauchy_sheet_definition(kernel.hardness, border);
  }
  switch (kernel.shape) {
#define ISL_KERNEL(word, Type)   \
  case scene::KernelShape::word: \
    return word##_definition(kernel.hardness, border);
#include "renderer/scene/kernel_shapes.def"
#undef ISL_KERNEL
  }
  return {};
}

/// The relative error of the samples themselves: near the surface of a hard kernel Q − 1 has lost three of a double's
/// digits.
constexpr double kKernelRounding = 1e-12;

class KernelBounds : public testing::TestWithParam<scene::Kernel> {
 protected:
  /// φ and its derivatives with respect to v, without the amplitude, as in the product.
  [[nodiscard]] Derivatives at(long double v) const {
    Derivatives d = definition_.at(v / constants_.scale);
    long double unit = constants_.amplitude;
    for (long double& each : d) {
      each /= unit;
      unit *= constants_.scale;
    }
    return d;
  }
  /// v where φ″ jumps.
  [[nodiscard]] double jump() const { return static_cast<double>(definition_.jump * constants_.scale); }

  /// Calls check with the kernel's own class.
  template <class Check>
  void with_kernel(const Check& check) const {
    lanes::with_each_kernel(constants_, check);
  }

  KernelConstants constants_ = kernel_constants(GetParam());
  KernelDefinition definition_ = definition_of(GetParam(), constants_.support_q());
};

/// Fractions of the support, in equal steps and down to where the hardest kernels have their peaks.
std::vector<double> fractions(int steps) {
  std::vector<double> list = {0, 1e-200, 1e-107, 1e-60, 1e-30, 1e-12, 1e-6, 1e-4, 1e-3, 1e-2};
  for (int i = 1; i < steps; ++i) list.push_back(static_cast<double>(i) / steps);
  return list;
}

/// A fraction of the support: 1e-15 of a radius on the ray. Nothing shorter matters, and next to a peak of 1e-107 the
/// derivatives over anything shorter overflow a double.
constexpr double kShortest = 1e-30;

/// Calls check(v0, u_near, u_far) over a lattice of intervals within the support.
template <class Check>
void over_lattice(double support, const Check& check) {
  const std::vector<double> starts = fractions(12);
  std::vector<double> u = fractions(24);
  u.push_back(1);
  for (const double start : starts) {
    const double v0 = support * start, room = support - v0;
    for (std::size_t near = 0; near < u.size(); ++near) {
      for (std::size_t far = near + 1; far < u.size(); ++far) {
        if (u[far] >= kShortest) check(v0, room * u[near], room * u[far]);
      }
    }
  }
}

TEST_P(KernelBounds, HoldTheSecondAndFourthDerivativeAlongARay) {
  constexpr double kKappa = 0.7;
  with_kernel([&](const auto& kernel) {
    over_lattice(constants_.support, [&](double v0, double u_near, double u_far) {
      const lanes::SecondAndFourth bounds =
          kernel.on_quadratic(lanes::Octet(v0), lanes::Octet(kKappa), lanes::Octet(u_near), lanes::Octet(u_far));
      const double low = first_lane(bounds.low), high = first_lane(bounds.high), fourth = first_lane(bounds.fourth);
      const bool smooth = lanes::bits(kernel.is_smooth(lanes::Octet(v0 + u_near), lanes::Octet(v0 + u_far))) & 1;
      for (int i = 0; i <= 16; ++i) {
        const auto where = [&] { return fmt::format("v0 = {}, u = {} to {}, sample {}", v0, u_near, u_far, i); };
        const long double u = u_near + (static_cast<long double>(u_far) - u_near) * i / 16;
        // f = φ(v0 + κτ²), u = κτ².
        const Derivatives d = at(v0 + u);
        const long double slope = 2 * kKappa * d[1], bend = 4 * kKappa * u * d[2];
        // The border itself is rounded; towards it the second derivative of a sheet vanishes.
        const long double moved = 0x1p-51L * (v0 + u) * kKappa * (6 * d[2] + 4 * u * std::abs(d[3]));
        const long double slack = kKernelRounding * (std::abs(slope) + bend) + moved;
        ASSERT_GE(slope + bend, low - slack) << where();
        ASSERT_LE(slope + bend, high + slack) << where();
        if (!smooth) continue;
        const long double fourth_here = 4 * kKappa * kKappa * (3 * d[2] + 12 * u * d[3] + 4 * u * u * d[4]);
        ASSERT_LE(std::abs(fourth_here), fourth * (1 + kKernelRounding)) << where();
      }
    });
  });
}

TEST_P(KernelBounds, HoldTheKernelItself) {
  with_kernel([&](const auto& kernel) {
    for (const double start : fractions(200)) {
      const double v = constants_.support * start;
      ASSERT_GE(first_lane(most_of(kernel, lanes::Octet(v))), at(v)[0] * (1 - kKernelRounding)) << v;
    }
  });
}

TEST_P(KernelBounds, HoldTheDerivativesOfTheKernelFromAnyPlaceOn) {
  with_kernel([&](const auto& kernel) {
    for (const double start : fractions(50)) {
      const double least = constants_.support * start;
      const lanes::SlopeBounds bounds = kernel.slopes(lanes::Octet(least));
      const double bound[] = {first_lane(bounds.first), first_lane(bounds.second), first_lane(bounds.third),
                              first_lane(bounds.fourth)};
      for (int i = 0; i <= 100; ++i) {
        const long double v = least + (static_cast<long double>(constants_.support) - least) * i / 100;
        const Derivatives d = at(v);
        for (int order = 1; order <= 4; ++order)
          ASSERT_LE(std::abs(d[order]), bound[order - 1] * (1 + kKernelRounding))
              << "order " << order << ", " << least << ' ' << v;
      }
    }
  });
}

TEST_P(KernelBounds, CurvatureIsTheSecondDerivative) {
  with_kernel([&](const auto& kernel) {
    for (const double start : fractions(100)) {
      const double v = constants_.support * start * (1 - 1e-9);
      const long double expected = at(v)[2];
      const double curvature = first_lane(kernel.curvature(lanes::Octet(v)));
      // A bound that overflows a double may be infinite.
      if (curvature == static_cast<double>(expected)) continue;
      ASSERT_LE(std::abs(curvature - expected), kKernelRounding * expected) << v;
    }
  });
}

TEST_P(KernelBounds, IsSmoothExactlyWhereTheSecondDerivativeDoesNotJump) {
  with_kernel([&](const auto& kernel) {
    int jumps = 0;
    over_lattice(constants_.support, [&](double v0, double u_near, double u_far) {
      const double low = v0 + u_near, high = v0 + u_far;
      const bool expected = !(low < jump() && jump() < high);
      jumps += expected ? 0 : 1;
      const bool smooth = lanes::bits(kernel.is_smooth(lanes::Octet(low), lanes::Octet(high))) & 1;
      ASSERT_EQ(smooth, expected) << low << " to " << high;
    });
    EXPECT_EQ(jumps > 0, GetParam().shape == scene::KernelShape::metaball);
  });
}

TEST_P(KernelBounds, AreOfTheSizeOfTheDerivativesOnShortIntervals) {
  // Along a ray through the middle of a hard component f is e^500 there and next to nothing in the tail: the bounds in
  // the tail must be of the tail's size, or intervals there would be halved to no end.
  with_kernel([&](const auto& kernel) {
    const auto is_tight = [](double bound, long double size) {
      return bound <= 2 * size || size > std::numeric_limits<double>::max();
    };
    for (const double start : fractions(12)) {
      for (const double fraction : fractions(24)) {
        if (fraction > 0 && fraction < kShortest) continue;
        const double v0 = constants_.support * start, room = constants_.support - v0, u_near = room * fraction;
        const lanes::SecondAndFourth bounds = kernel.on_quadratic(
            lanes::Octet(v0), lanes::Octet(1), lanes::Octet(u_near), lanes::Octet(std::min(u_near * 1.05, room)));
        // The sizes of the terms of the derivatives, from here to twice as far.
        long double second = 0, fourth = 0;
        for (int i = 0; i <= 100; ++i) {
          const long double u = std::min(u_near * (1 + i / 100.0), room);
          const Derivatives d = at(v0 + u);
          second = std::max(second, std::abs(2 * d[1]) + std::abs(4 * u * d[2]));
          fourth = std::max(fourth, std::abs(12 * d[2]) + std::abs(48 * u * d[3]) + std::abs(16 * u * u * d[4]));
        }
        ASSERT_TRUE(is_tight(std::abs(first_lane(bounds.low)), second)) << v0 << ' ' << u_near;
        ASSERT_TRUE(is_tight(std::abs(first_lane(bounds.high)), second)) << v0 << ' ' << u_near;
        ASSERT_TRUE(is_tight(first_lane(bounds.fourth), fourth)) << v0 << ' ' << u_near;
      }
    }
  });
}

std::vector<scene::Kernel> kernels() {
  struct Row {
    scene::KernelShape shape;
    std::vector<double> hardnesses;
  };
  using enum scene::KernelShape;
  const Row rows[] = {{quartic, {4}},
                      {cubic, {0.5, 4, 500}},
                      {gaussian, {0.01, 0.5, 4, 60, 300, 500}},
                      {soft, {0.5, 4, 60, 500}},
                      {metaball, {0.2, 0.5, 1, 4, 60, 500}},
                      {cauchy, {0.5, 1, 4, 8, 60, 300, 500}}};
  std::vector<scene::Kernel> list;
  for (const Row& row : rows) {
    for (const double hardness : row.hardnesses) list.push_back({row.shape, scene::RadiusMeaning::surface, hardness});
  }
  for (const Row& row : {Row{quartic, {4}}, Row{cauchy, {0.5, 1, 4, 8, 60, 90, 300}}}) {
    for (const double hardness : row.hardnesses)
      list.push_back({row.shape, scene::RadiusMeaning::surface, hardness, scene::FieldMode::sheet});
  }
  return list;
}

INSTANTIATE_TEST_SUITE_P(Kernels, KernelBounds, testing::ValuesIn(kernels()), [](const auto& given) {
  return std::string(scene::kKernelWords[static_cast<std::size_t>(given.param.shape)]) +
         (given.param.mode == scene::FieldMode::sheet ? "_sheet_" : "_") +
         std::to_string(std::lround(given.param.hardness * 100)) + "_hundredths";
});

}  // namespace
}  // namespace isl::render
