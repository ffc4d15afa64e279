// Finds what effects ask of pigments, in all pigments that one is made of.
#pragma once

#include "renderer/scene/database.h"

#include <optional>

namespace isl::render {

/// `record`: null for a plain pigment.
using IsSuchPigment = bool (*)(const scene::Database& database, const scene::Pigment& pigment,
                               const scene::PatternedPigment* record);

/// The place of the first of the pigments that one is made of, itself included, for which `is_such` holds; nothing if
/// there is none. The place may be unknown.
[[nodiscard]] std::optional<OriginId> find_pigment(const scene::Database& database, const scene::Pigment& pigment,
                                                   IsSuchPigment is_such);

}  // namespace isl::render
