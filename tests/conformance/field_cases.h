// The one list of fields that the conformance suite runs: skeleton × kernel, meaning and mode × strength × transform. A new
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
  scene::Transform transform;   ///< blob_from_component
  scene::Vec3 third_corner{0};  ///< of a triangle
  double reach = 0;             ///< a ball of this radius about the origin of the blob's space holds the support, if it ends
};

[[nodiscard]] const std::vector<FieldCase>& field_cases();

/// Whether its level sets are at one distance from the skeleton: not if it is integrated along a curve.
[[nodiscard]] bool is_function_of_distance(const FieldCase& field);

/// A blob of that component alone.
[[nodiscard]] scene::Database blob_of(const FieldCase& field, double threshold);

}  // namespace isl::conformance
