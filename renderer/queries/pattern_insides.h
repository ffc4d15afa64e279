// Tells `object` patterns of pictures whether a point is inside an object of the database.
#pragma once

#include "renderer/patterns/patterns.h"
#include "renderer/queries/inside.h"

namespace isl::render {

/// Serves a database that no longer grows; immutable.
class PatternInsides final : public PatternSurroundings {
 public:
  explicit PatternInsides(const scene::Database& database) : database_(database) {
    kernels_.reserve(database.kernels.size());
    for (const scene::Kernel& kernel : database.kernels) kernels_.push_back(kernel_constants(kernel));
  }
  [[nodiscard]] bool is_inside(const scene::Object& object, const scene::Vec3& point,
                               StepCounter& steps) const override {
    return render::is_inside(database_, kernels_, object, point, steps);
  }

 private:
  const scene::Database& database_;
  std::vector<KernelConstants> kernels_;
};

}  // namespace isl::render
