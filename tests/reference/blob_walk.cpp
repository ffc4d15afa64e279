#include "tests/reference/blob_walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace isl::reference {
namespace {

/// A walk that finds more than this many crossings does not end.
constexpr std::size_t kMost = 5000;

double largest(const scene::Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

}  // namespace

std::string WalkCounts::text() const {
  return fmt::format(
      "{} lines, {} crossings: missing {}, extra {}, unsorted {}, misplaced {}; pairs below the least distance: {} "
      "dropped, {} kept; "
      "{} "
      "lines undecided",
      lines, crossings, missing, extra, unsorted, misplaced, dropped_pairs, kept_pairs, undecided);
}

WalkCounts& WalkCounts::operator+=(const WalkCounts& other) {
  for (std::uint64_t WalkCounts::*const count :
       {&WalkCounts::lines, &WalkCounts::crossings, &WalkCounts::missing, &WalkCounts::extra, &WalkCounts::unsorted,
        &WalkCounts::misplaced, &WalkCounts::dropped_pairs, &WalkCounts::kept_pairs, &WalkCounts::undecided}) {
    this->*count += other.*count;
  }
  return *this;
}

BlobWalk::BlobWalk(const scene::Database& database) : database_(database), field_(database, database.blobs.front()) {
  const scene::Blob& blob = database.blobs.front();
  for (const scene::Component& component : blob.components) {
    size_ = std::max({size_, largest(component.a), largest(component.b), component.radius_a, component.radius_b});
  }
  for (const scene::Vec3& corner : blob.corners) size_ = std::max(size_, largest(corner));
}

std::vector<double> BlobWalk::found_on(const LineOfSight& line, WalkCounts& counts) {
  std::vector<double> found;
  for (scene::Vec3 from = line.origin; found.size() < kMost;) {
    const auto next = queries_.trace(database_, database_.objects[0], from, line.direction).point;
    if (!next) return found;
    found.push_back((next->position - line.origin).dot(line.direction));
    if (found.size() > 1 && found.back() < found[found.size() - 2]) ++counts.unsorted;
    from = next->position;
  }
  counts.extra += kMost;
  return found;
}

bool BlobWalk::stays_near(const FieldOnRay& field, const LineOfSight& line, long double t0, long double t1,
                          long double share) const {
  if (t0 > t1) std::swap(t0, t1);
  const auto band = [&](long double t) {
    const Vector<long double> p = exactly(line.origin) + exactly(line.direction) * t;
    const long double least = 0x1p-43L * (std::abs(p.x) + std::abs(p.y) + std::abs(p.z) + size_);
    return share * least * field.magnitude_at(t).gradients;
  };
  const long double most = std::max({band(t0), band(t0 + (t1 - t0) / 2), band(t1)});
  return field.stays_within({-most, most}, t0, t1);
}

bool BlobWalk::walk(const LineOfSight& line, WalkCounts& counts) {
  const Line ray{interval_of(line.origin), interval_of(line.direction)};
  const RayRoots roots = roots_along(field_, ray, {});
  const FieldOnRay field(field_, ray);
  ++counts.lines;
  if (!roots.touches.empty()) {
    ++counts.undecided;
    return true;
  }
  const std::uint64_t before = counts.wrong();
  const std::vector<double> found = found_on(line, counts);
  std::vector<long double> known;
  for (const Crossing& crossing : roots.crossings) known.push_back(crossing.t);
  counts.crossings += known.size();
  const auto near = [&](long double t0, long double t1, long double share) {
    return stays_near(field, line, t0, t1, share);
  };
  for (std::size_t i = 0, k = 0; i < found.size() || k < known.size();) {
    const bool both = i < found.size() && k < known.size();
    // A point that was found is rounded, which is less than a quarter of the least distance.
    if (both && near(found[i], known[k], 0.25L)) {
      ++i, ++k;
    } else if (both && near(found[i], known[k], 1)) {
      ++counts.misplaced;
      ++i, ++k;
    } else if (k + 1 < known.size() && near(known[k], known[k + 1], 1)) {
      ++counts.dropped_pairs;
      k += 2;
    } else if (i + 1 < found.size() && near(found[i], found[i + 1], 1)) {
      ++counts.kept_pairs;
      i += 2;
    } else if (k < known.size() && (!both || known[k] < found[i])) {
      ++counts.missing;
      ++k;
    } else {
      ++counts.extra;
      ++i;
    }
  }
  return counts.wrong() == before;
}

}  // namespace isl::reference
