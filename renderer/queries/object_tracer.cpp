#include "renderer/queries/object_tracer.h"

#include "renderer/queries/subset.h"

#include <utility>

namespace isl::render {

std::unique_ptr<const ObjectTracer> ObjectTracer::of(const scene::Database& database, const scene::Object& object,
                                                     const RunLimits& run, std::optional<scene::Refusal>& refusal) {
  TracerOptions options;
  options.solver = SolverName::exact;
  options.run = run;
  Charge copied(run.budget);
  std::optional<scene::Database> alone = subset(database, object, copied);
  if (!alone) {
    refusal = {"a copy of this object would take more memory than the limit leaves", "`--max-memory` raises the limit"};
    return nullptr;
  }
  std::unique_ptr<const ObjectTracer> made(new ObjectTracer(std::move(*alone), std::move(copied), options));
  refusal = made->tracer_.refusal();
  return refusal ? nullptr : std::move(made);
}

}  // namespace isl::render
