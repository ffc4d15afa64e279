// `isl plan`: the effects that a scene calls for, the statements that call for each, and the effects that are left out,
// with the reason; with --measure also what each costs. Otherwise it reads and evaluates the scene and traces nothing.
#include "renderer/effects/plan.h"
#include "cli/commands/commands.h"
#include "cli/output/console.h"
#include "cli/output/run_end.h"
#include "cli/session/drawable.h"
#include "cli/session/report.h"
#include "cli/session/session.h"
#include "cli/summary/effect_costs.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace isl::cli {
namespace {

using render::Plan;
using render::PlannedEffect;
using render::Request;

/// "scene.isl:12:3, in macro `Tree` at scene.isl:40:1"; empty if there is no statement to name.
std::string statement_place(const Session& session, OriginId id) {
  const interpreter::Origin origin = session.scene().origins.resolve(id);
  const auto text = [&](SourceSpan span) {
    const grammar::SourcePosition at = session.sources().position(span.begin);
    return fmt::format("{}:{}:{}", visible_name(at.file), at.line, at.column);
  };
  if (origin.span.begin == 0) return {};
  std::string place = text(origin.span);
  if (!origin.chain.empty()) {
    const ExpansionFrame& outermost = origin.chain.back();
    const char* const kind = outermost.kind == ExpansionFrame::Kind::macro ? "macro" : "file";
    place += fmt::format(", in {} `{}` at {}", kind, visible_name(outermost.name), text(outermost.call));
  }
  return place;
}

std::string statement(const Session& session, const Request& request) {
  std::string text = request.what;
  if (const std::string place = statement_place(session, request.origin); !place.empty()) text += " at " + place;
  if (const std::string user = statement_place(session, request.used_by); !user.empty()) text += ", used at " + user;
  if (request.count > 1) text += fmt::format(", and {} more", request.count - 1);
  return text;
}

struct Row {
  std::string name;
  std::vector<std::string> lines;
};

void print_rows(std::string_view title, const std::vector<Row>& rows) {
  if (rows.empty()) return;
  std::size_t width = 0;
  for (const Row& row : rows) width = std::max(width, row.name.size());
  print(Stream::output, fmt::format("{}\n", title));
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.lines.size(); ++i)
      print(Stream::output, fmt::format("  {:<{}}  {}\n", i == 0 ? row.name : "", width, row.lines[i]));
  }
}

void print_text(const Session& session, const Plan& plan) {
  const auto rows = [&](const std::vector<PlannedEffect>& effects) {
    std::vector<Row> result;
    for (const PlannedEffect& planned : effects) {
      Row& row = result.emplace_back(Row{std::string(planned.effect->name), {}});
      if (!planned.reason.empty()) row.lines.push_back(planned.reason);
      if (!planned.effect->is_rendered || planned.reason.empty()) {
        for (const Request& request : planned.requests) row.lines.push_back(statement(session, request));
      }
    }
    return result;
  };
  print_rows("called for", rows(plan.called_for));
  print_rows("called for, and not rendered yet", rows(plan.refused));
  // Effects that are neither called for nor available are not listed.
  std::vector<PlannedEffect> left_out = plan.left_out;
  std::erase_if(left_out,
                [](const PlannedEffect& planned) { return !planned.effect->is_rendered && planned.requests.empty(); });
  print_rows("left out", rows(left_out));
}

nlohmann::ordered_json as_json(const Session& session, const std::vector<PlannedEffect>& effects) {
  auto list = nlohmann::ordered_json::array();
  for (const PlannedEffect& planned : effects) {
    nlohmann::ordered_json effect = {{"name", planned.effect->name}, {"summary", planned.effect->summary}};
    if (!planned.reason.empty()) effect["reason"] = planned.reason;
    auto requests = nlohmann::ordered_json::array();
    for (const Request& request : planned.requests) {
      nlohmann::ordered_json entry = {{"what", request.what}, {"count", request.count}};
      const std::pair<const char*, OriginId> places[] = {{"place", request.origin}, {"used_at", request.used_by}};
      for (const auto& [key, id] : places) {
        const grammar::SourcePosition at = session.sources().position(session.scene().origins.resolve(id).span.begin);
        if (at.line != 0) entry[key] = {{"file", at.file}, {"line", at.line}, {"column", at.column}};
      }
      requests.push_back(std::move(entry));
    }
    effect["requests"] = std::move(requests);
    list.push_back(std::move(effect));
  }
  return list;
}

void print_costs(const EffectCosts& costs) {
  print(Stream::output, fmt::format("\n{}x{}, one ray a pixel, one thread: {:.3f} s, {} rays; each effect adds\n",
                                    costs.size.width, costs.size.height, costs.seconds, costs.rays));
  std::size_t width = 0;
  for (const EffectCost& cost : costs.effects) width = std::max(width, cost.name.size());
  for (const EffectCost& cost : costs.effects)
    print(Stream::output, fmt::format("  {:<{}}  {:7.3f} s  {:4.0f} %  {:9} rays\n", cost.name, width, cost.seconds,
                                      100 * cost.seconds / costs.seconds, cost.rays));
  if (!costs.noise) return;
  const auto picture = [](const NoiseCost::Picture& of) {
    return fmt::format("{:.3g} of noise takes {:.1f} samples a pixel and {:.3f} s", of.noise, of.samples, of.seconds);
  };
  print(Stream::output, fmt::format("\n{}; {}\n", picture(costs.noise->whole), picture(costs.noise->half)));
}

nlohmann::ordered_json as_json(const NoiseCost::Picture& picture) {
  return {{"noise", picture.noise}, {"samples_per_pixel", picture.samples}, {"seconds", picture.seconds}};
}

nlohmann::ordered_json as_json(const EffectCosts& costs) {
  auto effects = nlohmann::ordered_json::array();
  for (const EffectCost& cost : costs.effects)
    effects.push_back({{"name", cost.name}, {"seconds", cost.seconds}, {"rays", cost.rays}});
  nlohmann::ordered_json document = {{"width", costs.size.width},
                                     {"height", costs.size.height},
                                     {"seconds", costs.seconds},
                                     {"rays", costs.rays},
                                     {"effects", std::move(effects)}};
  if (costs.noise) document["noise"] = {as_json(costs.noise->whole), as_json(costs.noise->half)};
  return document;
}

}  // namespace

ExitCode run(const PlanCommand& command) {
  Session session(command.scene);
  if (const ExitCode code = session.evaluate(); code != ExitCode::done) return report_failure(session, code);
  const Plan plan =
      render::plan_of(session.scene().database, {.quality = command.quality, .without = command.scene.without});
  std::optional<EffectCosts> costs;
  if (command.measure) {
    const DrawableScene drawable(session, command.quality);
    if (drawable.is_refused()) return report_failure(session, ExitCode::scene_error);
    costs = measure_effects(session, drawable.database(), command.quality);
    if (costs->refusal) return refuse(session, *costs->refusal);
    if (!costs->complete) return report_failure(session, exit_code_of(stop_flag().reason()));
  }
  if (const ExitCode code = finish(OutputWriter(session.outputs())); code != ExitCode::done) return code;
  if (command.scene.format == OutputFormat::json) {
    nlohmann::ordered_json document = {{"diagnostics", problems_as_json(session)},
                                       {"called_for", as_json(session, plan.called_for)},
                                       {"not_rendered", as_json(session, plan.refused)},
                                       {"left_out", as_json(session, plan.left_out)}};
    if (costs) document["measured"] = as_json(*costs);
    print_document(document);
  } else {
    print_problems(session);
    print_text(session, plan);
    if (costs) print_costs(*costs);
  }
  return ExitCode::done;
}

}  // namespace isl::cli
