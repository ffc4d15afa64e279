// The search of cell_search-inl.h for eight rays at once. They walk the grid together (grid/packet_walk-inl.h), and
// those that meet a cell are solved there together, one ray in every lane (packet_solver-inl.h). A single ray, and
// whatever lanes cannot do, goes to the search for one ray.
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
#include "renderer/solvers/certified/packet_solver-inl.h"

#include <bit>
#include <optional>

HWY_BEFORE_NAMESPACE();
namespace isl::render {
namespace HWY_NAMESPACE {

class PacketSearch {
 public:
  /// True if rays can be searched together in this blob.
  [[nodiscard]] static bool takes(const CompiledBlob& blob) { return blob.grid.beyond == scene::kNone; }

  /// `rays` is memory that the search may use.
  PacketSearch(const CompiledBlob& blob, const SolverSettings& settings, LaneMemory& lanes, PacketMemory& packet,
               RayPacket& rays, TraceCounters& counters)
      : blob_(blob), settings_(settings), lanes_(lanes), counters_(counters), fields_(packet), packet_(rays) {}

  /// hits[i] becomes the hit of rays[i] if bit i of `in_use` is set.
  void first_hits(const BlobRay* rays, std::uint32_t in_use, BlobHit* hits) {
    std::uint32_t meeting = 0;
    for_each_lane(in_use, [&](std::size_t lane) {
      if (begin(lane, rays[lane])) {
        meeting |= 1u << lane;
      } else {
        hits[lane] = {};
      }
    });
    if (meeting == 0) return;
    const auto visit =
        [&](std::uint32_t index, const Cell& cell, const OctetMask& lanes, const Octet& enter, const Octet& leave)
            HWY_ATTR { return mask_of(this->visit(index, cell, bits(lanes), enter, leave)); };
    PacketWalk(blob_.grid, packet_, visit).walk(meeting, Octet(0.0), load(reach_));
    for_each_lane(meeting, [&](std::size_t lane) { hits[lane] = searches_[lane]->hit(); });
  }

 private:
  /// Fewer rays than this are quicker one by one.
  static constexpr int kFewest = 2;

  template <class Use>
  static HWY_INLINE void for_each_lane(std::uint32_t lanes, const Use& use) {
    for (; lanes != 0; lanes &= lanes - 1) use(static_cast<std::size_t>(std::countr_zero(lanes)));
  }

  /// True if the ray meets the grid's box.
  bool begin(std::size_t lane, const BlobRay& ray) {
    const BoxSpan span = Search::span_in_grid(blob_.grid, ray);
    if (!(span.enter < span.leave)) return false;
    Search& search = searches_[lane].emplace(blob_, settings_, lanes_, counters_);
    search.begin(ray);
    search.enter_grid(span);
    for (int axis = 0; axis < 3; ++axis) {
      packet_.origin[axis][lane] = search.origin()[axis];
      packet_.direction[axis][lane] = ray.direction[axis];
    }
    reach_[lane] = span.leave - search.base();
    least_[lane] = search.lengths().by_tolerance;
    any_ = ray.any;
    return true;
  }

  /// Lets rays meet a cell. Returns the rays that are done.
  std::uint32_t visit(std::uint32_t index, const Cell& cell, std::uint32_t lanes, const Octet& enter,
                      const Octet& leave) {
    store(enter, packet_.t0);
    store(leave, packet_.t1);
    std::uint32_t together = 0, starting = 0, done = 0;
    for_each_lane(lanes, [&](std::size_t lane) {
      switch (searches_[lane]->arrive({index, cell, packet_.t0[lane], packet_.t1[lane]})) {
        case Arrival::crosses: done |= 1u << lane; break;
        case Arrival::passes: break;
        case Arrival::starting_leaf: starting |= 1u << lane; [[fallthrough]];
        case Arrival::candidate_leaf: together |= 1u << lane; break;
        case Arrival::other_candidate:
          if (solve_alone(index, cell, lane)) done |= 1u << lane;
          break;
      }
    });
    if (std::popcount(together) >= kFewest) return done | solve_together(index, cell, together, starting);
    for_each_lane(together, [&](std::size_t lane) {
      if (solve_alone(index, cell, lane)) done |= 1u << lane;
    });
    return done;
  }

  bool solve_alone(std::uint32_t index, const Cell& cell, std::size_t lane) {
    return searches_[lane]->solve_in({index, cell, packet_.t0[lane], packet_.t1[lane]});
  }

  /// Searches a leaf for rays that come from outside or, those in `starting`, begin there on the surface. Returns those
  /// that cross there.
  std::uint32_t solve_together(std::uint32_t index, const Cell& cell, std::uint32_t together, std::uint32_t starting) {
    const OctetMask lanes = mask_of(together), starts = mask_of(starting);
    fields_.set_up(blob_.components, blob_.grid.items.data() + cell.first, cell.count(), packet_, lanes);
    // A bound that is no number knows nothing.
    const OctetMask open = and_not(and_not(starts, fields_.upper_bound() < Octet(0.0)), lanes);
    roots_.found = roots_.undecided = 0;
    if (!none(open)) {
      PacketSolver(fields_, counters_)
          .first_roots({open, starts, load(packet_.t0), load(packet_.t1), load(least_), any_}, roots_);
    }
    for_each_lane(together & ~roots_.undecided, [&](std::size_t lane) { searches_[lane]->set_passed(); });
    std::uint32_t done = roots_.found;
    for_each_lane(roots_.found, [&](std::size_t lane) { searches_[lane]->set_crossing(roots_.t[lane]); });
    for_each_lane(roots_.undecided, [&](std::size_t lane) {
      if (solve_alone(index, cell, lane)) done |= 1u << lane;
    });
    return done;
  }

  using Search = CellSearch<HermiteSolver>;
  using Arrival = Search::Arrival;

  const CompiledBlob& blob_;
  const SolverSettings& settings_;
  LaneMemory& lanes_;
  TraceCounters& counters_;
  PacketLanes fields_;

  bool any_ = false;  ///< BlobRay::any, the same for all rays
  std::optional<Search> searches_[kPacket];
  RayPacket& packet_;
  alignas(64) double reach_[kPacket]{};  ///< where each ray leaves the grid's box
  alignas(64) double least_[kPacket]{};  ///< the shortest interval to be judged, for each ray
  PacketRoots roots_;
};

}  // namespace HWY_NAMESPACE
}  // namespace isl::render
HWY_AFTER_NAMESPACE();

#endif
