// Tells whether points are inside objects of one database: for `inside` of the language and for `object` patterns.
#pragma once

#include "base/run_limits.h"
#include "renderer/patterns/patterns.h"
#include "renderer/queries/box_indexes.h"
#include "renderer/queries/inside.h"

#include <vector>

namespace isl::render {

/// Several threads may ask at the same time, but not while it follows the database.
class Insides final : public PatternSurroundings {
 public:
  explicit Insides(const scene::Database& database, const RunLimits& run = {})
      : database_(database), indexes_(database, kernels_, run) {
    follow();
  }

  /// Called when the database may have grown.
  void follow() {
    for (std::size_t i = kernels_.size(); i < database_.kernels.size(); ++i)
      kernels_.push_back(kernel_constants(database_.kernels[i]));
    indexes_.follow();
  }

  /// As in inside.h.
  [[nodiscard]] bool is_inside(const scene::Object& object, const scene::Vec3& point,
                               StepCounter& steps) const override {
    return render::is_inside(database_, kernels_, object, point, steps, &indexes_);
  }

  [[nodiscard]] double field_of(const scene::Object& object, const scene::Vec3& point,
                                StepCounter& steps) const override {
    return render::field_of(database_, kernels_, object.shape, object.parent_from_object.inverse_point(point), steps,
                            &indexes_);
  }

 private:
  const scene::Database& database_;
  std::vector<KernelConstants> kernels_;
  mutable BoxIndexes indexes_;  ///< working memory: it changes no answer
};

}  // namespace isl::render
