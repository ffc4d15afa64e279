#include "cli/session/drawable.h"

#include "renderer/effects/plan.h"

#include <fmt/format.h>

namespace isl::cli {
namespace {

/// Adds the place where the scene uses a statement that stands elsewhere.
void add_user(const Session& session, OriginId user, Diagnostic& diagnostic) {
  if (user == OriginId{}) return;
  const SourceSpan span = session.scene().origins.resolve(user).span;
  const bool is_around = span.begin <= diagnostic.span.begin && diagnostic.span.end <= span.end;
  if (span.empty() || is_around) return;
  const std::string_view text = session.sources().text(span);
  const bool is_name = !text.empty() && text.find_first_of(" {(\n\t") == std::string_view::npos;
  diagnostic.notes.push_back({span, is_name ? fmt::format("it belongs to `{}`, which is used here", text)
                                            : std::string("it belongs to this")});
}

Diagnostic complaint(const Session& session, const render::Effect& effect, const render::Request& request,
                     bool lenient) {
  const interpreter::Origin origin = session.scene().origins.resolve(request.origin);
  const std::string times =
      request.count > 1 ? fmt::format("{} times in the scene, this is the first", request.count) : std::string();
  Diagnostic diagnostic{lenient ? Severity::warning : Severity::error,
                        origin.span,
                        fmt::format("{} {}", request.what, effect.lack),
                        {},
                        {},
                        origin.chain};
  if (lenient) {
    diagnostic.message += "; left out";
    diagnostic.hint = times;
  } else {
    diagnostic.hint = fmt::format("{}{}`--lenient` leaves it out", times, times.empty() ? "" : "; ");
  }
  add_user(session, request.used_by, diagnostic);
  return diagnostic;
}

}  // namespace

DrawableScene::DrawableScene(Session& session, int quality)
    : whole_(session.scene().database), copied_(session.limits().budget) {
  const SceneOptions& options = session.options();
  const render::Plan plan = render::plan_of(whole_, {.quality = quality, .without = options.without});
  for (const render::PlannedEffect& refused : plan.refused) {
    for (const render::Request& request : refused.requests) {
      if (session.sink().is_full()) break;
      session.sink().report(complaint(session, *refused.effect, request, options.lenient));
    }
  }
  is_refused_ = !plan.refused.empty() && !options.lenient;
  if (is_refused_ || !render::must_leave_out(plan)) return;
  if (!copied_.grow(session.scene().charge.bytes())) {
    session.sink().error({}, "a copy of the scene without what is not rendered takes more memory than the limit leaves",
                         "`--max-memory` raises the limit");
    is_refused_ = true;
    return;
  }
  reduced_ = whole_;
  render::leave_out(plan, *reduced_);
}

}  // namespace isl::cli
