// What docs/language.md says about fields ("Fields in closed form") against what the program makes of scenes: single
// components with random numbers at random points, and whole blobs through the language's own `inside`.
#include "tests/reference/documented_fields.h"
#include "renderer/fields/component_table.h"
#include "renderer/queries/object_queries.h"
#include "tests/interpreter/evaluated_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace isl::documented {
namespace {

using scene::Vec3;

class Random {
 public:
  explicit Random(unsigned seed) : random_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  /// From low to high, evenly by its logarithm.
  double size(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
  Vec3 point(double reach) { return {between(-reach, reach), between(-reach, reach), between(-reach, reach)}; }
  double hardness() { return size(0.3, 30); }

 private:
  std::mt19937_64 random_;
};

Vector exactly(const Vec3& v) { return {v.x, v.y, v.z}; }
std::string text(const Vec3& v) { return fmt::format("<{:.17g}, {:.17g}, {:.17g}>", v.x, v.y, v.z); }

/// The field of the first component of the first blob of a scene.
double field_in(const scene::Database& database, const Vec3& p) {
  const scene::Blob& blob = database.blobs.at(0);
  const scene::Component& component = blob.components[0];
  return render::field_at(database, blob, component,
                          render::kernel_constants(database.kernels[scene::index(component.kernel)]), p);
}

/// Both are solved and evaluated in double and long double; near its border a kernel is a small difference.
void expect_near(double found, Real documented, const std::string& scene, const Vec3& p) {
  ASSERT_NEAR(found, static_cast<double>(documented), 1e-10 * std::max(1.0, std::abs(static_cast<double>(documented))))
      << scene << " at " << text(p);
}

constexpr std::string_view kKernels[] = {"quartic", "cubic", "gaussian", "soft", "metaball", "cauchy"};
constexpr std::string_view kConvolved[] = {"quartic", "cauchy"};

/// Calls use(text of a component, its documented q) for each kind of component, with numbers of their own.
template <class Use>
void for_each_component(Random& random, const Use& use) {
  const Vec3 a = random.point(1), b = random.point(1), c = random.point(1);
  const double r = random.size(0.1, 1), r2 = random.size(0.05, 2), ring = random.size(0.3, 2);
  const Vector a_ = exactly(a), b_ = exactly(b), c_ = exactly(c);
  const auto ends = text(a) + ", " + text(b);
  use(fmt::format("sphere {{ {}, {:.17g} }}", text(a), r), [=](const Vector& p) { return sphere(p, a_, r); });
  use(fmt::format("cylinder {{ {}, {:.17g} }}", ends, r), [=](const Vector& p) { return cylinder(p, a_, b_, r); });
  use(fmt::format("cone {{ {}, {:.17g}, {}, {:.17g} }}", text(a), r, text(b), r2),
      [=](const Vector& p) { return cone(p, a_, r, b_, r2); });
  use(fmt::format("box {{ {}, {:.17g} }}", ends, r), [=](const Vector& p) { return box(p, a_, b_, r); });
  use(fmt::format("torus {{ {:.17g}, {:.17g} }}", ring, r), [=](const Vector& p) { return torus(p, ring, r); });
  use(fmt::format("disc {{ {}, {:.17g}, {:.17g} }}", ends, ring, r),
      [=](const Vector& p) { return disc(p, a_, b_, ring, r); });
  use(fmt::format("triangle {{ {}, {}, {:.17g} }}", ends, text(c), r),
      [=](const Vector& p) { return triangle(p, a_, b_, c_, r); });
  use(fmt::format("plane {{ {}, {:.17g}, {:.17g} }}", text(a), r2, r),
      [=](const Vector& p) { return plane(p, a_, r2, r); });
}

TEST(DocumentedFields, AreThoseOfEveryKernelAndSkeleton) {
  Random random(1);
  int positive = 0;
  for (int i = 0; i < 40; ++i) {
    for (const std::string_view name : kKernels) {
      const double h = random.hardness(), strength = random.between(-2, 2);
      const Kernel documented = kernel(name, h);
      for_each_component(random, [&](std::string component, const auto& q) {
        component.insert(component.size() - 1, fmt::format("strength {:.17g} ", strength));
        const std::string scene = fmt::format("blob {{ kernel \"{}\" hardness {:.17g} {} }}", name, h, component);
        const test::EvaluatedText read(scene);
        ASSERT_EQ(read.sink().has_errors(), false) << read.messages();
        for (int j = 0; j < 5; ++j) {
          const Vec3 p = random.point(2.5);
          const Real value = strength * documented.value(q(exactly(p)));
          positive += value != 0;
          expect_near(field_in(read.database(), p), value, scene, p);
        }
      });
      if (testing::Test::HasFatalFailure()) return;
    }
  }
  EXPECT_GT(positive, 1'000);
}

TEST(DocumentedFields, AreThoseOfPovRaysComponents) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Vec3 a = random.point(1), b = random.point(1), p = random.point(1);
    const double r = random.size(0.5, 3), s = random.between(-2, 2);
    const Kernel documented = kernel("", 0);
    const std::string ball = fmt::format("blob {{ sphere {{ {}, {:.17g}, {:.17g} }} }}", text(a), r, s);
    expect_near(field_in(test::EvaluatedText(ball).database(), p),
                s * documented.value(sphere(exactly(p), exactly(a), r)), ball, p);
    const std::string limb = fmt::format("blob {{ cylinder {{ {}, {}, {:.17g}, {:.17g} }} }}", text(a), text(b), r, s);
    expect_near(field_in(test::EvaluatedText(limb).database(), p),
                s * documented.value(cylinder(exactly(p), exactly(a), exactly(b), r)), limb, p);
  }
}

TEST(DocumentedFields, AreThoseOfConvolutions) {
  Random random(3);
  int positive = 0;
  for (int i = 0; i < 60; ++i) {
    for (const std::string_view name : kConvolved) {
      const double h = random.hardness(), r = random.size(0.1, 1), ring = random.size(0.05, 2);
      const Vec3 a = random.point(1), b = random.point(1);
      const Convolution documented(name, h);
      const Kernel documented_plane = plane_kernel(name, h);
      const auto scene_of = [&](const std::string& component) {
        return fmt::format("blob {{ kernel \"{}\" hardness {:.17g} convolution on {} }}", name, h, component);
      };
      const std::string limb = scene_of(fmt::format("cylinder {{ {}, {}, {:.17g} }}", text(a), text(b), r));
      const std::string loop = scene_of(fmt::format("torus {{ {:.17g}, {:.17g} }}", ring, r));
      const std::string sheet = scene_of(fmt::format("plane {{ {}, {:.17g}, {:.17g} }}", text(a), ring, r));
      const test::EvaluatedText limb_read(limb), loop_read(loop), sheet_read(sheet);
      for (int j = 0; j < 10; ++j) {
        const Vec3 p = random.point(1.1);
        const Real value = documented.cylinder(exactly(p), exactly(a), exactly(b), r);
        positive += value > 0;
        expect_near(field_in(limb_read.database(), p), value, limb, p);
        expect_near(field_in(loop_read.database(), p), documented.torus(exactly(p), ring, r), loop, p);
        expect_near(field_in(sheet_read.database(), p),
                    documented_plane.value(convolved_plane(exactly(p), exactly(a), ring, r)), sheet, p);
      }
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GT(positive, 200);
}

TEST(DocumentedFields, KernelsAreOneAtTheRadiusWithTheHardnessAsSlope) {
  for (const Real h : {0.3L, 0.5L, 1.0L, 2.0L, 4.0L, 30.0L}) {
    for (const std::string_view name : kKernels) {
      const Kernel documented = kernel(name, h);
      EXPECT_NEAR(static_cast<double>(documented.value(1)), 1, 1e-15) << name << ' ' << h;
      // The metaball's two pieces meet at the radius for h = 1/2, with different curvatures.
      const Real step = 1e-6L, slope = (documented.value(1 + step) - documented.value(1 - step)) / (2 * step);
      EXPECT_NEAR(static_cast<double>(slope / -h), 1, 1e-6) << name << ' ' << h;
      EXPECT_NEAR(static_cast<double>(documented.value(documented.border * (1 - 1e-9L))), 0, 1e-9) << name << ' ' << h;
    }
  }
}

TEST(DocumentedFields, TheTableOfCauchysConstantsIsRight) {
  const Real rows[][3] = {{0.5L, 6.118884L, 7.900461L}, {1, 2.754990L, 4.307880L},   {2, 1.103459L, 2.533555L},
                          {4, 0.3384716L, 1.682244L},   {8, 0.05448509L, 1.299361L}, {20, 0.0002798884L, 1.107273L}};
  for (const auto& [h, epsilon, border] : rows) {
    const CauchyConstants constants = cauchy_constants(h);
    EXPECT_NEAR(static_cast<double>(constants.epsilon / epsilon), 1, 5e-7) << h;
    EXPECT_NEAR(static_cast<double>(constants.border / border), 1, 5e-7) << h;
  }
}

/// A blob of everything that the page says about sums: a part with its own threshold, a union, a carving component, a
/// transform that deforms, a component of another kernel.
TEST(DocumentedFields, WholeBlobsAreInsideWhereTheDocumentedSumReachesTheThreshold) {
  const auto expect_said = [](const std::string& scene, const std::string& said) {
    render::ObjectQueries queries;  // one for each scene, since it knows a database by its place
    interpreter::EvaluateOptions options;
    options.queries = &queries;
    const test::EvaluatedText read(scene, options);
    ASSERT_EQ(read.messages(), "");
    ASSERT_EQ(read.said(), said) << scene;
  };
  Random random(4);
  int tried = 0;
  for (int i = 0; i < 600; ++i) {
    const double h = random.hardness(), part_threshold = random.size(0.3, 3);
    const Vec3 a = random.point(1), b = random.point(1), c = random.point(1), p = random.point(1.2);
    const Vector q = exactly(p), a_ = exactly(a), b_ = exactly(b), c_ = exactly(c);
    const Kernel k = kernel("soft", h), other = kernel("cauchy", h);
    const auto sum_at = [&](Real threshold) {
      const Vector deformed = {q[0] / 2, q[1], (q[2] - 1) / 3};
      const Real in_part = k.value(cylinder(q, a_, b_, 0.4L)) * threshold / part_threshold;
      const Real in_union =
          std::max(k.value(sphere(q, b_, 0.5L)), k.value(sphere(q, c_, 0.3L)) + k.value(sphere(q, a_, 0.3L)));
      return k.value(sphere(q, a_, 0.7L)) + k.value(sphere(deformed, c_, 0.5L)) + in_part + in_union +
             Real(-0.25L) * other.value(sphere(q, c_, 0.6L));
    };
    // The part's share grows with the threshold: the sum at T is first + T·rest, and meets T at one place.
    const Real first = sum_at(0), rest = sum_at(1) - first, threshold = first / (1 - rest);
    if (!(threshold > 0.01L && std::isfinite(threshold) && rest < 0.99L)) continue;
    const auto inside = [&](Real t) {
      return fmt::format(
          "#declare B = blob {{ threshold {:.17g} kernel \"soft\" hardness {:.17g} sphere {{ {}, 0.7 }}"
          " sphere {{ {}, 0.5 scale <2, 1, 3> translate z }} blob {{ threshold {:.17g} cylinder {{ {}, {}, 0.4 }} }}"
          " union {{ sphere {{ {}, 0.5 }} blob {{ sphere {{ {}, 0.3 }} sphere {{ {}, 0.3 }} }} }}"
          " kernel \"cauchy\" hardness {:.17g} sphere {{ {}, 0.6 strength -0.25 }} }}"
          " #debug str(inside(B, {}), 0, 0)",
          static_cast<double>(t), h, text(a), text(c), part_threshold, text(a), text(b), text(b), text(c), text(a), h,
          text(c), text(p));
    };
    expect_said(inside(threshold * (1 - 1e-9L)), "1");
    expect_said(inside(threshold * (1 + 1e-9L)), "0");
    if (HasFatalFailure()) return;
    ++tried;
  }
  EXPECT_GT(tried, 100);
}

}  // namespace
}  // namespace isl::documented
