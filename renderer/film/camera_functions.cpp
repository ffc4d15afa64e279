#include "renderer/film/camera_functions.h"

#include <algorithm>
#include <cmath>

namespace isl::render {
namespace {

/// POV-Ray's bound on each coordinate of a direction.
constexpr double kNoDirection = 1e-10;

bool is_finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool has_direction(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) >= kNoDirection; }

}  // namespace

std::shared_ptr<const CameraFunctions> CameraFunctions::of(const scene::Database& database, const RunLimits& run,
                                                           const ImageTable* images) {
  if (!database.camera || database.camera->kind != scene::CameraKind::user_defined) return nullptr;
  return std::make_shared<const CameraFunctions>(database, run, images);
}

Vec3 CameraFunctions::value(const scene::VectorFunctions& functions, const Vec3& otherwise, const PicturePoint& at,
                            values::Environment& environment) const {
  if (functions == scene::kNoVectorFunctions) return otherwise;
  const double arguments[] = {at.u, at.v, 0};
  const auto term = [&](std::size_t i) {
    return values::evaluate(*database_.functions[index(functions[i])], arguments, environment)[0];
  };
  return {term(0), term(1), term(2)};
}

ViewRay CameraFunctions::ray(const PicturePoint& at) const {
  const scene::Camera& camera = *database_.camera;
  values::Environment environment(noise_generator_, run_, &patterns_);
  const Vec3 origin = value(camera.location_of, camera.location, at, environment);
  const Vec3 direction = value(camera.direction_of, camera.direction, at, environment);
  if (environment.is_spent()) is_spent_.store(true, std::memory_order_relaxed);
  if (environment.is_spent() || !is_finite(origin) || !is_finite(direction) || !has_direction(direction))
    return {Vec3(0), Vec3(0)};
  return {origin, direction};
}

Vec3 eye_of(const scene::Database& database) {
  if (const auto functions = CameraFunctions::of(database)) return functions->ray({}).origin;
  return database.camera.value_or(scene::Camera{}).location;
}

}  // namespace isl::render
