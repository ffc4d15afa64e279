// Where F changes sign along a ray, by proof: a stretch is decided when an enclosure of F excludes zero; where F is
// monotone, Newton's method for intervals confines its zero; anything else is halved. What neither decides is a doubt.
// A crossing is a doubt, however narrow, before and behind which F has different signs.
#pragma once

#include "renderer/reference/reference_ray.h"

#include <optional>
#include <vector>

namespace isl::ISL_REFERENCE {

/// A place where F changes sign.
struct Crossing {
  Real t = 0;
  Real slack = 0;         ///< the root lies within t ± slack
  bool entering = false;  ///< from F < 0 to F > 0
};

/// A stretch on which the sign of F is lost in rounding, or was not found in as many steps as a ray has, with the same
/// sign on both sides (or the ray's start or the end of the search on one).
struct Touch {
  Real begin = 0, end = 0;
};

struct RayRoots {
  bool starts_inside = false;       ///< F > 0 just after t = 0
  std::vector<Crossing> crossings;  ///< ascending, 0 < t < t_max
  std::vector<Touch> touches;
};

class RootSearch {
 public:
  RootSearch(const FieldOnRay& field, bool first_only) : field_(field), first_only_(first_only) {}

  /// Searches [t0, t1], which follows what was searched before.
  void search(Real t0, Real t1);

  /// F keeps this sign on the next stretch.
  void constant(int sign);
  /// The next stretch is undecided.
  void doubt(Real t0, Real t1);

  [[nodiscard]] RayRoots finish();

 private:
  struct Piece {
    Real t0, t1;
    FieldOnRay::Active active;
    bool is_of_lost;  ///< half of a piece at whose middle F was lost in rounding
  };

  void confine(const Piece& piece, const LineStretch& stretch, const JetPair& f);
  [[nodiscard]] bool is_done() const { return first_only_ && !roots_.crossings.empty(); }

  const FieldOnRay& field_;
  bool first_only_;
  int steps_ = 0;
  RayRoots roots_;
  int sign_ = 0;  ///< the sign of F where it was decided last
  std::optional<Touch> doubt_;
};

}  // namespace isl::ISL_REFERENCE
