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
  const Component* component;
  const KernelConstants* kernel;
  double support_root;  ///< √q at the border of the support
  std::uint32_t branch;
  std::array<Reach, 2> ends;

  [[nodiscard]] double first_end() const { return std::min(ends[0].coordinate, ends[1].coordinate); }
  [[nodiscard]] double last_end() const { return std::max(ends[0].coordinate, ends[1].coordinate); }
  [[nodiscard]] double support_end() const {
    return std::max(ends[0].coordinate + support_root * ends[0].radius,
                    ends[1].coordinate + support_root * ends[1].radius);
  }
};

/// The coordinate along one direction beyond which a blob has no surface.
class EndOfSurface {
 public:
  EndOfSurface(const Database& database, const scene::Blob& blob, const BranchTree& tree)
      : database_(database), blob_(blob), tree_(tree), sums_(std::max(tree.size(), 1U)) {}

  /// A component that ends before another one whose own surface reaches farther adds nothing, so most are not kept.
  void add(const Profile& profile) {
    const double support_end = profile.support_end();
    high_ = std::max(high_, support_end);
    first_end_ = std::min(first_end_, profile.first_end());
    if (support_end <= low_) return;
    profiles_.push_back(profile);
    if (profile.last_end() > low_ && most_beyond(profile, profile.last_end()) >= blob_.threshold)
      low_ = profile.last_end();
  }

  /// As small as this method finds; nothing if the blob has no surface at all.
  [[nodiscard]] std::optional<double> find() {
    if (profiles_.empty()) return std::nullopt;
    if (high_ == kInfinity) return high_;
    if (low_ == -kInfinity) {  // no component has a surface alone
      if (!(sum_beyond(first_end_) >= blob_.threshold)) return std::nullopt;
      low_ = first_end_;
    }
    std::erase_if(profiles_, [this](const Profile& profile) { return profile.support_end() <= low_; });
    double low = low_, high = high_;
    constexpr int kSteps = 24;  // 2⁻²⁴ of the bracket, less than a printed box shows
    for (int step = 0; step < kSteps; ++step) {
      const double middle = low + (high - low) / 2;
      (sum_beyond(middle) >= blob_.threshold ? low : high) = middle;
    }
    return high;
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  /// Upper bound of the component's field in the half-space beyond `a`. Coordinate and radius are linear between the
  /// ends, so (a − coordinate)/radius is monotone and is least at an end.
  [[nodiscard]] double most_beyond(const Profile& profile, double a) const {
    double root_q = kInfinity;
    for (const Reach& end : profile.ends) {
      if (end.coordinate >= a) return most_at(database_, blob_, *profile.component, *profile.kernel, 0);
      if (end.radius > 0) root_q = std::min(root_q, (a - end.coordinate) / end.radius);
    }
    return most_at(database_, blob_, *profile.component, *profile.kernel, root_q * root_q);
  }

  [[nodiscard]] double sum_beyond(double a) {
    if (blob_.is_unblended) {
      double greatest = 0;
      for (const Profile& profile : profiles_) greatest = std::max(greatest, most_beyond(profile, a));
      return greatest;
    }
    std::ranges::fill(sums_, 0);
    for (const Profile& profile : profiles_) sums_[profile.branch] += most_beyond(profile, a);
    tree_.add_up(sums_);
    return sums_[0];
  }

  const Database& database_;
  const scene::Blob& blob_;
  const BranchTree& tree_;
  std::vector<Profile> profiles_;
  std::vector<double> sums_;      ///< upper bounds, by branch
  double low_ = -kInfinity;       ///< the farthest end of a component that has a surface alone
  double high_ = -kInfinity;      ///< no support reaches here
  double first_end_ = kInfinity;  ///< the least coordinate of all ends
};

}  // namespace

Box3d box_of_blob(const Database& database, const std::vector<KernelConstants>& kernels, const scene::Blob& blob) {
  const std::array<Vec3, 6> directions{Vec3(-1, 0, 0), Vec3(1, 0, 0),  Vec3(0, -1, 0),
                                       Vec3(0, 1, 0),  Vec3(0, 0, -1), Vec3(0, 0, 1)};
  const BranchTree tree({blob.branches.begin(), blob.branches.end()});
  std::vector<EndOfSurface> ends(directions.size(), EndOfSurface(database, blob, tree));
  std::vector<double> support_roots;
  for (const KernelConstants& kernel : kernels) support_roots.push_back(std::sqrt(kernel.support_q()));
  for (std::uint32_t i = 0; i < blob.components.size(); ++i) {
    const Component& c = blob.components[i];
    if (!(c.strength > 0)) continue;
    std::array<std::array<Reach, 2>, directions.size()> reaches;
    set_reaches(database, blob, c, directions, reaches);
    const std::size_t kernel = index(c.kernel);
    const std::uint32_t branch = blob.branches.empty() ? 0 : blob.branch_of[i];
    for (std::size_t k = 0; k < ends.size(); ++k)
      ends[k].add({&c, &kernels[kernel], support_roots[kernel], branch, reaches[k]});
  }
  Box3d box;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const std::optional<double> a = ends[k].find();
    if (!a) return {};
    const int axis = static_cast<int>(k / 2);
    (k % 2 == 0 ? box.min : box.max)[axis] = k % 2 == 0 ? -*a : *a;
  }
  return box;
}

}  // namespace isl::render
