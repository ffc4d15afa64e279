#include "renderer/reference/reference_tracer.h"

#include "base/check.h"

#include <algorithm>
#include <queue>

namespace isl::ISL_REFERENCE {
namespace {

/// Leaves the root at t = 0. Returns the t up to which F keeps the sign that it gets there, or can get any.
Real leave_start(const FieldOnRay& field, RootSearch& search, Real end) {
  const Jet start = field.at(0);
  constexpr int kMostHalvings = 100;
  for (int i = 0; i < kMostHalvings; ++i) {
    // F(t)/t is a mean of slopes, and F′(0) + ½F″t for some F″ before t.
    const Jet whole = field.over(0, end);
    const int sign = common(whole.slope, start.slope + whole.bend * Interval(0, end / 2)).sign();
    if (sign != 0) {
      search.constant(sign);
      return end;
    }
    end /= 2;
  }
  search.doubt(0, end);
  return end;
}

}  // namespace

RayRoots roots_along(const ReferenceField& reference_field, const Line& ray, const RootOptions& options) {
  FieldOnRay field(reference_field, ray);
  RootSearch search(field, options.first_only);
  const Real begin = std::max(field.begin(), Real(0)), end = std::min(field.end(), options.t_max);
  const Jet start = field.at(0);
  if (begin >= end) {  // nothing changes beyond the ray's start
    if (const int sign = start.value.sign(); !options.starts_on_root && sign != 0) search.constant(sign);
    return search.finish();
  }
  Real from = begin;
  // A start may be off by the tolerance. In a wall that a carving component makes steeper than that, its level may lie
  // far below the surface's, and mean nothing; but it is outside. Where fields many times the threshold all but cancel,
  // rounding alone moves F as far.
  const bool is_beyond_wall = start.value.hi() < -abs(field.threshold()) - options.start_band;
  if (options.starts_on_root && !is_beyond_wall) {
    // The start is only as near to the surface as doubles allow. Near it, the level on which it lies counts, until the
    // ray is eight times as far away as the start is off. Farther away, where F can be steep, the surface itself
    // counts.
    const Real offset = start.value.middle();
    field.raise_threshold(offset);
    from = leave_start(field, search, end);
    const Real settled = std::min(end, std::max(from, 8 * abs(offset) / start.slope.mignitude()));
    search.search(from, settled);
    from = settled;
    field.raise_threshold(-offset);
  } else if (const int sign = start.value.sign() != 0 ? start.value.sign() : options.coming_from; sign != 0) {
    search.constant(sign);
  }
  search.search(from, end);
  return search.finish();
}

Interval largest_value(const FieldOnRay& field, Real t0, Real t1) {
  struct Piece {
    Real bound, t0, t1;
    FieldOnRay::Active active;
    bool operator<(const Piece& other) const { return bound < other.bound; }
  };
  Real reached = std::max(field.at(t0).value.lo(), field.at(t1).value.lo());
  std::priority_queue<Piece> pieces;
  const auto add = [&](Real begin, Real end, FieldOnRay::Active active) {
    const JetPair f = field.on(active, stretch_between(begin, end));
    reached = std::max(reached, f.middle.value.lo());
    pieces.push({f.over.value.hi(), begin, end, std::move(active)});
  };
  add(t0, t1, field.all());
  const Real precision = abs(field.threshold()) * 1e-15L;
  for (int step = 0; step < 4000 && pieces.top().bound - reached > precision; ++step) {
    const Piece top = pieces.top();
    const Real cut = top.t0 + (top.t1 - top.t0) / 2;
    if (!(top.t0 < cut && cut < top.t1)) break;
    pieces.pop();
    add(top.t0, cut, top.active);
    add(cut, top.t1, top.active);
  }
  return {reached, std::max(reached, pieces.top().bound)};
}

ReferenceScene::ReferenceScene(const scene::Database& database) { place(database, database.objects, {}); }

void ReferenceScene::place(const scene::Database& database, const std::vector<scene::Object>& objects,
                           const scene::Transform& world_from_parent) {
  for (const scene::Object& object : objects) {
    const scene::Transform world_from_object = then(object.parent_from_object, world_from_parent);
    if (object.kind == scene::Object::Kind::group) {
      place(database, database.groups[object.shape].children, world_from_object);
    } else if (object.kind == scene::Object::Kind::blob) {
      placed_.push_back({ReferenceField(database, database.blobs[object.shape]), world_from_object, object.no_shadow});
    }
  }
}

Line ReferenceScene::field_ray(const Placed& placed, const scene::Vec3& origin, const scene::Vec3& direction) {
  if (placed.world_from_object.inverse == scene::Matrix()) return {interval_of(origin), interval_of(direction)};
  return {transformed_point(interval_of(origin), placed.world_from_object.inverse),
          transformed_vector(interval_of(direction), placed.world_from_object.inverse)};
}

std::optional<ReferenceScene::Hit> ReferenceScene::first_hit(const scene::Vec3& origin, const scene::Vec3& direction,
                                                             RootOptions options) const {
  ISL_CHECK(!options.starts_on_root || placed_.size() == 1, "{} blobs", placed_.size());
  options.first_only = true;
  std::optional<Hit> nearest;
  for (std::size_t i = 0; i < placed_.size(); ++i) {
    const RayRoots roots = roots_along(placed_[i].field, field_ray(placed_[i], origin, direction), options);
    if (roots.crossings.empty()) continue;
    nearest = Hit{roots.crossings.front(), i};
    options.t_max = nearest->crossing.t;
  }
  return nearest;
}

}  // namespace isl::ISL_REFERENCE
