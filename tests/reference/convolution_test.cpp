// Convolved blobs through the public tracer, compared with fields that are integrated numerically from their
// definition, including the constants: nothing is shared with the renderer but the records of the database.
#include "renderer/reference/reference_kernel.h"
#include "tests/reference/random_scenes.h"
#include "tests/reference/small_scenes.h"
#include "tests/reference/tracer_under_test.h"

#include <gmock/gmock.h>
#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <vector>

namespace isl::reference {
namespace {

using scene::Vec3;
using testing::IsEmpty;
using testing::SizeIs;

constexpr double kPi = 3.14159265358979323846;

template <class F>
double integral(const F& f, double a, double b, int panels) {
  double sum = 0;
  for (int i = 0; i < panels; ++i) {
    const double from = a + (b - a) * i / panels, to = a + (b - a) * (i + 1) / panels;
    sum += boost::math::quadrature::gauss<double, 20>::integrate(f, from, to);
  }
  return sum;
}

/// A window by the definition in docs/language.md. It is zero and flat at q = Q, and for an endless straight skeleton
/// it gives the value 1 and the slope −h at q = 1. The Cauchy window's σ gives that skeleton the value eʰ on itself.
class Window {
 public:
  explicit Window(const scene::Kernel& kernel) : is_quartic_(kernel.shape == scene::KernelShape::quartic) {
    const double h = kernel.hardness;
    if (is_quartic_) {
      border_ = 1 + 2.5 / h;
    } else {
      double low = 0.05, high = 20;  // bracket of σ²; softer kernels would lie below, harder ones above
      for (int i = 0; i < 50; ++i) {
        sigma2_ = std::sqrt(low * high);
        border_ = border_for(h);
        (std::log(line(0) / line(1)) < h ? low : high) = sigma2_;
      }
    }
    scale_ = 1 / line(1);
  }
  [[nodiscard]] double border() const { return border_; }
  /// The window of the squared distance over the squared radius, normalised.
  [[nodiscard]] double operator()(double q) const { return q < border_ ? scale_ * raw(q) : 0; }

 private:
  [[nodiscard]] double raw(double q) const {
    if (is_quartic_) return (1 - q / border_) * (1 - q / border_);
    const auto k = [&](double x) { return 1 / ((1 + sigma2_ * x) * (1 + sigma2_ * x)); };
    const double slope = -2 * sigma2_ * k(border_) / (1 + sigma2_ * border_);
    return k(q) - k(border_) - slope * (q - border_);
  }
  [[nodiscard]] double line(double q) const {
    const double w = std::sqrt(border_ - q);
    return integral([&](double u) { return raw(q + u * u); }, -w, w, 4);
  }
  [[nodiscard]] double border_for(double h) {
    double low = 1 + 1e-3, high = 60;
    for (int i = 0; i < 50; ++i) {
      border_ = 0.5 * (low + high);
      constexpr double kStep = 1e-5;
      const double slope = (line(1 - kStep) - line(1 + kStep)) / (2 * kStep) / line(1);
      (slope > h ? low : high) = border_;
    }
    return border_;
  }

  bool is_quartic_;
  double sigma2_ = 0, border_ = 2, scale_ = 1;
};

class ConvolvedField {
 public:
  explicit ConvolvedField(const scene::Database& database) : database_(database), blob_(database.blobs[0]) {
    for (const scene::Kernel& kernel : database.kernels) windows_.emplace_back(kernel);
  }
  [[nodiscard]] double operator()(const Vec3& p) const {
    double sum = -blob_.threshold;
    for (const scene::Component& c : blob_.components) sum += c.strength * value(c, p);
    return sum;
  }

 private:
  [[nodiscard]] double value(const scene::Component& c, const Vec3& point) const {
    const Window& window = windows_[index(c.kernel)];
    const Vec3 p =
        c.transform == scene::kIdentity ? point : database_.transforms[index(c.transform)].inverse_point(point);
    const double r2 = c.radius_a * c.radius_a;
    if (c.skeleton == scene::Skeleton::segment) {
      const double length = (c.b - c.a).length();
      const Vec3 axis = (c.b - c.a) / length;
      const double foot = (p - c.a).dot(axis), rho2 = (p - c.a - axis * foot).length2();
      const double reach2 = window.border() * r2 - rho2;
      if (!(reach2 > 0)) return 0;
      const double from = std::max(0.0, foot - std::sqrt(reach2)), to = std::min(length, foot + std::sqrt(reach2));
      if (!(to > from)) return 0;
      return integral([&](double s) { return window((rho2 + (s - foot) * (s - foot)) / r2); }, from, to, 3) /
             c.radius_a;
    }
    const Vec3 from = p - c.a;
    const double z = from.dot(c.b), rho = (from - c.b * z).length();
    const auto q = [&](double angle) {
      return (rho * rho + z * z + c.radius_b * c.radius_b - 2 * rho * c.radius_b * std::cos(angle)) / r2;
    };
    if (!(q(0) < window.border())) return 0;
    double end = kPi;
    if (q(kPi) > window.border()) {
      double low = 0, high = kPi;
      for (int i = 0; i < 60; ++i) (q(0.5 * (low + high)) < window.border() ? low : high) = 0.5 * (low + high);
      end = low;
    }
    return 2 * c.radius_b / c.radius_a * integral([&](double angle) { return window(q(angle)); }, 0, end, 3);
  }

  const scene::Database& database_;
  const scene::Blob& blob_;
  std::vector<Window> windows_;
};

scene::Kernel convolved(scene::KernelShape shape, double hardness) {
  return {shape, scene::RadiusMeaning::surface, hardness, scene::FieldMode::convolution};
}
scene::Kernel convolved_quartic(double hardness) { return convolved(scene::KernelShape::quartic, hardness); }
scene::Kernel convolved_cauchy(double hardness) { return convolved(scene::KernelShape::cauchy, hardness); }

render::TracerOptions exact() { return with(render::SolverName::exact, {1e-12, false}); }

scene::Database random_convolution(RandomSource& random) {
  scene::Database database;
  for (const double hardness : {1.0, 4.0}) {
    database.kernels.push_back(convolved_quartic(hardness));
    database.kernels.push_back(convolved_cauchy(hardness));
  }
  scene::Blob& blob = database.blobs.emplace_back();
  blob.threshold = random.between(0.4, 1);
  for (int i = 0; i < 6; ++i) {
    scene::Component c;
    c.kernel = static_cast<scene::KernelId>(random.below(4));
    c.a = random.in_ball(0.7);
    c.radius_a = random.between(0.08, 0.3);
    if (random.below(3) == 0) {
      c.skeleton = scene::Skeleton::circle;
      c.b = random.direction();
      c.radius_b = random.between(0.05, 0.6);
    } else {
      c.skeleton = scene::Skeleton::segment;
      c.b = c.a + random.in_ball(random.below(3) == 0 ? 0.1 : 1);
      c.radius_b = c.radius_a;
    }
    c.strength = random.between(0.7, 2) * (random.below(5) == 0 ? -1 : 1);
    if (random.below(3) == 0) {
      c.transform = static_cast<scene::TransformId>(database.transforms.size());
      database.transforms.push_back(random_transform(random, 0.2));
    }
    blob.components.push_back(c);
    blob.origins.push_back({});
  }
  scene::Object& object = database.objects.emplace_back();
  object.kind = scene::Object::Kind::blob;
  object.shape = 0;
  return database;
}

TEST(ConvolutionAgainstQuadrature, EveryCrossingIsFoundAndIsOne) {
  RandomSource random(515);
  int crossings = 0;
  for (int blob = 0; blob < 60; ++blob) {
    const scene::Database database = random_convolution(random);
    const ConvolvedField field(database);
    const TracerUnderTest tracer(database, exact());
    for (int i = 0; i < 12; ++i) {
      const LineOfSight line = random_line(random, 4, 0.7);
      const std::vector<double> found = tracer.walk(line.origin, line.direction);
      for (const double t : found)
        EXPECT_NEAR(field(line.origin + line.direction * t), 0, 1e-8) << "blob " << blob << " ray " << i;
      std::size_t expected = 0;
      constexpr int kSteps = 600;
      double before = -1;
      for (int step = 1; step <= kSteps; ++step) {
        const double t = 1.5 + 5.0 * step / kSteps, f = field(line.origin + line.direction * t);
        expected += (f > 0) != (before > 0) ? 1 : 0;
        before = f;
      }
      crossings += static_cast<int>(expected);
      // Steps can miss a pair of crossings, but never find one that does not exist.
      EXPECT_GE(found.size(), expected) << "blob " << blob << " ray " << i;
      EXPECT_EQ(found.size() % 2, 0u) << "blob " << blob << " ray " << i;
    }
  }
  EXPECT_GT(crossings, 750);
}

TEST(ConvolutionAgainstQuadrature, EverySolverSeesTheSameSurface) {
  RandomSource random(99);
  const scene::Database database = random_convolution(random);
  const TracerUnderTest exactly(database, exact()), paper(database, with(render::SolverName::paper, {}));
  int both = 0, near = 0;
  for (int i = 0; i < 200; ++i) {
    const LineOfSight line = random_line(random, 4, 0.5);
    const render::Hit a = exactly.hit(camera_ray(line)), b = paper.hit(camera_ray(line));
    if (a.is_miss() || b.is_miss()) continue;
    ++both;
    near += std::abs(a.t - b.t) < 0.1 ? 1 : 0;
  }
  EXPECT_GT(both, 30);
  EXPECT_GT(near, both * 3 / 4);  // the published solver is not exact
}

TEST(HardCases, E43_SegmentOfNoLengthIsNoFieldAndAShortOneItsLengthTimesTheKernel) {
  for (const scene::Kernel& kernel : {convolved_quartic(4), convolved_cauchy(4)}) {
    const scene::Database nothing = one_blob(kernel, {segment({0, 0, 0}, {0, 0, 0}, 1)});
    EXPECT_THAT(TracerUnderTest(nothing, exact()).walk({0, 0, -4}, {0, 0, 1}), IsEmpty());
    const Window window(kernel);
    scene::Component shortest = segment({-0.5e-9, 0, 0}, {0.5e-9, 0, 0}, 1);
    shortest.strength = 1e9 / window(0.49);  // its surface is at distance 0.7
    const std::vector<double> roots =
        TracerUnderTest(one_blob(kernel, {shortest}), exact()).walk({0, 0, -4}, {0, 0, 1});
    ASSERT_THAT(roots, SizeIs(2));
    EXPECT_NEAR(roots[0], 3.3, 1e-6);
    EXPECT_NEAR(roots[1], 4.7, 1e-6);
  }
}

TEST(HardCases, E43_LongSegmentHasItsSurfaceAtItsRadius) {
  for (const scene::Kernel& kernel :
       {convolved_quartic(0.5), convolved_quartic(4), convolved_quartic(500), convolved_cauchy(0.5),
        convolved_cauchy(4), convolved_cauchy(60), convolved_cauchy(500)}) {
    for (const double half : {1e2, 1e5, 1e9}) {
      const scene::Database database = one_blob(kernel, {segment({-half, 0, 0}, {half, 0, 0}, 1)});
      const std::vector<double> roots = TracerUnderTest(database, exact()).walk({0.25, 0, -4}, {0, 0, 1});
      ASSERT_THAT(roots, SizeIs(2)) << kernel.hardness << " " << half;
      EXPECT_NEAR(roots[0], 3, 1e-13) << kernel.hardness << " " << half;
      EXPECT_NEAR(roots[1], 5, 1e-13) << kernel.hardness << " " << half;
    }
  }
}

TEST(HardCases, E44_RayAlongTheAxisThroughAnEndAndParallel) {
  for (const scene::Kernel& kernel : {convolved_quartic(4), convolved_cauchy(4)}) {
    const scene::Database limb = one_blob(kernel, {segment({0, 0, 0}, {6, 0, 0}, 0.5)});
    const ConvolvedField field(limb);
    const TracerUnderTest tracer(limb, exact());
    for (const auto& [origin, direction] : {std::pair{Vec3(-4, 0, 0), Vec3(1, 0, 0)},     // on the axis
                                            std::pair{Vec3(-4, 0.3, 0), Vec3(1, 0, 0)},   // parallel
                                            std::pair{Vec3(0, 0, -4), Vec3(0, 0, 1)},     // through an end, across
                                            std::pair{Vec3(-3, -3, 0), Vec3(1, 1, 0)},    // through an end, aslant
                                            std::pair{Vec3(3, 0, -4), Vec3(0, 0, 1)}}) {  // across the middle
      const std::vector<double> roots = tracer.walk(origin, direction.normalized());
      ASSERT_THAT(roots, SizeIs(2)) << origin << direction;
      for (const double t : roots) EXPECT_NEAR(field(origin + direction.normalized() * t), 0, 1e-9);
    }
    // The limb is symmetric, so both ends are at the same distance from its middle.
    const std::vector<double> along = tracer.walk({-4, 0, 0}, {1, 0, 0});
    EXPECT_NEAR(along[0] + along[1], 14, 1e-12);
    EXPECT_THAT(tracer.walk({-4, 0.5 + 1e-9, 0}, {1, 0, 0}), IsEmpty());
  }
}

TEST(HardCases, E46_RayThroughARingsAxis) {
  for (const scene::Kernel& kernel : {convolved_quartic(2), convolved_cauchy(2)}) {
    for (const double ring_radius : {0.1, 0.4, 1.5}) {
      scene::Database ring = one_blob(kernel, {circle({0, 0, 0}, {0, 1, 0}, ring_radius, 0.5)}, 0.2);
      const ConvolvedField field(ring);
      const TracerUnderTest tracer(ring, exact());
      for (const auto& [origin, direction] :
           {std::pair{Vec3(0, -4, 0), Vec3(0, 1, 0)}, std::pair{Vec3(0, 0, -4), Vec3(0, 0, 1)},
            std::pair{Vec3(1e-9, -4, 0), Vec3(0, 1, 0)}, std::pair{Vec3(-3, -3, 0), Vec3(1, 1, 0)}}) {
        const std::vector<double> roots = tracer.walk(origin, direction.normalized());
        for (const double t : roots) EXPECT_NEAR(field(origin + direction.normalized() * t), 0, 1e-9);
        EXPECT_EQ(roots.size() % 2, 0u);
        if (origin.y == 0) {
          EXPECT_FALSE(roots.empty()) << ring_radius;
        }
      }
    }
  }
}

TEST(HardCases, C26_ConvolutionScalesExactly) {
  RandomSource random(3);
  const scene::Database database = random_convolution(random);
  const TracerUnderTest plain(database, exact());
  std::vector<LineOfSight> lines;
  for (int i = 0; i < 40; ++i) lines.push_back(random_line(random, 4, 0.6));
  for (const int power : {-30, -3, 7, 30}) {
    const double factor = std::ldexp(1.0, power);
    scene::Database scaled = database;
    for (scene::Transform& transform : scaled.transforms) {
      for (int i = 0; i < 3; ++i) {
        transform.matrix[3][i] *= factor;
        transform.inverse[3][i] *= factor;
      }
    }
    for (scene::Component& c : scaled.blobs[0].components) {
      c.a *= factor;
      if (c.skeleton == scene::Skeleton::segment) c.b *= factor;
      c.radius_a *= factor;
      c.radius_b *= factor;
    }
    const TracerUnderTest tracer(scaled, with(render::SolverName::exact, {1e-12 * factor, false}));
    for (const LineOfSight& line : lines) {
      const std::vector<double> expected = plain.walk(line.origin, line.direction);
      const std::vector<double> found = tracer.walk(line.origin * factor, line.direction);
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i], expected[i] * factor);
    }
  }
}

TEST(Convolution, SplittingALimbChangesNothing) {
  for (const scene::Kernel& kernel : {convolved_quartic(3), convolved_cauchy(3)}) {
    const Vec3 a(-0.7, -0.2, 0.1), b(0.9, 0.4, -0.3), middle = a + (b - a) * 0.375;
    const TracerUnderTest whole(one_blob(kernel, {segment(a, b, 0.3)}), exact());
    const TracerUnderTest halves(one_blob(kernel, {segment(a, middle, 0.3), segment(middle, b, 0.3)}), exact());
    RandomSource random(8);
    int hits = 0;
    for (int i = 0; i < 100; ++i) {
      const LineOfSight line = random_line(random, 3, 0.3);
      const std::vector<double> one = whole.walk(line.origin, line.direction),
                                two = halves.walk(line.origin, line.direction);
      ASSERT_EQ(one.size(), two.size());
      for (std::size_t k = 0; k < one.size(); ++k) EXPECT_NEAR(one[k], two[k], 1e-11);
      hits += one.empty() ? 0 : 1;
    }
    EXPECT_GT(hits, 40);
  }
}

}  // namespace
}  // namespace isl::reference
