// The part of a database that one object needs, so that a shape can be made ready for rays without the rest of the
// scene.
#pragma once

#include "base/budget.h"
#include "renderer/scene/database.h"

#include <optional>

namespace isl::render {

/// A database that holds only `object`, in the object's own space, for rays alone: without textures, and without the
/// flags that hide it from some rays. `charge` counts its memory; nullopt if that is refused.
[[nodiscard]] std::optional<scene::Database> subset(const scene::Database& database, const scene::Object& object,
                                                    Charge& charge);

}  // namespace isl::render
