// The one list of fields that the conformance suite runs: skeleton × kernel and meaning × strength × transform. A new
// skeleton or kernel is one row of the tables in field_cases.cpp.
#pragma once

#include "renderer/scene/database.h"

#include <string>
#include <vector>

namespace isl::conformance {

struct FieldCase {
  std::string name;  ///< letters, digits and underscores, unique
  scene::Component component;
  scene::Kernel kernel;
  scene::Transform transform;  ///< blob_from_component
  double reach = 0;            ///< a ball of this radius about the origin of the blob's space holds the support
};

[[nodiscard]] const std::vector<FieldCase>& field_cases();

/// A point of a level set of q, as seen from the skeleton: centre + level·radius·direction, where direction is the
/// outward normal of the level set. All in the component's space.
struct SurfaceWitness {
  scene::Vec3 centre;     ///< on the skeleton
  scene::Vec3 direction;  ///< unit length
  double radius;          ///< of the skeleton at `centre`
};

/// Points all around the level set q = level² (1: the surface that the component has alone), ends included.
[[nodiscard]] std::vector<SurfaceWitness> surface_witnesses(const scene::Component& component, int count,
                                                            double level = 1);

/// Points of q = 1 where its flank and an end sphere meet. Any points of the surface where there is no flank.
[[nodiscard]] std::vector<SurfaceWitness> end_witnesses(const scene::Component& component, int count);

}  // namespace isl::conformance
