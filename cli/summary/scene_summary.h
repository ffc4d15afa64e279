// Counts of a scene's contents, for `isl check` and --stats.
#pragma once

#include "renderer/scene/database.h"

#include <cstddef>
#include <cstdint>

namespace isl::cli {

/// Objects are counted as placed in the world: one that is placed three times counts three times.
struct SceneSummary {
  std::uint64_t fields = 0;  ///< components of blobs
  std::uint64_t blobs = 0;
  std::uint64_t solids = 0;
  std::uint64_t lights = 0;
  std::uint64_t textures = 0;  ///< records, not their uses

  [[nodiscard]] std::uint64_t primitives() const { return fields + solids; }
};

[[nodiscard]] SceneSummary summarise(const scene::Database& database);

/// Bytes that the database's columns hold.
[[nodiscard]] std::size_t database_bytes(const scene::Database& database);

}  // namespace isl::cli
