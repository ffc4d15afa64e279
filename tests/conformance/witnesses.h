// Points of a field's level sets, found from the shape of its skeleton alone: where the properties look.
#pragma once

#include "tests/conformance/field_cases.h"

#include <vector>

namespace isl::conformance {

/// A point of a level set of q, as seen from the skeleton: centre + level·radius·direction, where direction is the
/// outward normal of the level set. All in the component's space.
struct SurfaceWitness {
  scene::Vec3 centre;     ///< on the skeleton
  scene::Vec3 direction;  ///< unit length
  double radius;          ///< of the skeleton at `centre`
};

/// Points all around the level set q = level² (1: the surface that the component has alone), ends and edges included.
[[nodiscard]] std::vector<SurfaceWitness> surface_witnesses(const FieldCase& field, int count, double level = 1);

/// Points of q = 1 on its seams: where a flank and an end sphere meet, or what is round about an edge and the face
/// beside it. Any points of the surface where there is no seam.
[[nodiscard]] std::vector<SurfaceWitness> end_witnesses(const FieldCase& field, int count);

}  // namespace isl::conformance
