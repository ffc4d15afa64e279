// The bounds of convolved curves in lanes along a ray, compared with dense samples of their values: no bound is
// exceeded, wherever the support's border, an end of the curve or its axis lies, and bounds shrink as fast as they
// should.
#include "renderer/fields/convolutions/ring_lanes-inl.h"
#include "renderer/fields/convolutions/segment_lanes-inl.h"
#include "renderer/fields/kernels/curve_constants.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace isl::render {
namespace {

namespace lanes = HWY_NAMESPACE;
using lanes::Octet;

double first(const Octet& x) {
  alignas(64) double out[lanes::kOctet];
  lanes::store(x, out);
  return out[0];
}

struct Sample {
  double value, slope, noise, slope_noise;
};

/// One lane with the window of a kernel; lengths are in support radii.
template <class Lanes>
struct Field {
  KernelConstants constants;
  Lanes lane;

  template <class Use>
  auto with_window(const Use& use) const {
    if (constants.shape == scene::KernelShape::quartic) return use(lanes::QuarticWindow(constants));
    return use(lanes::CauchyWindow(constants));
  }
  [[nodiscard]] Sample at(double t) const {
    const lanes::CurvePoint p = with_window([&](const auto& window) { return lane.at(window, Octet(t), Octet(0.0)); });
    constexpr double kUnit = 0x1p-48;
    return {first(p.value), first(p.slope), kUnit * first(p.value_terms), kUnit * first(p.slope_terms)};
  }
  [[nodiscard]] double most(double t0, double t1) const {
    return first(lane.amplitude) *
           with_window([&](const auto& window) { return first(lane.most(window, t0, t1, 0.0)); });
  }
  [[nodiscard]] double least(double t0, double t1) const {
    return first(lane.amplitude) *
           with_window([&](const auto& window) { return first(lane.least(window, t0, t1, 0.0)); });
  }
  [[nodiscard]] lanes::CurveRemainder remainder(double t0, double t1) const {
    return with_window([&](const auto& w) { return lanes::curve_remainder(w, lane.stretch(t0, t1), t1 - t0); });
  }
};

struct Error {
  double value, slope;  ///< error of the cubic through both ends
  double bound, slope_bound;
};

/// Checks a stretch, and returns the error of its cubic.
template <class Lanes>
Error check(const Field<Lanes>& field, double t0, double t1, const std::string& place) {
  const double amplitude = first(field.lane.amplitude), h = t1 - t0;
  const Sample a = field.at(t0), b = field.at(t1);
  const lanes::CurveRemainder remainder = field.remainder(t0, t1);
  const double least = field.least(t0, t1), most = field.most(t0, t1);
  Error error{0, 0, amplitude * first(remainder.value), amplitude * first(remainder.slope)};
  const double b0 = a.value, b1 = a.value + h * a.slope / 3, b2 = b.value - h * b.slope / 3, b3 = b.value;
  constexpr int kSteps = 64;
  for (int i = 1; i < kSteps; ++i) {
    const double u = static_cast<double>(i) / kSteps, v = 1 - u;
    const Sample s = field.at(t0 + u * h);
    const double p = v * v * v * b0 + 3 * u * v * v * b1 + 3 * u * u * v * b2 + u * u * u * b3;
    const double dp = 3 * (v * v * (b1 - b0) + 2 * u * v * (b2 - b1) + u * u * (b3 - b2)) / h;
    const double noise = s.noise + a.noise + b.noise + h * (a.slope_noise + b.slope_noise);
    const double slope_noise = s.slope_noise + a.slope_noise + b.slope_noise + (a.noise + b.noise) * 4 / h;
    error.value = std::max(error.value, std::abs(s.value - p) - noise);
    error.slope = std::max(error.slope, std::abs(s.slope - dp) - slope_noise);
    EXPECT_GE(s.value, least - s.noise) << place << " u " << u;
    EXPECT_LE(s.value, most + s.noise) << place << " u " << u;
    if (i % 16 != 0) continue;
    // At a single place the bounds meet, but for rounding. A segment of 10⁻⁴ is the difference of distances of 1, and
    // beside a ring of 56 its core is 10⁻³ wide: these cost half of the digits. At the border of the support g is lost.
    const double t = t0 + u * h, lost = 4 * s.noise + 0x1p-26 * s.value + 0x1p-40 * amplitude;
    EXPECT_GE(field.least(t, t), s.value - lost) << place << " u " << u;
    EXPECT_LE(field.most(t, t), s.value + lost) << place << " u " << u;
  }
  EXPECT_LE(error.value, error.bound) << place;
  EXPECT_LE(error.slope, error.slope_bound) << place;
  return error;
}

class ConvolutionBounds : public testing::TestWithParam<scene::Kernel> {
 protected:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

  /// A segment as a ray sees it; every fifth ray has a special position.
  Field<lanes::SegmentLanes> random_segment(int i) {
    const KernelConstants k = curve_constants(GetParam());
    const double length = i % 3 == 0 ? std::pow(10, uniform(-4, 0)) : uniform(0, 4);
    const double angle = i % 5 == 0 ? 0 : i % 5 == 1 ? 1.5707963267948966 : uniform(0, 1.5707963267948966);
    const double dx = i % 5 == 1 ? 0 : std::cos(angle), n2 = std::sin(angle) * std::sin(angle);
    const double distance = i % 7 == 0 ? 0 : uniform(0, 1);
    return {k,
            {Octet(uniform(-1, length + 1)), Octet(0.0), Octet(dx), Octet(distance * distance), Octet(n2), Octet(0.0),
             Octet(length), Octet(k.amplitude)}};
  }
  Field<lanes::SegmentLanes> finished(Field<lanes::SegmentLanes> f) {
    f.lane.behind0 = f.lane.length - f.lane.before0;
    return f;
  }
  Field<lanes::RingLanes> random_ring(int i) {
    const KernelConstants k = curve_constants(GetParam());
    const double radius = i % 3 == 0 ? uniform(0.05, 0.6) : std::pow(10, uniform(-1, 1.5));
    const double angle = i % 5 == 0 ? 0 : i % 5 == 1 ? 1.5707963267948966 : uniform(0, 1.5707963267948966);
    const double dz = i % 5 == 1 ? 0 : std::cos(angle), n2 = std::sin(angle) * std::sin(angle);
    const double impact = i % 7 == 0 ? 0 : uniform(0, radius + 1);
    // t = 0 is where the ray is nearest to the axis, but the interesting place is where it is nearest to the ring.
    const double shift =
        impact < radius && i % 2 == 0 && n2 > 0.1 ? std::sqrt((radius * radius - impact * impact) / n2) : 0;
    return {k,
            {Octet(uniform(-1, 1) - dz * shift), Octet(dz), Octet(impact * impact), Octet(n2), Octet(0.0),
             Octet(radius), Octet(k.amplitude)}};
  }

  template <class MakeField>
  void check_many(const MakeField& make) {
    for (int i = 0; i < 1000; ++i) {
      const auto field = make(i);
      const double h = std::pow(2, uniform(-9, 1));
      const double shift = centre_of(field);
      const double t0 = shift + uniform(-1.5, 1.5 - h);
      check(field, t0, t0 + h, fmt::format("field {} from {} width {}", i, t0, h));
    }
  }
  static double centre_of(const Field<lanes::SegmentLanes>&) { return 0; }
  static double centre_of(const Field<lanes::RingLanes>& f) {
    const double gap = first(f.lane.ring_radius * f.lane.ring_radius - f.lane.n0), n2 = first(f.lane.n2);
    return gap > 0 && n2 > 0.1 ? std::sqrt(gap / n2) : 0;
  }

  std::mt19937_64 random_{11};
};

TEST_P(ConvolutionBounds, NoBoundOfASegmentIsExceeded) {
  check_many([&](int i) { return finished(random_segment(i)); });
}

TEST_P(ConvolutionBounds, NoBoundOfARingIsExceeded) {
  check_many([&](int i) { return random_ring(i); });
}

INSTANTIATE_TEST_SUITE_P(Kernels, ConvolutionBounds, testing::ValuesIn([] {
                           std::vector<scene::Kernel> list;
                           for (const auto shape : {scene::KernelShape::quartic, scene::KernelShape::cauchy}) {
                             for (const double hardness : {0.2, 1.0, 4.0, 20.0, 100.0, 500.0})
                               list.push_back({shape, scene::RadiusMeaning::surface, hardness});
                           }
                           return list;
                         }()));

}  // namespace
}  // namespace isl::render
