#include "renderer/patterns/kinds/pattern_kind.h"

#include <cmath>

namespace isl::render {
namespace {

constexpr PatternInfo kPlain;

/// The descriptors in the order of PatternKind.
constexpr const PatternInfo* kInfos[] = {
    &kPlain,
#define ISL_PATTERN(name, frequency) &pattern_kinds::name,
#include "renderer/scene/patterns.def"
#undef ISL_PATTERN
};

}  // namespace

const PatternInfo& info_of(scene::PatternKind kind) noexcept { return *kInfos[static_cast<std::size_t>(kind)]; }

double below_1(double value) noexcept { return value > 1 ? std::fmod(value, 1.0) : value; }

}  // namespace isl::render
