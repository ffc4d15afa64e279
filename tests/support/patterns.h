// Patterns for tests, with the defaults that the language gives them.
#pragma once

#include "renderer/patterns/kinds/pattern_kind.h"

#include <utility>

namespace isl::render::test {

[[nodiscard]] inline scene::Pattern pattern_of(scene::PatternKind kind) {
  scene::Pattern pattern;
  pattern.kind = kind;
  pattern.frequency = scene::default_frequency(kind);
  if (info_of(kind).operands) pattern.operands = info_of(kind).operands();
  return pattern;
}

[[nodiscard]] inline scene::Pattern pattern_of(scene::PatternKind kind, scene::PatternOperands operands) {
  scene::Pattern pattern = pattern_of(kind);
  pattern.operands = std::move(operands);
  return pattern;
}

/// `direction` of unit length.
[[nodiscard]] inline scene::Pattern gradient_along(const scene::Vec3& direction) {
  scene::Pattern gradient = pattern_of(scene::PatternKind::gradient);
  std::get<scene::Operands>(gradient.operands).set("direction", direction);
  return gradient;
}

}  // namespace isl::render::test
