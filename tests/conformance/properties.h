// The properties that every field must have, as functions that look for a violation. The suite asserts that they find
// none in a correct field and one in a field that was broken on purpose.
#pragma once

#include "tests/conformance/field_cases.h"
#include "tests/conformance/field_under_test.h"

#include <string>
#include <vector>

namespace isl::conformance {

struct Property {
  std::string name;
  /// The first violation in words; empty if there is none.
  std::string (*violation)(const FieldUnderTest&, const FieldCase&);
};

[[nodiscard]] const std::vector<Property>& properties();

}  // namespace isl::conformance
