// The only list of fields that the conformance suite runs: skeleton × kernel, meaning and mode × strength × transform.
// To add a skeleton or kernel, add one row to the tables in field_cases.cpp.
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
  scene::Vec3 third_corner{0};  ///< for a triangle
  double reach = 0;             ///< a ball of this radius about the origin of the blob's space holds the support, if
                                ///< the support is bounded
};

[[nodiscard]] const std::vector<FieldCase>& field_cases();

/// True if the field's level sets have one distance from the skeleton; false for fields that are integrated along a
/// curve.
[[nodiscard]] bool is_function_of_distance(const FieldCase& field);

/// A blob of this component alone.
[[nodiscard]] scene::Database blob_of(const FieldCase& field, double threshold);

}  // namespace isl::conformance
