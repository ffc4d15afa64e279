// The ovus beside POV-Ray 3.7, and where its three arcs meet: no line falls between them, and none meets both.
#include "renderer/solids/solid.h"
#include "tests/renderer/solids/membership.h"

#include <gtest/gtest.h>

namespace isl::render::test {
namespace {

scene::Solid ovus(double bottom_radius, double top_radius) {
  scene::Solid solid;
  solid.kind = scene::SolidKind::ovus;
  solid.radius_a = bottom_radius;
  solid.radius_b = top_radius;
  return solid;
}

/// A line from <-5, y, z> along x, and what POV-Ray's `trace` says of it.
struct Met {
  double bottom_radius, top_radius, y, z, x;
  Vec3 normal;
};

/// Twelve decimals, of where the line starts too, which a slanting surface makes more of.
constexpr double kPrinted = 5e-12;

TEST(Ovus, is_met_where_povray_meets_it) {
  const Met all[] = {
      {1, 0.6, 1.48022548968, 0.110466280396, -0.342316636986, {-0.57052772831, 0.800375816133, 0.184110467326}},
      {1, 0.6, -0.566184447139, -0.465132917502, -0.680504622228, {-0.680504622228, -0.566184447139, -0.465132917502}},
      {1, 0.6, 0.922301100269, -0.11702422393, -0.776325092333, {-0.882477936077, 0.451150550135, -0.133025837532}},
      {1, 0.6, 0.253276566987, 0.301716349973, -0.93927954348, {-0.945587607672, 0.116638283494, 0.303742632901}},
      {0.6, 1, 1.498652337421, 0.110466280396, -0.424524648687, {-0.424524648687, 0.898652337421, 0.110466280396}},
      {0.6, 1, -0.232925301425, -0.465132917502, -0.417541214909, {-0.498027841874, -0.666462650713, -0.554793478624}},
      {0.6, 1, 1.026562469459, -0.11702422393, -0.896855501551, {-0.896855501551, 0.426562469459, -0.11702422393}},
      {0.6, 1, 0.460464787451, 0.301716349973, -0.943131575454, {-0.943131575454, -0.139535212549, 0.301716349973}},
      {1, 1, 1.861798641938, 0.110466280396, -0.495076056429, {-0.495076056429, 0.861798641938, 0.110466280396}},
      {1, 1, -0.499443592853, -0.465132917502, -0.730895117625, {-0.730759659705, -0.499721796426, -0.465046713701}},
      {1, 1, 1.21803973108, -0.11702422393, -0.993767879649, {-0.926925222257, 0.35901986554, -0.109152959153}},
      {1, 1, 0.446088346524, 0.301716349973, -1.092345150675, {-0.963556403688, -0.026955826738, 0.266143646021}},
      {1, 1.9, 2.72033823452, 0.110466280396, -0.798895211993, {-0.420471164207, 0.905441176063, 0.058140147577}},
      {1, 1.9, -0.349276670709, -0.465132917502, -1.254234362046, {-0.660123348445, -0.710145616162, -0.244806798685}},
      {1, 1.9, 1.883451650404, -0.11702422393, -1.678040080693, {-0.883178989838, 0.464974552844, -0.061591696805}},
      {1, 1.9, 0.879914850481, 0.301716349973, -1.872043482674, {-0.985286043513, -0.063202710273, 0.158798078933}},
      {1, 0.1, 1.003259049357, 0.110466280396, -0.236737522203, {-0.387181462454, 0.904129524678, 0.180666316}},
      {1, 0.1, -0.649610514997, -0.465132917502, -0.601379703566, {-0.601379703566, -0.649610514997, -0.465132917502}},
      {1, 0.1, 0.552627811756, -0.11702422393, -0.825171395946, {-0.825171395946, 0.552627811756, -0.11702422393}},
      {1, 0.01, 0.917405090099, 0.110466280396, -0.382315447709, {-0.382315447709, 0.917405090099, 0.110466280396}},
      {1, 0.01, -0.664627207211, -0.465132917502, -0.584741006336, {-0.584741006336, -0.664627207211, -0.465132917502}},
      {2, 2.5, 4.200563724199, 0.110466280396, -1.181235157212, {-0.472494062885, 0.88022548968, 0.044186512158}},
      {2, 2.5, -0.915461117848, -0.465132917502, -1.727098099974, {-0.824430617572, -0.52059222357, -0.222031289615}},
      {2, 2.5, 2.805752750674, -0.11702422393, -2.363697915512, {-0.945479166205, 0.322301100269, -0.046809689572}},
      {2, 2.5, 1.133191417468, 0.301716349973, -2.470431082631, {-0.986505717569, -0.110861716506, 0.120482982272}},
  };
  for (const Met& met : all) {
    const scene::Solid solid = ovus(met.bottom_radius, met.top_radius);
    const Crossings found = crossings(solid, {-5, met.y, met.z}, {1, 0, 0}, kNoPart);
    ASSERT_EQ(found.count, 2) << met.bottom_radius << " " << met.top_radius << " y " << met.y;
    EXPECT_NEAR(found.t[0] - 5, met.x, kPrinted);
    EXPECT_NEAR(found.t[1] - 5, -met.x, kPrinted);
    const Vec3 normal = normal_at(solid, found.part[0], {met.x, met.y, met.z});
    EXPECT_LT((normal - met.normal).length(), kPrinted) << met.bottom_radius << " " << met.top_radius << " y " << met.y;
  }
}

/// The middle arc's centre is c - b and c - t away from the spheres' centres; its ends lie beyond these.
struct Joints {
  double low, low_radius, high, high_radius;
};

Joints joints_of(double b, double t) {
  const double c = 2 * std::max(b, t);
  const double v = ((c - b) * (c - b) - (c - t) * (c - t) + b * b) / (2 * b);
  const double h = std::sqrt((c - b) * (c - b) - v * v);
  return {-v * b / (c - b), h * b / (c - b), b + (b - v) * t / (c - t), h * t / (c - t)};
}

TEST(Ovus, is_met_once_on_each_side_where_its_arcs_join) {
  for (const auto& [b, t] :
       {std::pair(1.0, 0.6), std::pair(0.6, 1.0), std::pair(1.0, 1.0), std::pair(1.0, 0.05), std::pair(1.0, 1.95)}) {
    const Joints joints = joints_of(b, t);
    for (const auto& [y, radius] :
         {std::pair(joints.low, joints.low_radius), std::pair(joints.high, joints.high_radius)}) {
      for (int i = -3; i <= 3; ++i) {
        // At the joint itself, and some units of the last place below and above.
        const double height = y + i * 0x1p-52;
        for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(1, 0.3, 0.1), Vec3(0.5, -2, 0), Vec3(1, 1e-9, 0)}) {
          const Vec3 aim(-radius, height, 0);
          const Crossings found = crossings(ovus(b, t), aim - direction * 4, direction, kNoPart);
          ASSERT_EQ(found.count, 2) << b << " " << t << " at " << aim << " along " << direction;
          // The line goes in or comes out there.
          EXPECT_LT(std::min(std::abs(found.t[0] - 4), std::abs(found.t[1] - 4)), 1e-14 / direction.length() * 8);
        }
      }
      const Vec3 below = normal_at(ovus(b, t), 0, {radius, y - 1e-13, 0}),
                 above = normal_at(ovus(b, t), 0, {radius, y + 1e-13, 0});
      EXPECT_LT((below - above).length(), 1e-11) << b << " " << t << ": the normals go over into one another";
    }
  }
}

TEST(Ovus, reaches_as_far_as_its_farthest_point) {
  Random random(71);
  for (int i = 0; i < 40; ++i) {
    const WholeSolid whole = random_whole(random, scene::SolidKind::ovus);
    const Vec3 direction = random.direction();
    const double reach = support({}, whole.solid, direction);
    double farthest = -1e300;
    for (int line = 0; line < 20000; ++line) {
      // Rays from the axis meet the surface once.
      const Vec3 from(0, random.uniform(-whole.solid.radius_a, whole.solid.radius_a + whole.solid.radius_b), 0);
      const Vec3 aim = random.direction();
      const Crossings found = crossings(whole.solid, from, aim, kNoPart);
      for (int k = 0; k < found.count; ++k) farthest = std::max(farthest, direction.dot(from + aim * found.t[k]));
    }
    EXPECT_LE(farthest, reach + 1e-14);
    EXPECT_GT(farthest, reach - 0.01 * (whole.solid.radius_a + whole.solid.radius_b));
  }
}

TEST(Ovus, has_a_box_that_follows_from_its_reach) {
  Random random(72);
  for (int i = 0; i < 1000; ++i) {
    const WholeSolid whole = random_whole(random, scene::SolidKind::ovus);
    const Box box = bounds(whole.solid), reach = box_of({}, whole.solid, {});
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(box.min[axis], reach.min[axis], 1e-15);
      EXPECT_NEAR(box.max[axis], reach.max[axis], 1e-15);
    }
  }
}

TEST(Ovus, holds_what_is_within_its_surface) {
  Random random(73);
  int inside = 0;
  for (int i = 0; i < 20000; ++i) {
    const WholeSolid whole = random_whole(random, scene::SolidKind::ovus);
    const Vec3 point = random.in_cube(1);
    const Real gap = membership(whole, real(point));
    if (std::abs(gap) < 1e-14L) continue;
    ASSERT_EQ(is_inside({}, whole.solid, point), gap < 0);
    inside += gap < 0 ? 1 : 0;
  }
  EXPECT_GT(inside, 1000);
}

TEST(Ovus, without_a_top_radius_is_the_sphere_at_its_bottom) {
  scene::Solid sphere;
  sphere.radius_a = 1;
  Random random(74);
  int met = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 direction = random.direction(), origin = random.in_cube(0.7) - direction * 3;
    const Crossings a = crossings(ovus(1, 0), origin, direction, kNoPart);
    const Crossings b = crossings(sphere, origin, direction, kNoPart);
    ASSERT_EQ(a.count, b.count);
    for (int k = 0; k < a.count; ++k) EXPECT_NEAR(a.t[k], b.t[k], 1e-13);
    met += a.count;
  }
  EXPECT_GT(met, 2000);
  // POV-Ray misses the top of such a one.
  const Crossings down = crossings(ovus(1, 0), {0, 5, 0}, {0, -1, 0}, kNoPart);
  ASSERT_EQ(down.count, 2);
  EXPECT_NEAR(down.t[0], 4, 1e-15);
  EXPECT_EQ(normal_at(ovus(1, 0), 0, {0, 1, 0}), Vec3(0, 1, 0));
}

TEST(Ovus, has_the_coordinates_of_a_sphere_half_way_up_to_its_top_radius) {
  // The values were read off POV-Ray's pigments at this point.
  const Coordinates found = solid_coordinates(ovus(1, 0.6), {-0.475, 0.925, -0.623162}, {9, 9, 9});
  EXPECT_NEAR(found.u, 0.6464, 1e-4);
  EXPECT_NEAR(found.v, 0.7143, 1e-4);
}

}  // namespace
}  // namespace isl::render::test
