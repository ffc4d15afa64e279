#include "renderer/patterns/kinds/pattern_kind.h"

#include <cmath>

namespace isl::render {
namespace {

constexpr PatternInfo kPlain;

}  // namespace

const PatternInfo* const kPatternInfos[] = {
    &kPlain,
#define ISL_PATTERN(name, frequency) &pattern_kinds::name,
#include "renderer/scene/patterns.def"
#undef ISL_PATTERN
};

double below_1(double value) noexcept { return value > 1 ? value - std::floor(value) : value; }

}  // namespace isl::render
