// The effects of light from around share these: statements in global_settings that have a distance and a number of
// samples, and rays that start at a block's points.
#pragma once

#include "renderer/effects/effect.h"

#include <limits>

namespace isl::render {

/// The settings of such an effect.
struct SoftRays {
  double distance = 0;  ///< up to which surfaces count; 0: whatever their distance
  int samples = 16;     ///< directions a pixel, if its samples are a fixed number

  [[nodiscard]] double reach() const { return distance > 0 ? distance : std::numeric_limits<double>::infinity(); }
};

inline constexpr scene::StatementField kSoftRaysFields[] = {
    scene::field<&SoftRays::distance>("distance"),
    scene::field<&SoftRays::samples>("samples").within(1, 4096),
};

/// The scene's statement of a kind; null if it has none.
[[nodiscard]] const scene::Statement* find_statement(const scene::Database& database, const scene::StatementKind& kind);

/// For Effect::find: the statement calls for the effect.
[[nodiscard]] std::function<void(const SceneUse&, Requests&, std::string_view&)> find_soft_rays(
    const scene::StatementKind& kind);

/// The ray from a point of the block towards a direction, up to a distance. Surfaces that the point's own hides are not
/// reached: the caller chooses directions above it.
[[nodiscard]] Ray ray_from(const PathBatch& batch, std::uint32_t path, const ShadingPoint& point, const Vec3& direction,
                           double reach);

/// The light that the point's textures throw back of light of radiance 1 from this direction, per steradian.
[[nodiscard]] Rgb thrown_back(const SurfaceBlock& block, const ShadingPoint& point, const Vec3& direction);

}  // namespace isl::render
