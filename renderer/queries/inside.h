// Tests whether a point lies inside an object. The tests use the definition of each shape and trace no rays, so they
// hold for every object of the language. The tests of solids are in solids/solid.h.
#pragma once

#include "base/stop_flag.h"
#include "renderer/fields/kernels/kernel_constants.h"
#include "renderer/scene/database.h"
#include "renderer/solids/solid.h"

#include <vector>

namespace isl::render {

class BoxIndexes;

/// `point` is in the blob's own space; it is inside if the field reaches the threshold. `kernels` are those of the
/// database.
[[nodiscard]] bool is_inside(const scene::Database& database, const std::vector<KernelConstants>& kernels,
                             const scene::Blob& blob, const scene::Vec3& point);

/// `point` is in the space that the object is placed into. A clip also removes the inside that it cuts off. Sheets
/// (solids/solid.h) hold nothing, inverse or not, as in POV-Ray: of a solid minus a triangle nothing is left but the
/// triangle. Every object that is asked takes a step, and every few components of a blob do, because groups that hold a
/// group twice, sixty deep, have more leaves than can be asked. When the steps are spent, the answer is meaningless.
/// `indexes` may be null: they change no answer.
[[nodiscard]] bool is_inside(const scene::Database& database, const std::vector<KernelConstants>& kernels,
                             const scene::Object& object, const scene::Vec3& point, StepCounter& steps,
                             BoxIndexes* indexes = nullptr);

/// The field of a blob, by its number, at a point of its own space. Steps and indexes as above.
[[nodiscard]] double field_of(const scene::Database& database, const std::vector<KernelConstants>& kernels,
                              std::uint32_t blob, const scene::Vec3& point, StepCounter& steps,
                              BoxIndexes* indexes = nullptr);

}  // namespace isl::render
