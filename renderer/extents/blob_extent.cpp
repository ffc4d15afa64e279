// The box of a blob. Along a direction n, the sum of every component's greatest value in the half-space n·p ≥ a bounds
// the field there from above, and falls as a grows. No surface lies beyond the a at which the sum falls below the
// threshold; this a is found by bisection for the six directions of the axes. The bracket comes from single components:
// the ends of their supports outside, their own surfaces inside.
#include "renderer/extents/blob_extent.h"

#include "renderer/fields/component_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace isl::render {

using Imath::Box3d;
using scene::Component;
using scene::Database;
using scene::Vec3;

namespace {

/// A component's extent along one direction: the coordinates of its two ends, and the length of one radius at each.
struct Profile {
  const Database* database = nullptr;
  const scene::Blob* blob = nullptr;
  const Component* component = nullptr;
  const KernelConstants* kernel = nullptr;
  std::uint32_t branch = 0;
  std::array<double, 2> end{};
  std::array<double, 2> radius{};

  /// Upper bound of the component's field in the half-space beyond `a`. Coordinate and radius are linear between the
  /// ends, so (a − coordinate)/radius is monotone and is least at an end.
  [[nodiscard]] double most_beyond(double a) const {
    double root_q = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 2; ++i) {
      if (end[i] >= a) return most_at(*database, *blob, *component, *kernel, 0);
      if (radius[i] > 0) root_q = std::min(root_q, (a - end[i]) / radius[i]);
    }
    return most_at(*database, *blob, *component, *kernel, root_q * root_q);
  }
  [[nodiscard]] double support_end() const {
    const double reach = std::sqrt(kernel->support_q());
    return std::max(end[0] + reach * radius[0], end[1] + reach * radius[1]);
  }
};

class ReachOfBlob {
 public:
  ReachOfBlob(const Database& database, const std::vector<KernelConstants>& kernels, const scene::Blob& blob)
      : database_(database), kernels_(kernels), blob_(blob), tree_({blob.branches.begin(), blob.branches.end()}) {
    profiles_.reserve(blob.components.size());  // once for all directions: allocating for each took most of the time
    sums_.resize(std::max(tree_.size(), 1U));
  }

  /// A coordinate along n beyond which the blob has no surface, as small as this method finds; nothing if the blob has
  /// no surface at all.
  std::optional<double> along(const Vec3& n) {
    profiles_.clear();
    for (std::uint32_t i = 0; i < blob_.components.size(); ++i) {
      if (blob_.components[i].strength > 0) profiles_.push_back(profile_of(i, n));
    }
    return profiles_.empty() ? std::nullopt : end_of_surface();
  }

 private:
  [[nodiscard]] Profile profile_of(std::uint32_t i, const Vec3& n) const {
    const Component& c = blob_.components[i];
    const std::array<Reach, 2> reach = reach_of(database_, blob_, c, n);
    return {&database_,
            &blob_,
            &c,
            &kernels_[index(c.kernel)],
            blob_.branches.empty() ? 0 : blob_.branch_of[i],
            {reach[0].coordinate, reach[1].coordinate},
            {reach[0].radius, reach[1].radius}};
  }

  [[nodiscard]] double sum_beyond(double a) {
    if (blob_.is_unblended) {
      double greatest = 0;
      for (const Profile& profile : profiles_) greatest = std::max(greatest, profile.most_beyond(a));
      return greatest;
    }
    std::ranges::fill(sums_, 0);
    for (const Profile& profile : profiles_) sums_[profile.branch] += profile.most_beyond(a);
    tree_.add_up(sums_);
    return sums_[0];
  }

  std::optional<double> end_of_surface() {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    double low = kInfinity;    // the bound for the half-space from here on reaches the threshold
    double high = -kInfinity;  // no support reaches here
    for (const Profile& profile : profiles_) {
      low = std::min({low, profile.end[0], profile.end[1]});
      high = std::max(high, profile.support_end());
    }
    if (high == kInfinity) return high;
    if (!(sum_beyond(low) >= blob_.threshold)) return std::nullopt;
    for (const Profile& profile : profiles_) {  // a component that has a surface alone raises `low` at once
      const double own = std::max(profile.end[0], profile.end[1]);
      if (own > low && profile.most_beyond(own) >= blob_.threshold) low = own;
    }
    std::erase_if(profiles_, [low](const Profile& profile) { return profile.support_end() <= low; });
    constexpr int kSteps = 24;  // 2⁻²⁴ of the bracket, less than a printed box shows
    for (int step = 0; step < kSteps; ++step) {
      const double middle = low + (high - low) / 2;
      (sum_beyond(middle) >= blob_.threshold ? low : high) = middle;
    }
    return high;
  }

  const Database& database_;
  const std::vector<KernelConstants>& kernels_;
  const scene::Blob& blob_;
  BranchTree tree_;
  std::vector<Profile> profiles_;
  std::vector<double> sums_;  ///< upper bounds, by branch
};

}  // namespace

Box3d box_of_blob(const Database& database, const std::vector<KernelConstants>& kernels, const scene::Blob& blob) {
  Box3d box;
  ReachOfBlob reach(database, kernels, blob);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      Vec3 n(0);
      n[axis] = sign;
      const std::optional<double> a = reach.along(n);
      if (!a) return {};
      (sign < 0 ? box.min : box.max)[axis] = sign * *a;
    }
  }
  return box;
}

}  // namespace isl::render
