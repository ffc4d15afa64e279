// Points of a field's level sets, found from the shape of its skeleton alone. The properties are tested there.
#pragma once

#include "tests/conformance/field_cases.h"

#include <vector>

namespace isl::conformance {

/// A point of a level set of q, as seen from the skeleton: centre + level·radius·direction, where direction is the
/// outward normal of the level set. All in the component's space.
struct SurfaceWitness {
  scene::Vec3 centre;     ///< on the skeleton
  scene::Vec3 direction;  ///< unit length
  double radius;          ///< radius of the skeleton at `centre`
};

/// Points all around the level set q = level² (1: the surface of the component alone), ends and edges included.
[[nodiscard]] std::vector<SurfaceWitness> surface_witnesses(const FieldCase& field, int count, double level = 1);

/// Points of q = 1 on its seams: where a flank and an end sphere meet, or the round part about an edge and the face
/// beside it. Any points of the surface if there is no seam.
[[nodiscard]] std::vector<SurfaceWitness> end_witnesses(const FieldCase& field, int count);

}  // namespace isl::conformance
