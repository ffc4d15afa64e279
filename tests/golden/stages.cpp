#include "tests/golden/stages.h"

#include <array>

namespace isl::test {

std::span<const Stage> stages() {
  static constexpr std::array kStages{Stage{"parse", run_parse}, Stage{"eval", run_eval}};
  return kStages;
}

}  // namespace isl::test
