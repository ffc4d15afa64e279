// Answers the questions that the language asks about objects. The renderer's own tracer does the work, with each shape
// prepared once and always exactly.
#pragma once

#include "base/run_limits.h"
#include "renderer/extents/extents.h"
#include "renderer/queries/insides.h"
#include "renderer/queries/object_tracer.h"
#include "renderer/scene/queries.h"

#include <map>
#include <memory>
#include <optional>
#include <tuple>

namespace isl::render {

/// Serves one database, which may grow between questions.
class ObjectQueries final : public scene::Queries {
 public:
  /// The shapes that are prepared charge the budget of `run`; a question takes at most its steps at a point.
  explicit ObjectQueries(const RunLimits& run = {});
  ~ObjectQueries() override;

  [[nodiscard]] scene::TraceAnswer trace(const scene::Database& database, const scene::Object& object,
                                         const scene::Vec3& origin, const scene::Vec3& direction) override;
  [[nodiscard]] bool inside(const scene::Database& database, const scene::Object& object,
                            const scene::Vec3& point) override;
  [[nodiscard]] double field(const scene::Database& database, const scene::Object& object,
                             const scene::Vec3& point) override;
  [[nodiscard]] Imath::Box3d extent(const scene::Database& database, const scene::Object& object) override;
  [[nodiscard]] std::optional<scene::Refusal> refusal() const override { return refusal_; }

 private:
  /// The parts of an object that decide its surface in its own space.
  using ShapeKey = std::tuple<scene::Object::Kind, std::uint32_t, scene::GroupId, bool>;
  /// Null if it was refused.
  const Tracer* tracer_of(const scene::Database& database, const scene::Object& object);
  void follow(const scene::Database& database);
  /// `ask(steps)`, which is refused if the steps do not suffice.
  template <class Ask>
  auto ask_insides(const scene::Database& database, const Ask& ask);

  RunLimits run_;
  std::optional<scene::Refusal> refusal_;      ///< of the last question
  const scene::Database* database_ = nullptr;  ///< the database that the rest was made from
  std::optional<Insides> insides_;
  std::optional<Extents> extents_;
  std::map<ShapeKey, std::unique_ptr<const ObjectTracer>> shapes_;
};

}  // namespace isl::render
