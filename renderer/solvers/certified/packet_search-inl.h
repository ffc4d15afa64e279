// The search of cell_search-inl.h for eight rays at once. They walk the grid together (grid/packet_walk-inl.h), and
// those that meet a cell are solved there together, one ray in every lane (packet_solver-inl.h). A single ray among
// limbs, and whatever lanes cannot do, goes to the search for one ray.
//
// If the components are smaller than the distance between two rays, each cell is met by few rays of the packet, and
// most lanes would be empty. So a ray that may cross in a cell of points leaves the walk and waits. When the walk has
// ended for the other rays, all that wait are solved together, each in its own cell. Of the camera's rays that wait, 94
// to 98 in 100 cross; the others walk on from their cell. Rays that look for any hit do not wait: a third of them would
// not cross, and to walk on would take as long as waiting saves.
#if defined(ISL_RENDERER_SOLVERS_CERTIFIED_PACKET_SEARCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISL_RENDERER_SOLVERS_CERTIFIED_PACKET_SEARCH_INL_H_
#undef ISL_RENDERER_SOLVERS_CERTIFIED_PACKET_SEARCH_INL_H_
#else
#define ISL_RENDERER_SOLVERS_CERTIFIED_PACKET_SEARCH_INL_H_
#endif

#include "renderer/compiled/compiled_scene.h"
#include "renderer/grid/packet_walk-inl.h"
#include "renderer/rays/trace_counters.h"
#include "renderer/solvers/cells/cell_search-inl.h"
#include "renderer/solvers/certified/hermite-inl.h"
#include "renderer/solvers/certified/octet_blob_rays-inl.h"
#include "renderer/solvers/certified/packet_memory.h"
#include "renderer/solvers/certified/packet_solver-inl.h"

#include <bit>
#include <memory>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

class PacketSearch {
 public:
  /// True if rays can be searched together in this blob.
  [[nodiscard]] static bool takes(const CompiledBlob& blob) { return blob.grid.beyond == scene::kNone; }

  PacketSearch(const CompiledBlob& blob, const SolverSettings& settings, const OctetBlobRays& rays, LaneMemory& lanes,
               PacketMemory& memory, TraceCounters& counters)
      : blob_(blob),
        settings_(settings),
        rays_(rays),
        lanes_(lanes),
        counters_(counters),
        fields_(memory.fields),
        waiting_fields_(memory.waiting),
        packet_(memory.rays),
        fewest_(blob.components.plain_points == blob.components.size() ? 1 : 2) {}

  /// The first hits of the rays whose bits in `in_use` are set.
  void first_hits(std::uint32_t in_use, OctetBlobHits& hits) {
    hits.found = hits.from_inside = hits.undecided = 0;
    hits_ = &hits;
    if (!(blob_.grid.cell_size > 0)) return;
    const auto& [origin, direction] = rays_.lines;
    const PacketAxes axes(direction);
    const OctetSpans span = clip_to_box(blob_.grid.core, origin, axes, rays_.t_max);
    const OctetMask meeting = (span.enter < span.leave) & mask_of(in_use);
    if (none(meeting)) return;
    // Origins move to where the rays meet the core, so that the fields see small numbers even if the grid is far away;
    // t counts from there. A ray that begins in the grid's box keeps its origin (CellSearch::span_in_grid).
    base_ = select(begin_in(blob_.grid.box, origin), Octet(0.0), span.enter);
    const OctetVector from = origin + direction * base_;
    put(from, packet_.origin);
    put(direction, packet_.direction);
    const Octet length2 = direction.dot(direction);
    store(length2, packet_.length2);
    store(Octet(1.0) / length2, packet_.per_length2);
    const LengthByDistance tolerance = settings_.tolerance_along_ray();
    least_ = Octet(kShortestOfTolerance) *
             (Octet(tolerance.at_eye) + Octet(tolerance.per_distance) * (rays_.path_length + base_));
    starts_ = on_surface_ = mask_of(rays_.start_on_surface) & (base_ <= Octet(0.0));
    outside_ = base_ > Octet(0.0);
    inside_ = no_lane();
    reached_ = Octet(0.0);
    store(Octet(scene::kNone), last_cell_);
    const auto visit = [&](std::uint32_t index, const Cell& cell, const OctetMask& lanes, const Octet& enter,
                           const Octet& leave) HWY_ATTR { return this->visit(index, cell, lanes, enter, leave); };
    const Octet end = span.leave - base_;
    PacketWalk walk(blob_.grid, from, axes, visit);
    followed_ = bits(meeting);
    waiting_.lanes = no_lane();
    walk.walk(followed_, Octet(0.0), end);
    while (!none(waiting_.lanes)) {
      // From the middle of its stretch a ray meets the cell again, and where it leaves it this time is where it enters
      // the next, to the last bit.
      const Octet middle = Octet(0.5) * (waiting_.t0 + waiting_.t1);
      followed_ = solve_waiting();
      meets_last_cell_ = true;
      walk.walk(followed_, middle, end);
    }
    hits.from_inside |= bits(inside_ & meeting) & ~hits.found;
  }

 private:
  using Search = CellSearch<HermiteSolver>;
  struct Alone {
    BlobRay ray;
    Search search;

    /// The ray meets the grid at t = base.
    Alone(const BlobRay& from, double base, const CompiledBlob& blob, const SolverSettings& settings, LaneMemory& lanes,
          TraceCounters& counters)
        : ray(from), search(blob, settings, lanes, counters) {
      search.begin(ray);
      search.enter_grid(base);
    }
  };

  /// Room for searches that are made when they are needed. An array of optionals would be zeroed for every packet.
  union AloneSearches {
    HWY_INLINE AloneSearches() {}
    Alone searches[kPacket];
  };

  template <class Use>
  static HWY_INLINE void for_each_lane(std::uint32_t lanes, const Use& use) {
    for (; lanes != 0; lanes &= lanes - 1) use(static_cast<std::size_t>(std::countr_zero(lanes)));
  }
  static HWY_INLINE void put(const OctetVector& v, double (&to)[3][kPacket]) {
    store(v.x, to[0]);
    store(v.y, to[1]);
    store(v.z, to[2]);
  }

  /// Lets rays meet a cell, as CellSearch::visit does for one. Returns the rays that are done, or wait.
  HWY_INLINE OctetMask visit(std::uint32_t index, const Cell& cell, const OctetMask& met, const Octet& enter,
                             const Octet& leave) {
    OctetMask lanes = met;
    if (meets_last_cell_) {
      // Rays that go on pass the rest of the cell that they have been searched in.
      lanes = met & (load(last_cell_) != Octet(index));
      reached_ = select(and_not(lanes, met), leave, reached_);
      if (none(lanes)) return lanes;
    }
    counters_.cells += static_cast<std::uint64_t>(std::popcount(bits(lanes)));
    // Between leaf cells there are only cells that are certainly outside.
    const OctetMask skipped = lanes & (enter > reached_);
    OctetMask crossing = skipped & inside_;
    if (!none(crossing)) [[unlikely]]
      cross(crossing, reached_, index);
    outside_ = outside_ | and_not(crossing, skipped);
    on_surface_ = and_not(skipped, on_surface_);
    if (cell.kind() == CellKind::inside) {
      const OctetMask goes_in = and_not(crossing, lanes & outside_);
      cross(goes_in, enter, index);
      crossing = crossing | goes_in;
      inside_ = inside_ | and_not(crossing, lanes);
      on_surface_ = and_not(lanes, on_surface_);
      reached_ = select(lanes, leave, reached_);
      followed_ &= ~bits(crossing);
      return crossing;
    }
    reached_ = select(lanes, leave, reached_);
    store(select(lanes, Octet(index), load(last_cell_)), last_cell_);
    const OctetMask present = and_not(crossing, lanes);
    const OctetMask starting = and_not(inside_, present & on_surface_);
    const std::uint32_t open = bits(present);
    const OctetMask unknown = and_not(outside_ | inside_ | starts_, present);
    std::uint32_t together = cell.kind() == CellKind::leaf ? bits(present & (outside_ | starting | unknown)) : 0;
    together &= ~corrected_;
    if (std::popcount(together) < fewest_) together = 0;
    std::uint32_t done = 0;
    store(enter, packet_.t0);
    store(leave, packet_.t1);
    if (together != 0) done = solve_together(index, cell, mask_of(together), starting, unknown, enter);
    for_each_lane(open & ~together, [&](std::size_t lane) {
      if (solve_alone(index, lane)) done |= 1u << lane;
    });
    done |= bits(crossing);
    followed_ &= ~done;
    return mask_of(done);
  }

  /// Searches a leaf for rays that come from outside, or from the surface that they start on (`starting`), or begin
  /// there on a side that is not known yet (`unknown`). Returns those that cross there, or wait.
  HWY_INLINE std::uint32_t solve_together(std::uint32_t index, const Cell& cell, const OctetMask& lanes,
                                          const OctetMask& starting, const OctetMask& unknown, const Octet& enter) {
    const OctetMask starts = lanes & starting, start_here = starts & (enter <= Octet(0.0));
    fields_.set_up(blob_.components, blob_.grid.items.data() + cell.first, cell.count(), packet_, lanes);
    // A bound that is no number knows nothing. From the surface a sum that falls does not come back, in however many
    // cells.
    const OctetMask is_below = and_not(start_here, lanes & (fields_.upper_bound() < Octet(0.0)));
    const OctetMask open = and_not(is_below | and_not(fields_.falling_from() > enter, starts), lanes);
    on_surface_ = and_not(is_below | open, on_surface_);
    outside_ = outside_ | and_not(open, lanes);
    if (none(open)) return 0;
    const PacketQuery query{
        open, starts & open, start_here & open, unknown & open, load(packet_.t0), load(packet_.t1), least_, rays_.any};
    if (!rays_.any && may_wait(open)) {
      wait(query, Octet(index));
      return bits(open);
    }
    return solve(fields_, query, Octet(index));
  }

  /// True if these rays, which are laid out, may wait, and others may join them.
  [[nodiscard]] bool may_wait(const OctetMask& rays) {
    if (none(waiting_.lanes)) {
      if (bits(rays) == followed_) return false;
      waiting_fields_.clear();
    }
    return waiting_fields_.may_adopt(fields_);
  }
  HWY_INLINE void wait(const PacketQuery& query, const Octet& cell) {
    const OctetMask& rays = query.lanes;
    waiting_fields_.adopt(fields_, rays);
    const auto add = [&](const OctetMask& of, OctetMask& to) HWY_ATTR { to = and_not(rays, to) | of; };
    add(query.starts, waiting_.starts);
    add(query.start_here, waiting_.start_here);
    add(query.unknown, waiting_.unknown);
    waiting_.lanes = waiting_.lanes | rays;
    waiting_.t0 = select(rays, query.t0, waiting_.t0);
    waiting_.t1 = select(rays, query.t1, waiting_.t1);
    waiting_cells_ = select(rays, cell, waiting_cells_);
  }
  /// Searches the cells in which rays wait. Returns the rays that do not cross there.
  std::uint32_t solve_waiting() {
    PacketQuery query = waiting_;
    query.starts = query.starts & query.lanes;
    query.start_here = query.start_here & query.lanes;
    query.unknown = query.unknown & query.lanes;
    query.least = least_;
    query.any = rays_.any;
    waiting_.lanes = no_lane();
    return bits(query.lanes) & ~solve(waiting_fields_, query, waiting_cells_);
  }

  /// Searches cells whose fields are laid out, one cell for each ray. Returns the rays that cross.
  std::uint32_t solve(const PacketLanes& fields, const PacketQuery& query, const Octet& cells) {
    PacketSolver(fields, counters_).first_roots(query, roots_);
    const OctetMask undecided = mask_of(roots_.undecided);
    outside_ = outside_ | and_not(undecided, query.lanes);
    on_surface_ = on_surface_ | (undecided & query.starts);
    std::uint32_t done = roots_.found;
    if (done != 0) record(mask_of(done), load(roots_.t), cells);
    if (roots_.undecided != 0) {
      alignas(64) double index[kPacket];
      store(cells, index);
      store(query.t0, packet_.t0);
      store(query.t1, packet_.t1);
      for_each_lane(roots_.undecided, [&](std::size_t lane) {
        if (solve_alone(static_cast<std::uint32_t>(index[lane]), lane)) done |= 1u << lane;
      });
    }
    return done;
  }

  /// True if the ray crosses in the cell.
  HWY_NOINLINE bool solve_alone(std::uint32_t index, std::size_t lane) {
    Search& search = alone(lane);
    const OctetMask here = mask_of(1u << lane);
    const Side side = !none(here & inside_) ? Side::inside : !none(here & outside_) ? Side::outside : Side::unknown;
    const bool crosses = search.solve_from(side, !none(here & on_surface_),
                                           {index, blob_.grid.cells[index], packet_.t0[lane], packet_.t1[lane]});
    inside_ = search.side() == Side::inside ? inside_ | here : and_not(here, inside_);
    outside_ = search.side() == Side::outside ? outside_ | here : and_not(here, outside_);
    on_surface_ = search.is_on_surface() ? on_surface_ | here : and_not(here, on_surface_);
    corrected_ = (corrected_ & ~(1u << lane)) | (search.is_corrected() ? 1u << lane : 0);
    const BlobHit hit = search.hit();
    if (hit.undecided_from < std::numeric_limits<double>::infinity()) {
      hits_->undecided |= 1u << lane;
      hits_->undecided_from[lane] = hit.undecided_from;
    }
    if (!crosses) return false;
    hits_->found |= 1u << lane;
    hits_->t[lane] = hit.t;
    if (rays_.any) {
      // That t may lie behind the crossing, which is in this cell.
      alignas(64) double base[kPacket];
      store(base_, base);
      hits_->t[lane] = base[lane] + packet_.t0[lane];
    }
    hits_->cell[lane] = hit.cell;
    if (hit.from_inside) hits_->from_inside |= 1u << lane;
    return true;
  }
  /// The search of a single ray, which goes on with it wherever lanes cannot.
  [[nodiscard]] Search& alone(std::size_t lane) {
    Alone& alone = alone_.searches[lane];
    if ((are_alone_ >> lane & 1) == 0) {
      alignas(64) double base[kPacket];
      store(base_, base);
      std::construct_at(&alone, rays_[lane], base[lane], blob_, settings_, lanes_, counters_);
      are_alone_ |= 1u << lane;
    }
    return alone.search;
  }

  /// Records that rays cross between cells, at t before or on the border of cell `index`.
  HWY_INLINE void cross(const OctetMask& rays, const Octet& t, std::uint32_t index) {
    const Octet last = load(last_cell_);
    record(rays, t, select(last < Octet(scene::kNone), last, Octet(index)));
    hits_->from_inside |= bits(rays & inside_);
  }
  HWY_INLINE void record(const OctetMask& rays, const Octet& t, const Octet& cell) {
    store(select(rays, base_ + t, load(hits_->t)), hits_->t);
    store(select(rays, cell, load(hits_->cell)), hits_->cell);
    hits_->found |= bits(rays);
  }

  const CompiledBlob& blob_;
  const SolverSettings& settings_;
  const OctetBlobRays& rays_;
  LaneMemory& lanes_;
  TraceCounters& counters_;
  PacketLanes fields_, waiting_fields_;
  RayPacket& packet_;
  /// Fewer rays than this are searched one by one. Among limbs a single ray is quicker by itself: with vectors of four
  /// numbers mosses and corals take 0.8 and 0.9 of the time.
  int fewest_;
  OctetBlobHits* hits_ = nullptr;

  Octet base_;                             ///< where each ray meets the grid
  Octet least_;                            ///< the shortest interval to be judged
  OctetMask starts_;                       ///< rays that start in the grid, on the surface
  OctetMask on_surface_;                   ///< those of them that have not been found to have left it
  OctetMask outside_, inside_;             ///< the sides of the rays that are known
  Octet reached_;                          ///< t up to which each ray has been followed
  alignas(64) double last_cell_[kPacket];  ///< the last cell solved, as a number
  bool meets_last_cell_ = false;           ///< rays go on from the cells that they waited in
  std::uint32_t followed_ = 0;             ///< bits of the rays that are walked and not yet done
  PacketQuery waiting_;                    ///< the rays that wait
  Octet waiting_cells_;                    ///< the cells in which they do, as numbers
  AloneSearches alone_;
  std::uint32_t are_alone_ = 0;  ///< bits of the rays whose search is made
  std::uint32_t corrected_ = 0;  ///< bits of those that CellSearch::is_corrected() holds for
  PacketRoots roots_;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
