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

/// The colour that replaces a pigment whose pattern is left out: its preview colour, else the mean of the plain colours
/// that it chooses from, else grey.
[[nodiscard]] scene::Colour stand_in(const scene::Database& database, const scene::PatternedPigment& pigment);

}  // namespace isl::render
