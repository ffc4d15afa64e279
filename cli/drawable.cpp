#include "cli/drawable.h"

#include "renderer/scene/unrendered.h"

#include <fmt/format.h>

namespace isl::cli {
namespace {

Diagnostic complaint(const scene::Unrendered& thing, const interpreter::Origin& origin, bool lenient) {
  const std::string times =
      thing.count > 1 ? fmt::format("{} times in the scene, this is the first", thing.count) : std::string();
  Diagnostic diagnostic{lenient ? Severity::warning : Severity::error,
                        origin.span,
                        fmt::format("{} is not rendered yet", thing.what),
                        {},
                        {},
                        origin.chain};
  if (lenient) {
    diagnostic.message += "; left out";
    diagnostic.hint = times;
  } else {
    diagnostic.hint = fmt::format("{}{}`--lenient` leaves it out", times, times.empty() ? "" : "; ");
  }
  return diagnostic;
}

}  // namespace

DrawableScene::DrawableScene(Session& session) : whole_(session.scene().database) {
  const std::vector<scene::Unrendered> things = scene::unrendered(whole_);
  const bool lenient = session.options().lenient;
  for (const scene::Unrendered& thing : things) {
    if (session.sink().is_full()) break;
    session.sink().report(complaint(thing, session.scene().origins.resolve(thing.origin), lenient));
  }
  is_refused_ = !things.empty() && !lenient;
  if (things.empty() || is_refused_) return;
  reduced_ = whole_;
  scene::leave_out_unrendered(*reduced_);
}

}  // namespace isl::cli
