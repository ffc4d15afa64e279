// Which fields are near a packet's rays, compared with the distances of the centres from each ray's stretch: none that
// a stretch meets is left out, and for a single ray none that is farther than the rounding allows for is kept.
#include "renderer/fields/component_table.h"
#include "renderer/fields/packet/near_fields-inl.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace {

namespace lanes = HWY_NAMESPACE;

class NearFields : public ::testing::Test {
 protected:
  double unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  Vec3 in_cube() { return Vec3(2 * unit() - 1, 2 * unit() - 1, 2 * unit() - 1); }

  /// Balls in a cube around `middle`.
  ComponentTable balls(const Vec3& middle, double size) {
    database_ = {};
    database_.kernels.push_back({scene::KernelShape::gaussian, scene::RadiusMeaning::surface, 4});
    scene::Blob& blob = database_.blobs.emplace_back();
    for (int i = 0; i < 300; ++i) {
      scene::Component c;
      c.skeleton = scene::Skeleton::point;
      c.a = middle + in_cube() * size;
      c.radius_a = size * 0.2 * std::pow(unit(), 4) + 1e-4 * size;
      c.kernel = scene::KernelId{0};
      blob.components.push_back(c);
      blob.origins.push_back({});
    }
    return compile_components(database_, blob);
  }

  /// Rays about a common one, with stretches in a cube around `middle` that is `reach` times as large as that of the
  /// balls.
  RayPacket packet(const Vec3& middle, double size, double reach, double spread) {
    RayPacket rays;
    const Vec3 from = in_cube() * (reach * size), to = in_cube() * (reach * size);
    for (std::size_t lane = 0; lane < kPacket; ++lane) {
      const Vec3 a = middle + from + in_cube() * (spread * size), b = middle + to + in_cube() * (spread * size);
      const double speed = 0.5 + unit();
      for (int i = 0; i < 3; ++i) {
        rays.origin[i][lane] = a[i] - (b[i] - a[i]) * 0.25;
        rays.direction[i][lane] = (b[i] - a[i]) * speed;
      }
      rays.t0[lane] = 0.25 / speed;
      rays.t1[lane] = (0.25 + unit()) / speed;
    }
    return rays;
  }

  std::mt19937_64 bits_{11};
  scene::Database database_;
};

/// The distance of a ray's stretch from a point.
long double distance(const RayPacket& rays, std::size_t lane, const Vec3& point) {
  long double x[3], d[3], dot = 0, square = 0;
  for (int i = 0; i < 3; ++i) {
    d[i] = rays.direction[i][lane];
    x[i] = static_cast<long double>(point[i]) - rays.origin[i][lane];
    dot += x[i] * d[i];
    square += d[i] * d[i];
  }
  const long double t = std::clamp<long double>(square > 0 ? dot / square : 0, rays.t0[lane], rays.t1[lane]);
  long double sum = 0;
  for (int i = 0; i < 3; ++i) sum += (x[i] - t * d[i]) * (x[i] - t * d[i]);
  return std::sqrt(sum);
}

TEST_F(NearFields, AreAllThatStretchesMeet) {
  int met = 0, kept_far = 0, far = 0;
  const struct {
    Vec3 middle;
    double size;
  } places[] = {{Vec3(0), 1}, {Vec3(1e6, -3e5, 2e6), 1}, {Vec3(1e-12), 1e-12}, {Vec3(-1e12), 1e12}, {Vec3(0), 1e-30}};
  for (const auto& [middle, size] : places) {
    const ComponentTable table = balls(middle, size);
    const double support = std::sqrt(table.groups[0].kernel.support);
    for (int i = 0; i < 20000; ++i) {
      const double reach = i % 10 == 0 ? 300 : 1, spread = std::pow(10.0, -4 * unit());
      const RayPacket rays = packet(middle, size, reach, spread);
      const std::uint32_t in_use = i % 3 == 0 ? 1U << (i % 8) : static_cast<std::uint32_t>(1 + bits_() % 255);
      std::vector<std::uint32_t> items(lanes::kLeastTested + bits_() % (lanes::kMostTested - lanes::kLeastTested + 1));
      for (std::uint32_t& item : items) item = static_cast<std::uint32_t>(bits_() % table.size());
      std::sort(items.begin(), items.end());
      items.erase(std::unique(items.begin(), items.end()), items.end());
      std::vector<std::uint32_t> near(items.size());
      near.resize(lanes::near_fields(table.supports, rays, lanes::mask_of(in_use), items, near.data()));
      ASSERT_TRUE(std::is_sorted(near.begin(), near.end()));
      ASSERT_TRUE(std::includes(items.begin(), items.end(), near.begin(), near.end()));
      for (const std::uint32_t item : items) {
        const bool is_kept = std::binary_search(near.begin(), near.end(), item);
        const double radius = support / std::sqrt(table.scale[item]);
        long double least = HUGE_VALL;
        for (std::size_t lane = 0; lane < kPacket; ++lane) {
          if ((in_use >> lane & 1) != 0)
            least = std::min(least, distance(rays, lane, {table.x[item], table.y[item], table.z[item]}));
        }
        if (least <= radius) {
          ++met;
          ASSERT_TRUE(is_kept) << "packet " << i << ", size " << size;
        } else if (std::has_single_bit(in_use)) {
          ++far;
          kept_far += is_kept;
          ASSERT_FALSE(is_kept && least > radius + 1e-4L * static_cast<long double>(reach * size)) << "packet " << i;
        }
      }
    }
  }
  EXPECT_GT(met, 10000);
  EXPECT_LT(kept_far, far / 100);
}

TEST_F(NearFields, AreAllIfAStretchIsAPoint) {
  const ComponentTable table = balls(Vec3(0), 1);
  const double support = std::sqrt(table.groups[0].kernel.support);
  for (std::uint32_t item = 0; item < table.size(); ++item) {
    RayPacket rays;
    const double radius = support / std::sqrt(table.scale[item]);
    for (std::size_t lane = 0; lane < kPacket; ++lane) {
      rays.origin[0][lane] = table.x[item] + radius * (1 - 1e-9);
      rays.origin[1][lane] = table.y[item];
      rays.origin[2][lane] = table.z[item];
      rays.direction[0][lane] = 1;
    }
    std::uint32_t near[4];
    const std::uint32_t items[] = {item};
    EXPECT_EQ(lanes::near_fields(table.supports, rays, lanes::all_lanes(), items, near), 1) << item;
  }
}

}  // namespace
}  // namespace isl::render
HWY_AFTER_NAMESPACE();
