// A ray as a blob's solver sees it, and the solver's answer: the one small interface between finding a blob's surface
// and the scene around it. Everything is in the blob's space; t is the same as in the world, and the direction need not
// be normalised.
#pragma once

#include "renderer/rays/ray_steps.h"
#include "renderer/rays/tracer_options.h"
#include "renderer/scene/ids.h"
#include "renderer/scene/transform.h"

#include <cstdint>
#include <limits>

namespace isl::render {

struct BlobRay {
  Vec3 origin, direction;
  double t_max = std::numeric_limits<double>::infinity();
  bool starts_on_surface = false;  ///< the root at t = 0 is known, and not searched for
  bool any = false;                ///< only asks whether there is a crossing
  double path_length = 0;          ///< the length of the path before t = 0, in world units
  bool may_go_in = false;          ///< for a start on the surface: the ray may go inside, which matters in a CSG tree
  /// A dip through the surface and back that only more digits than double precision show is a hit. A ray that goes on
  /// from there may not find the way back, since its start is rounded: walks, which count crossings, take no such dip.
  bool takes_faint_dips = false;
};

struct BlobHit {
  double t = std::numeric_limits<double>::infinity();
  std::uint32_t cell = scene::kNone;
  bool from_inside = false;  ///< for a miss: the ray stays inside, as it can in a half-space
  double undecided_from = std::numeric_limits<double>::infinity();  ///< where the ray is undecided first, if it is

  [[nodiscard]] bool is_miss() const { return cell == scene::kNone; }
};

/// A length along a ray that grows with the distance from the eye.
struct LengthByDistance {
  double at_eye, per_distance;

  [[nodiscard]] double at(double distance) const { return at_eye + per_distance * distance; }
};

/// The settings of every solver, above all how exact it is.
struct SolverSettings {
  SolverName name = SolverName::hermite;
  int interpolants = 2;
  Tolerance tolerance;
  double pixel_angle = 0;
  PaperSwitches paper;
  Tolerance step{1, true};
  double relaxation = 1;
  bool packets = true;                    ///< for the product's solver: traces eight rays at once where it can
  std::uint64_t ray_steps = kStepsOfRay;  ///< the bound of what a ray takes in a blob
  bool digits = false;                    ///< likewise: places every crossing with more digits
  const StopFlag* stop = nullptr;         ///< ends every search; its answer is then open

  /// The tolerance along the ray, in scene units; 0 for `exact`.
  [[nodiscard]] LengthByDistance tolerance_along_ray() const {
    return name == SolverName::exact ? LengthByDistance{0, 0} : along_ray(tolerance);
  }
  /// The same at a distance from the eye.
  [[nodiscard]] double at(double distance) const { return tolerance_along_ray().at(distance); }
  /// The length of a step along the ray, likewise.
  [[nodiscard]] double step_at(double distance) const { return along_ray(step).at(distance); }

 private:
  [[nodiscard]] LengthByDistance along_ray(const Tolerance& length) const {
    return length.in_pixels ? LengthByDistance{0, length.value * pixel_angle} : LengthByDistance{length.value, 0};
  }
};

}  // namespace isl::render
