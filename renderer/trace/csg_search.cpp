// Every leaf has a state, inside or outside, that only its own crossings change. The state of the expression, followed
// over all crossings in order, is the object (Roth 1982, Ray Casting for Modeling Solids, with states for intervals). A
// touch is no crossing, and a leaf that is missed by rounding is missed on both sides, so nothing can leak.
//
// Crossings of different leaves that are closer than their rounding (face.h) are taken together, as if at one place, so
// that coinciding faces leave neither a thin wall nor a gap between them.
//
// A ray that starts on a leaf knows its root and deflates it. Faces of other leaves that pass through the start, within
// their rounding and that of the surface it lies on, have been crossed too: they were one event when the start was hit.
// So has everything that the same leaf has before such a face. An example is a ray that comes in through one side of a
// box just below the face it starts in and leaves through that face: until then it is no deeper than the rounding. Only
// the state behind counts.
//
// Leaves are asked in the order of their boxes, each as soon as nothing nearer is left, so that those behind the first
// surface are not asked at all.
//
// Planes that cut the whole (CsgTree::cutting_planes) leave one stretch of the ray. Nothing is seen outside it, so only
// the planes at its ends are asked, and leaves only up to its end. All other planes hold on the whole stretch.
//
// A solid returns all its crossings at once. A blob is asked for one crossing at a time, in its box and only as far as
// the ray goes: each search starts on the root before, once nothing is seen there.
#include "renderer/trace/csg_search.h"

#include "renderer/solids/solid.h"

#include <algorithm>
#include <cmath>

namespace isl::render {
namespace {

bool is_later(const CsgEvent& a, const CsgEvent& b) { return a.t > b.t || (a.t == b.t && a.leaf > b.leaf); }

/// The part of a half-line from t = 0 to t_max in a box, whose sides may be infinite; from ∞ if there is none.
Stretch stretch_in(const Imath::Box3d& box, const Vec3& origin, const Vec3& direction, double t_max) {
  constexpr Stretch kNone{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Stretch stretch{0, t_max};
  for (int i = 0; i < 3; ++i) {
    if (direction[i] == 0) {
      if (!(origin[i] >= box.min[i] && origin[i] <= box.max[i])) return kNone;
      continue;
    }
    const double a = (box.min[i] - origin[i]) / direction[i], b = (box.max[i] - origin[i]) / direction[i];
    stretch.from = std::max(stretch.from, std::min(a, b));
    stretch.to = std::min(stretch.to, std::max(a, b));
  }
  return stretch.from <= stretch.to ? stretch : kNone;
}

class CsgSearch {
 public:
  CsgSearch(const CompiledScene& scene, const CsgTree& tree, const CsgRay& ray, RayFaces& faces,
            const BlobSearch& blobs, CsgMemory& memory)
      : scene_(scene), tree_(tree), ray_(ray), faces_(faces), blobs_(blobs), memory_(memory) {}

  CsgHit first_hit() {
    CsgState& state = memory_.state;
    state.reset(tree_);
    memory_.events.clear();
    if (!cut()) return {};
    sort_entries();
    while (next_ < memory_.entries.size() && begins_at_start(memory_.entries[next_])) enter_next();
    while (take_group()) {
      const CsgHit hit = memory_.group.size() == 1 ? pass_one() : pass_group();
      if (!hit.is_miss()) return hit;
      for (const CsgEvent& passed : memory_.group) {
        if (tree_.leaves[passed.leaf].kind == scene::Object::Kind::blob) follow_blob(passed);
      }
    }
    return {};
  }

 private:
  struct LocalRay {
    Vec3 origin, direction;
  };

  /// Finds the stretch that the cutting planes leave, and which of them are to be asked. False if nothing is left.
  bool cut() {
    last_ = ray_.t_max;
    if (tree_.cutting_planes.empty()) return true;
    const double least_slope = kGrazing * ray_.direction.length();
    double enter = 0, leave = ray_.t_max;
    memory_.cuts.clear();
    for (const CuttingPlane& cutting : tree_.cutting_planes) {
      const double rise = ray_.direction.dot(cutting.plane.normal);
      const double gap = cutting.plane.distance - ray_.origin.dot(cutting.plane.normal);
      // How well a crossing is known is bounded for steeper rays only.
      const bool is_known = std::abs(rise) > least_slope;
      const double t = is_known ? gap / rise : std::numeric_limits<double>::quiet_NaN();
      memory_.cuts.push_back(t);
      if (rise < 0 && t > enter) enter = t;
      if (rise > 0 && t < leave) leave = t;
    }
    // Two roundings between crossings that may coincide, and as much again for those of the numbers here.
    const double margin = 4 * most_rounding_at(std::max(enter, std::isfinite(leave) ? std::abs(leave) : 0));
    if (leave < enter - margin) return false;
    last_ = std::min(last_, leave + margin);
    for (std::size_t i = 0; i < tree_.cutting_planes.size(); ++i) {
      const CuttingPlane& cutting = tree_.cutting_planes[i];
      const double t = memory_.cuts[i];
      const bool holds = ray_.direction.dot(cutting.plane.normal) < 0 ? t < enter - margin : t > leave + margin;
      if (!holds || cutting.leaf == ray_.start_leaf) {
        memory_.entries.push_back({0, cutting.leaf});
      } else if (!tree_.leaves[cutting.leaf].is_inverse) {
        memory_.state.toggle(cutting.leaf);
      }
    }
    return true;
  }

  /// All leaves that the ray may meet, in the order of their boxes. The leaf that it starts on is the first.
  void sort_entries() {
    std::vector<CsgEntry>& entries = memory_.entries;
    for (const std::uint32_t leaf : tree_.endless_leaves) {
      const double enter = stretch_in(tree_.leaves[leaf].box, ray_.origin, ray_.direction, last_).from;
      if (enter <= last_ && enter < std::numeric_limits<double>::infinity()) entries.push_back({enter, leaf});
    }
    if (ray_.start_leaf != scene::kNone) {
      std::erase_if(entries, [&](const CsgEntry& entry) { return entry.leaf == ray_.start_leaf; });
      entries.push_back({0, ray_.start_leaf});
    }
    std::sort(entries.begin(), entries.end(), [](const CsgEntry& a, const CsgEntry& b) {
      return a.enter < b.enter || (a.enter == b.enter && a.leaf < b.leaf);
    });
  }
  /// A leaf whose box comes later is outside where the ray starts. The others tell whether they are inside there.
  [[nodiscard]] bool begins_at_start(const CsgEntry& entry) const {
    return entry.enter == 0 || entry.enter <= 2 * most_rounding_at(entry.enter);
  }
  void enter_next() {
    const CsgEntry entry = memory_.entries[next_++];
    if (tree_.leaves[entry.leaf].kind == scene::Object::Kind::blob) {
      enter_blob(entry, entry.leaf == ray_.start_leaf);
    } else {
      enter_solid(entry, entry.leaf == ray_.start_leaf);
    }
  }
  /// Enters leaves until no other one can have a crossing before the nearest one that is known.
  void enter_up_to_next() {
    while (next_ < memory_.entries.size() &&
           memory_.entries[next_].enter <= (memory_.events.empty() ? last_ : memory_.events.front().t))
      enter_next();
  }
  void push(const CsgEvent& event) {
    memory_.events.push_back(event);
    std::push_heap(memory_.events.begin(), memory_.events.end(), is_later);
  }

  [[nodiscard]] LocalRay local(const CsgLeaf& leaf) const {
    if (!leaf.is_placed) return {ray_.origin, ray_.direction};
    return {leaf.group_from_leaf.inverse_point(ray_.origin), leaf.group_from_leaf.inverse_vector(ray_.direction)};
  }

  /// The face that the ray meets in an event, at the ray's point t.
  [[nodiscard]] Face face_at(const CsgEvent& event, double t) const {
    const Vec3 reach = reach_at(faces_.reach_in(ray_.instance, *ray_.world), ray_.direction, event.t);
    return face_of(scene_, tree_.leaves[event.leaf], {event.part, event.cell}, ray_.origin + ray_.direction * t, reach,
                   faces_.gradient());
  }
  /// The rounding of t in an event.
  [[nodiscard]] double rounding_at(const CsgEvent& event) const {
    return face_at(event, event.t).along(ray_.direction);
  }
  /// An upper bound of rounding_at() for events at t.
  [[nodiscard]] double most_rounding_at(double t) const { return faces_.nearness(ray_.instance, *ray_.world, t); }

  /// A cheap test: false if is_at_start() is certainly false.
  [[nodiscard]] bool is_near_start(const CsgEvent& event) const {
    return ray_.world->start.instance != scene::kNone && event.leaf != ray_.start_leaf &&
           event.t <= most_rounding_at(event.t);
  }
  /// True if the ray starts on the face that it crosses in the event: from the start to the crossing it stays within
  /// the rounding.
  [[nodiscard]] bool is_at_start(const CsgEvent& event) const {
    if (!is_near_start(event)) return false;
    const Face face = face_at(event, event.t);
    if (event.t * face.slope(ray_.direction) > face.rounding) return false;
    return event.t * face_at(event, 0).slope(ray_.direction) <= face.rounding;
  }

  /// The stretch in which a solid's crossings count, with room for rounding: what is within the leaf's box. Its ends do
  /// not depend on what else the ray meets, so that a crossing has the same bits in whatever order objects are met, and
  /// for eight rays at once (csg_packet-inl.h).
  [[nodiscard]] Stretch stretch_of(const CsgLeaf& leaf, bool is_start) const {
    if (!gains_by_stretch(scene_.solids[leaf.shape])) return {};
    const Stretch in_box = stretch_in(leaf.box, ray_.origin, ray_.direction, std::numeric_limits<double>::infinity());
    if (std::isinf(in_box.from)) return {0, 0};
    return {.from = is_start || in_box.from <= 0 ? 0 : in_box.from - most_rounding_at(in_box.from),
            .to = in_box.to + most_rounding_at(in_box.to),
            .wanted_to = last_};
  }

  /// What a solid does before its box begins is of no account, save the state in which that leaves it.
  void enter_solid(const CsgEntry& entry, bool is_start) {
    const std::uint32_t index = entry.leaf;
    const CsgLeaf& leaf = tree_.leaves[index];
    const LocalRay ray = local(leaf);
    const double begin = entry.enter > 0 ? entry.enter - most_rounding_at(entry.enter) : 0;
    const Crossings found = boundary(scene_.solids[leaf.shape], ray.origin, ray.direction,
                                     is_start ? ray_.start_part : kNoPart, scene_.details, stretch_of(leaf, is_start));
    const auto count = static_cast<std::size_t>(found.count);
    const auto event = [&](std::size_t i) { return CsgEvent{found.t[i], index, scene::kNone, found.part[i]}; };
    std::size_t first = 0;
    while (first < count && !(found.t[first] > 0)) ++first;
    if (first < count && is_near_start(event(first))) {
      for (std::size_t i = count; i > first; --i) {
        if (is_at_start(event(i - 1))) first = i;
      }
    }
    bool is_inside = found.ends_inside;
    for (std::size_t i = count; i > first && found.t[i - 1] >= begin; --i) {
      is_inside = !is_inside;
      if (found.t[i - 1] < last_) push(event(i - 1));
    }
    if (is_inside && !leaf.is_open_surface) memory_.state.toggle(index);
  }

  /// The blob's first crossing in its box beyond t, or a miss.
  [[nodiscard]] BlobHit next_of_blob(std::uint32_t index, double t, bool starts_on_surface) const {
    const CsgLeaf& leaf = tree_.leaves[index];
    const LocalRay ray = local(leaf);
    BlobRay part;
    part.origin = ray.origin + ray.direction * t;
    part.direction = ray.direction;
    const double leave = stretch_in(leaf.box, ray_.origin, ray_.direction, std::numeric_limits<double>::infinity()).to;
    part.t_max = std::max(0.0, std::min(last_, leave + most_rounding_at(leave)) - t);
    part.starts_on_surface = starts_on_surface;
    part.path_length = ray_.path_length + t;
    part.may_go_in = true;
    BlobHit hit = blobs_.first_hit(blobs_.context, leaf.shape, part);
    hit.t += t;
    return hit;
  }

  void enter_blob(const CsgEntry& entry, bool is_start) {
    const std::uint32_t index = entry.leaf;
    const double begin = is_start ? 0 : std::max(0.0, entry.enter - most_rounding_at(entry.enter));
    BlobHit hit = next_of_blob(index, begin, is_start);
    bool is_inside = hit.from_inside;
    CsgEvent event{hit.t, index, hit.cell, 0};
    if (!hit.is_miss() && (!(event.t > 0) || is_at_start(event))) {
      is_inside = !is_inside;
      hit = next_of_blob(index, event.t, true);
      event = {hit.t, index, hit.cell, 0};
    }
    if (is_inside) memory_.state.toggle(index);
    if (!hit.is_miss() && hit.t < last_) push(event);
  }

  /// Takes the next crossing and all that coincide with it. False if there is none.
  bool take_group() {
    memory_.group.clear();
    std::vector<CsgEvent>& events = memory_.events;
    double end = 0;
    for (enter_up_to_next(); !events.empty(); enter_up_to_next()) {
      const CsgEvent next = events.front();
      if (!memory_.group.empty()) {
        const CsgEvent& first = memory_.group.front();
        if (!(next.t <= end) && !coincide(first, next)) break;
      } else {
        end = next.t;
      }
      std::pop_heap(events.begin(), events.end(), is_later);
      events.pop_back();
      memory_.group.push_back(next);
    }
    return !memory_.group.empty();
  }

  [[nodiscard]] bool coincide(const CsgEvent& a, const CsgEvent& b) const {
    const double apart = b.t - a.t;
    if (apart > 2 * most_rounding_at(b.t)) return false;
    return apart <= rounding_at(a) + rounding_at(b);
  }

  void follow_blob(const CsgEvent& event) {
    const BlobHit hit = next_of_blob(event.leaf, event.t, true);
    if (hit.is_miss() || !(hit.t < last_)) return;
    // The published solver can come back within the rounding of where it starts, and would do so for ever.
    if (!(hit.t > event.t)) return;
    push({hit.t, event.leaf, hit.cell, 0});
  }

  [[nodiscard]] bool is_seen(const CsgEvent& event) const {
    return event.part != kUnseen && tree_.leaves[event.leaf].is_seen;
  }

  [[nodiscard]] CsgHit hit_of(const CsgEvent& event) const {
    const CsgLeaf& leaf = tree_.leaves[event.leaf];
    CsgHit hit{event.t, event.leaf, event.cell, event.part, !memory_.state.leaf_holds(event.leaf)};
    if (leaf.is_open_surface) {
      const LocalRay ray = local(leaf);
      const Vec3 point = ray.origin + ray.direction * event.t;
      const bool from_back =
          normal_at(scene_.solids[leaf.shape], event.part, point, scene_.details).dot(ray.direction) > 0;
      hit.from_inside = from_back != leaf.is_inverse;
    }
    return hit;
  }

  CsgHit pass_one() {
    const CsgEvent& event = memory_.group.front();
    memory_.state.toggle(event.leaf);
    return is_seen(event) && memory_.state.shows(event.leaf) ? hit_of(event) : CsgHit{};
  }

  /// True if of two coinciding faces that of leaf a is seen. As in POV-Ray, it is that of the later child of an
  /// intersection or difference, and that of the earlier child of a union.
  [[nodiscard]] bool is_preferred(std::uint32_t a, std::uint32_t b) const {
    std::uint32_t node = tree_.leaves[a].parent, other = tree_.leaves[b].parent;
    while (node != other) {  // parents come before their children
      std::uint32_t& lower = node > other ? node : other;
      lower = tree_.nodes[lower].parent;
    }
    return tree_.nodes[node].kind == CsgNode::Kind::all ? a > b : a < b;
  }

  /// If the whole changes, that is seen once: at the leaf to be preferred among those that changed with it. Besides,
  /// surfaces are seen that show both before and after, as within a union. The first of all is the hit.
  CsgHit pass_group() {
    CsgState& state = memory_.state;
    std::vector<CsgEvent>& group = memory_.group;
    // The tree decides, so that which of several coinciding faces is seen does not depend on rounding.
    std::stable_sort(group.begin(), group.end(),
                     [this](const CsgEvent& a, const CsgEvent& b) { return is_preferred(a.leaf, b.leaf); });
    memory_.shown.clear();
    for (const CsgEvent& event : group) memory_.shown.push_back(is_seen(event) && state.shows(event.leaf) ? 1 : 0);
    state.remember();
    const bool held = state.holds();
    for (const CsgEvent& event : group) state.toggle(event.leaf);
    bool is_change_left = state.holds() != held;
    memory_.seen.clear();
    for (std::size_t i = 0; i < group.size(); ++i) {
      if (!memory_.seen.empty() && !ray_.wants_all) break;
      const CsgEvent& event = group[i];
      if (!is_seen(event)) continue;
      bool is_change = false;
      if (!tree_.leaves[event.leaf].is_open_surface) {
        const auto of_leaf =
            std::count_if(group.begin(), group.end(), [&](const CsgEvent& e) { return e.leaf == event.leaf; });
        if (of_leaf % 2 == 0) continue;  // the ray came in and went out again
        is_change = is_change_left && state.changed_with(event.leaf);
      }
      if (!is_change && (memory_.shown[i] == 0 || !state.shows(event.leaf))) continue;
      if (is_change) is_change_left = false;
      memory_.seen.push_back(hit_of(event));
    }
    return memory_.seen.empty() ? CsgHit{} : memory_.seen.front();
  }

  const CompiledScene& scene_;
  const CsgTree& tree_;
  const CsgRay& ray_;
  RayFaces& faces_;
  const BlobSearch& blobs_;
  CsgMemory& memory_;
  double last_ = 0;       ///< nothing beyond this t is seen
  std::size_t next_ = 0;  ///< the first entry that was not entered yet
};

}  // namespace

bool meets_bounds(const CsgTree& tree, const CsgRay& ray) {
  return stretch_in(tree.bounds, ray.origin, ray.direction, ray.t_max).from < std::numeric_limits<double>::infinity();
}

CsgHit first_csg_hit(const CompiledScene& scene, const CsgTree& tree, const CsgRay& ray, RayFaces& faces,
                     const BlobSearch& blobs, CsgMemory& memory) {
  return CsgSearch(scene, tree, ray, faces, blobs, memory).first_hit();
}

}  // namespace isl::render
