// Lines walked through a blob by `trace`, against all roots that the reference proves: sorted, none missing and none
// twice, save pairs between which the line stays nearer to the surface than the least distance of docs/language.md
// ("trace"); those are counted.
#pragma once

#include "renderer/queries/object_queries.h"
#include "renderer/reference/reference_tracer.h"
#include "tests/reference/random_scenes.h"

#include <cstdint>
#include <string>
#include <vector>

namespace isl::reference {

struct WalkCounts {
  std::uint64_t lines = 0, crossings = 0;
  std::uint64_t missing = 0, extra = 0, unsorted = 0;  ///< single crossings
  std::uint64_t misplaced = 0;  ///< off by more than a quarter of the least distance, but not by more than all of it
  std::uint64_t dropped_pairs = 0, kept_pairs = 0;  ///< pairs too close to be told apart that only one side has
  std::uint64_t undecided = 0;                      ///< lines that the reference cannot decide

  WalkCounts& operator+=(const WalkCounts& other);
  [[nodiscard]] std::uint64_t wrong() const { return missing + extra + unsorted + misplaced; }
  [[nodiscard]] std::string text() const;
};

/// Walks lines through the one blob of a database, which is not transformed and must outlive this.
class BlobWalk {
 public:
  explicit BlobWalk(const scene::Database& database);

  /// Walks one line and adds its crossings to `counts`. False if one is wrong.
  bool walk(const LineOfSight& line, WalkCounts& counts);

 private:
  /// True if the line stays within this many least distances of the surface between two places.
  [[nodiscard]] bool stays_near(const FieldOnRay& field, const LineOfSight& line, long double t0, long double t1,
                                long double share) const;
  [[nodiscard]] std::vector<double> found_on(const LineOfSight& line, WalkCounts& counts);

  const scene::Database& database_;
  ReferenceField field_;
  render::ObjectQueries queries_;
  double size_ = 0;  ///< the largest number of the blob
};

}  // namespace isl::reference
