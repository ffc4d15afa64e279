// Rays through hierarchies of boxes, and points in them, against all boxes one by one. Rays are followed in long
// double, whose 64 bits decide what 53 cannot.
#include "renderer/boxes/box_tree.h"

#include "renderer/boxes/box_walk-inl.h"
#include "renderer/boxes/point_boxes.h"
#include "renderer/rays/ray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <vector>

namespace isl::render {
namespace {

namespace lanes = HWY_NAMESPACE;
using Box = Imath::Box3d;
using Real = long double;
using scene::Vec3;

/// Where a ray enters a box at t ≥ 0, up to `limit`; infinite if it does not.
Real entry(const Box& box, const Ray& ray, Real limit) {
  Real enter = 0, leave = limit;
  for (int axis = 0; axis < 3; ++axis) {
    const Real o = ray.origin[axis], d = ray.direction[axis];
    if (d == 0) {
      if (o < box.min[axis] || o > box.max[axis]) return std::numeric_limits<Real>::infinity();
      continue;
    }
    const Real a = (box.min[axis] - o) / d, b = (box.max[axis] - o) / d;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave ? enter : std::numeric_limits<Real>::infinity();
}

class BoxTrees : public testing::Test {
 protected:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  double log_uniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }

  /// Boxes of all sizes, some flat or a point, some at one place.
  std::vector<Box> boxes(std::size_t count) {
    std::vector<Box> list;
    for (std::size_t i = 0; i < count; ++i) {
      if (i % 7 == 3) {
        list.push_back(list.back());
        continue;
      }
      const Vec3 low(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
      Vec3 size(log_uniform(1e-9, 1), log_uniform(1e-3, 0.3), log_uniform(1e-3, 0.3));
      if (i % 5 == 1) size[static_cast<int>(i % 3)] = 0;
      list.emplace_back(low, low + size);
    }
    return list;
  }

  /// So many that a ray meets many of them.
  std::vector<Box> overlapping_boxes() {
    std::vector<Box> list;
    for (int i = 0; i < 300; ++i) {
      const Vec3 low(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
      list.emplace_back(low, low + Vec3(uniform(0.1, 0.5)));
    }
    return list;
  }

  /// Rays of all directions, some along axes or planes, from within and outside, some from corners.
  Ray ray(const std::vector<Box>& boxes) {
    Ray ray;
    ray.origin = Vec3(uniform(-2, 2), uniform(-2, 2), uniform(-2, 2));
    const Box& aim = boxes[random_() % boxes.size()];
    const auto kind = random_() % 4;
    if (kind == 0) ray.origin = aim.min;
    ray.direction = Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
    if (kind == 1) ray.direction = aim.max - ray.origin;
    if (kind == 2) ray.direction[static_cast<int>(random_() % 3)] = 0;
    if (kind == 3) ray.direction = aim.center() - ray.origin;
    if (!(ray.direction.length() > 0)) ray.direction = Vec3(1, 0, 0);
    ray.direction.normalize();
    return ray;
  }

  /// One to eight rays that have nothing to do with one another.
  std::vector<Ray> rays_apart(const std::vector<Box>& boxes) {
    std::vector<Ray> rays(1 + random_() % 8);
    for (Ray& r : rays) r = ray(boxes);
    return rays;
  }
  /// One to eight rays from places close to one another into almost the same direction.
  std::vector<Ray> rays_together(const std::vector<Box>& boxes) {
    std::vector<Ray> rays(1 + random_() % 8, ray(boxes));
    const double apart = log_uniform(1e-9, 0.1);
    for (std::size_t i = 1; i < rays.size(); ++i) {
      if (i % 3 != 0) rays[i].origin += Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)) * apart;
      rays[i].direction += Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)) * apart;
    }
    return rays;
  }
  static lanes::BoxRays side_by_side(const std::vector<Ray>& rays, std::uint32_t open) {
    alignas(64) double values[6][8] = {};
    for (std::size_t k = 0; k < rays.size(); ++k) {
      for (int axis = 0; axis < 3; ++axis) {
        values[axis][k] = rays[k].origin[axis];
        values[3 + axis][k] = rays[k].direction[axis];
      }
    }
    const auto loaded = [&](int axis) { return lanes::load(values[axis]); };
    return {{loaded(0), loaded(1), loaded(2)}, {loaded(3), loaded(4), loaded(5)}, open};
  }

  static BoxTree tree(const std::vector<Box>& boxes) {
    std::vector<std::uint32_t> items(boxes.size());
    for (std::uint32_t i = 0; i < items.size(); ++i) items[i] = i;
    return build_box_tree(boxes, std::move(items), [] { return true; });
  }

  /// Checks what a ray was told to meet. A ray that comes by within this share of t may be told of it.
  static void check(const std::vector<Box>& boxes, const Ray& ray, Real limit, const std::set<std::uint32_t>& met) {
    constexpr Real kNear = 0x1p-48L;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      if (std::isfinite(entry(boxes[i], ray, limit))) {
        ASSERT_TRUE(met.contains(i)) << i;
      } else if (met.contains(i)) {
        Box wide = boxes[i];
        const Real reach = 4 + limit;
        const auto by = static_cast<double>(kNear * std::min(reach, Real(16)));
        wide.min -= Vec3(by);
        wide.max += Vec3(by);
        ASSERT_TRUE(std::isfinite(entry(wide, ray, limit * (1 + kNear)))) << i;
      }
    }
  }

  std::mt19937_64 random_{5};
};

TEST_F(BoxTrees, hold_every_item_once) {
  for (const std::size_t count : {1U, 2U, 8U, 9U, 100U, 3000U}) {
    const BoxTree made = tree(boxes(count));
    std::vector<int> found(count);
    std::size_t children = 0;
    for (const BoxNode& node : made.nodes) {
      for (std::size_t i = 0; i < kBoxChildren; ++i) {
        if (!(node.planes[0][0][i] <= node.planes[0][1][i])) continue;
        ++children;
        if ((node.children[i] & BoxNode::kItem) != 0) ++found[node.children[i] & ~BoxNode::kItem];
      }
    }
    EXPECT_TRUE(std::ranges::all_of(found, [](int times) { return times == 1; })) << count;
    EXPECT_EQ(children, count + made.nodes.size() - 1);
  }
}

TEST_F(BoxTrees, stay_shallow_where_every_box_is_half_of_the_one_before) {
  std::vector<Box> nested;
  for (int i = 0; i < 2000; ++i) {
    const double size = std::ldexp(1.0, -(i % 1000));
    nested.emplace_back(Vec3(0), Vec3(size));
  }
  const BoxTree made = tree(nested);
  std::vector<std::size_t> depth(made.nodes.size(), 1);
  for (std::size_t i = 0; i < made.nodes.size(); ++i) {
    for (const std::uint32_t child : made.nodes[i].children) {
      if ((child & BoxNode::kItem) == 0) depth[child] = depth[i] + 1;
    }
  }
  EXPECT_LE(*std::ranges::max_element(depth), kDeepestBoxTree);
}

TEST_F(BoxTrees, tell_one_ray_of_all_boxes_on_its_way_nearest_first) {
  for (const std::size_t count : {1U, 5U, 60U, 400U}) {
    const std::vector<Box> list = boxes(count);
    const BoxTree made = tree(list);
    for (int i = 0; i < 2000; ++i) {
      const Ray r = ray(list);
      const double limit = i % 3 == 0 ? uniform(0, 3) : std::numeric_limits<double>::infinity();
      std::set<std::uint32_t> met;
      lanes::walk_boxes(made, r.origin, r.direction, limit, [&](std::uint32_t item, double enter) {
        EXPECT_TRUE(met.insert(item).second);
        EXPECT_LE(enter, entry(list[item], r, limit));
        return limit;
      });
      check(list, r, limit, met);
    }
  }
}

TEST_F(BoxTrees, leave_out_what_is_behind_a_limit_that_falls) {
  const std::vector<Box> list = overlapping_boxes();
  const BoxTree made = tree(list);
  std::size_t asked = 0, all = 0;
  for (int i = 0; i < 2000; ++i) {
    const Ray r = ray(list);
    Real nearest = std::numeric_limits<Real>::infinity();
    for (const Box& box : list) {
      const Real t = entry(box, r, std::numeric_limits<Real>::infinity());
      all += std::isfinite(t) ? 1 : 0;
      nearest = std::min(nearest, t);
    }
    double limit = std::numeric_limits<double>::infinity();
    lanes::walk_boxes(made, r.origin, r.direction, limit, [&](std::uint32_t item, double) {
      ++asked;
      const Real t = entry(list[item], r, std::numeric_limits<Real>::infinity());
      limit = std::min(limit, static_cast<double>(t));
      return limit;
    });
    if (!std::isfinite(nearest)) continue;
    EXPECT_EQ(limit, static_cast<double>(nearest));
  }
  EXPECT_LT(2 * asked, all);
}

TEST_F(BoxTrees, tell_eight_rays_the_same) {
  for (const std::size_t boxes_in_tree : {6U, 30U, 400U}) {
    const std::vector<Box> list = boxes(boxes_in_tree);
    const BoxTree made = tree(list);
    for (int i = 0; i < 1000; ++i) {
      const std::vector<Ray> rays = i % 2 == 0 ? rays_apart(list) : rays_together(list);
      alignas(64) double limits[8] = {};
      for (std::size_t k = 0; k < rays.size(); ++k) limits[k] = k % 2 == 0 ? uniform(0, 3) : 100;
      const std::uint32_t open = static_cast<std::uint32_t>(random_()) & ((1U << rays.size()) - 1);
      if (open == 0) continue;
      std::vector<std::set<std::uint32_t>> met(rays.size());
      lanes::walk_boxes(made, side_by_side(rays, open), limits, open, [&](std::uint32_t item, std::uint32_t present) {
        EXPECT_EQ(present & ~open, 0U);
        for (std::size_t k = 0; k < rays.size(); ++k) {
          if ((present >> k & 1) == 0) continue;
          EXPECT_TRUE(met[k].insert(item).second);
        }
        return present;
      });
      for (std::size_t k = 0; k < rays.size(); ++k) {
        if ((open >> k & 1) != 0) check(list, rays[k], limits[k], met[k]);
      }
    }
  }
}

TEST_F(BoxTrees, tell_a_point_of_all_boxes_around_it) {
  for (const std::size_t count : {1U, 7U, 60U, 2000U}) {
    const std::vector<Box> list = boxes(count);
    const BoxTree made = tree(list);
    for (int i = 0; i < 2000; ++i) {
      // Every other point is in a plane, an edge or a corner of a box.
      Vec3 point(uniform(-1.2, 1.2), uniform(-1.2, 1.2), uniform(-1.2, 1.2));
      const Box& aim = list[random_() % count];
      for (int axis = 0; i % 2 == 0 && axis < 3; ++axis) {
        if (random_() % 2 == 0) point[axis] = random_() % 2 == 0 ? aim.min[axis] : aim.max[axis];
      }
      std::set<std::uint32_t> around, expected;
      visit_boxes_around(made, point, [&](std::uint32_t item) { EXPECT_TRUE(around.insert(item).second); });
      for (std::uint32_t item = 0; item < count; ++item) {
        if (list[item].intersects(point)) expected.insert(item);
      }
      EXPECT_EQ(around, expected);
    }
  }
}

TEST_F(BoxTrees, leave_out_what_is_behind_the_limits_of_eight_rays) {
  const std::vector<Box> list = overlapping_boxes();
  const BoxTree made = tree(list);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::size_t asked = 0, all = 0;
  for (int i = 0; i < 1000; ++i) {
    const std::vector<Ray> rays = rays_together(list);
    const std::uint32_t open = (1U << rays.size()) - 1;
    alignas(64) double limits[8];
    std::ranges::fill(limits, kInfinity);
    lanes::walk_boxes(made, side_by_side(rays, open), limits, open, [&](std::uint32_t item, std::uint32_t present) {
      for (std::size_t k = 0; k < rays.size(); ++k) {
        if ((present >> k & 1) == 0) continue;
        ++asked;
        limits[k] = std::min(limits[k], static_cast<double>(entry(list[item], rays[k], kInfinity)));
      }
      return present;
    });
    for (std::size_t k = 0; k < rays.size(); ++k) {
      Real nearest = kInfinity;
      for (const Box& box : list) {
        const Real t = entry(box, rays[k], kInfinity);
        all += std::isfinite(t) ? 1 : 0;
        nearest = std::min(nearest, t);
      }
      EXPECT_EQ(limits[k], static_cast<double>(nearest));
    }
  }
  EXPECT_LT(2 * asked, all);
}

TEST_F(BoxTrees, end_when_nothing_may_be_added) {
  const std::vector<Box> list = boxes(1000);
  std::vector<std::uint32_t> items(list.size());
  for (std::uint32_t i = 0; i < items.size(); ++i) items[i] = i;
  std::size_t asked = 0;
  const BoxTree made = build_box_tree(list, items, [&] { return ++asked < 10; });
  EXPECT_EQ(made.nodes.size(), 9);
}

}  // namespace
}  // namespace isl::render
