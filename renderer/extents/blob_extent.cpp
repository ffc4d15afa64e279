// The box of a blob. Along a direction n, the sum of what every component can reach anywhere in the half-space n·p ≥ a
// bounds the field there from above, and falls as a grows. Where it meets the threshold no surface lies beyond: found
// by bisection for the six directions of the axes. A component alone gives the bracket: its support ends outside, its
// own surface inside.
#include "renderer/extents/blob_extent.h"

#include "renderer/fields/component_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

namespace isl::render {

using Imath::Box3d;
using scene::Component;
using scene::Database;
using scene::Vec3;

namespace {

/// A component seen along one direction: its two ends' coordinates, and what one radius measures there.
struct Profile {
  const KernelConstants* kernel = nullptr;
  double strength = 0;
  std::array<double, 2> end{};
  std::array<double, 2> radius{};

  /// The most that the component reaches in the half-space beyond `a`. Between the ends coordinate and radius are
  /// linear, so their quotient is monotone and an end has its least value.
  [[nodiscard]] double most_beyond(double a) const {
    double root_q = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 2; ++i) {
      if (end[i] >= a) return strength * kernel_value(*kernel, 0);
      if (radius[i] > 0) root_q = std::min(root_q, (a - end[i]) / radius[i]);
    }
    return strength * kernel_value(*kernel, root_q * root_q);
  }
  [[nodiscard]] double support_end() const {
    const double reach = std::sqrt(kernel->support_q());
    return std::max(end[0] + reach * radius[0], end[1] + reach * radius[1]);
  }
};

Profile profile_of(const Database& database, const std::vector<KernelConstants>& kernels, const scene::Blob& blob,
                   const Component& c, const Vec3& n) {
  const std::array<Reach, 2> reach = reach_of(database, blob, c, n);
  return {&kernels[index(c.kernel)],
          c.strength,
          {reach[0].coordinate, reach[1].coordinate},
          {reach[0].radius, reach[1].radius}};
}

double sum_beyond(std::span<const Profile> profiles, double a) {
  double sum = 0;
  for (const Profile& profile : profiles) sum += profile.most_beyond(a);
  return sum;
}

/// The least a beyond which the blob has no surface, or nothing when it has none at all.
std::optional<double> reach(std::vector<Profile>& profiles, double threshold) {
  double low = std::numeric_limits<double>::infinity();  // the sum over half-spaces from here on reaches the threshold
  double high = -low;                                    // no support reaches here
  for (const Profile& profile : profiles) {
    low = std::min({low, profile.end[0], profile.end[1]});
    high = std::max(high, profile.support_end());
  }
  if (!(sum_beyond(profiles, low) >= threshold)) return std::nullopt;
  for (const Profile& profile : profiles) {  // components that have a surface alone bring `low` up at once
    const double own = std::max(profile.end[0], profile.end[1]);
    if (own > low && profile.most_beyond(own) >= threshold) low = own;
  }
  std::erase_if(profiles, [low](const Profile& profile) { return profile.support_end() <= low; });
  constexpr int kSteps = 24;  // 2⁻²⁴ of a radius: beyond what a printed box shows
  for (int step = 0; step < kSteps; ++step) {
    const double middle = low + (high - low) / 2;
    (sum_beyond(profiles, middle) >= threshold ? low : high) = middle;
  }
  return high;
}

}  // namespace

Box3d box_of_blob(const Database& database, const std::vector<KernelConstants>& kernels, const scene::Blob& blob) {
  Box3d box;
  std::vector<Profile> profiles;
  profiles.reserve(blob.components.size());  // once for all directions: touching new memory took most of the time
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      Vec3 n(0);
      n[axis] = sign;
      profiles.clear();
      for (const Component& c : blob.components) {
        if (c.strength > 0) profiles.push_back(profile_of(database, kernels, blob, c, n));
      }
      const std::optional<double> a = profiles.empty() ? std::nullopt : reach(profiles, blob.threshold);
      if (!a) return {};
      (sign < 0 ? box.min : box.max)[axis] = sign * *a;
    }
  }
  return box;
}

}  // namespace isl::render
