// One object of a database made ready for rays, apart from the rest of the scene.
#pragma once

#include "base/run_limits.h"
#include "renderer/scene/refusal.h"
#include "renderer/trace/tracer.h"

#include <memory>
#include <optional>

namespace isl::render {

/// Rays are in the object's own space, before its transform. They are traced exactly. The object's flags and textures
/// do not count.
class ObjectTracer {
 public:
  /// Null if there is not enough memory; `refusal` then tells what would have taken it.
  [[nodiscard]] static std::unique_ptr<const ObjectTracer> of(const scene::Database& database,
                                                              const scene::Object& object, const RunLimits& run,
                                                              std::optional<scene::Refusal>& refusal);
  [[nodiscard]] const Tracer& tracer() const { return tracer_; }

 private:
  ObjectTracer(scene::Database alone, Charge bytes, const TracerOptions& options)
      : database_(std::move(alone)), charge_(std::move(bytes)), tracer_(database_, options) {}

  scene::Database database_;  ///< holds the object alone; the tracer refers to it
  Charge charge_;             ///< of the database
  Tracer tracer_;
};

}  // namespace isl::render
