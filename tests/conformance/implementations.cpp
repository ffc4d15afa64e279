#include "tests/conformance/field_under_test.h"

namespace isl::conformance {

const std::vector<Implementation>& implementations() {
  static const std::vector<Implementation> list = {{"reference", reference_field_under_test},
                                                   {"product", product_field_under_test}};
  return list;
}

}  // namespace isl::conformance
