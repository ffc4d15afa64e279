#include "cli/summary/effect_costs.h"

#include "cli/options/render_settings.h"
#include "renderer/render.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <string>
#include <utility>

namespace isl::cli {
namespace {

/// The first picture is this wide at most; it is doubled until it takes long enough to be timed, up to the size that
/// was asked for.
constexpr int kFirstWidth = 160;
constexpr double kLongEnough = 0.1;  ///< seconds
constexpr int kPairs = 5;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::uint64_t all_rays(const render::PathCounts& paths) {
  return std::accumulate(paths.spawned.begin(), paths.spawned.end(), paths.camera + paths.shadow + paths.around);
}

/// The scene with some effects left out, ready to be rendered as often as needed.
class Rendering {
 public:
  Rendering(const Session& session, const scene::Database& whole, int quality, std::vector<std::string> without)
      : limits_(session.limits()), copied_(limits_.budget), database_(&whole) {
    const render::Plan plan = render::plan_of(whole, {.quality = quality, .without = without});
    if (render::must_leave_out(plan)) {
      if (!copied_.grow(session.scene().charge.bytes())) {
        refusal_ = scene::Refusal{
            .message = "a copy of the scene without one of its effects takes more memory than the limit leaves",
            .hint = "`--max-memory` raises the limit"};
        return;
      }
      reduced_ = whole;
      render::leave_out(plan, *reduced_);
      database_ = &*reduced_;
    }
    RenderCommand command{session.options(), {}};
    command.scene.without = std::move(without);
    command.picture.quality = quality;
    command.picture.samples = 1;
    command.picture.threads = 1;
    settings_ = render_settings(command, *database_);
    settings_.tracer.run = settings_.render.run = limits_;
    tracer_ = std::make_unique<render::Tracer>(*database_, settings_.tracer);
    refusal_ = tracer_->refusal();
  }

  [[nodiscard]] const std::optional<scene::Refusal>& refusal() const { return refusal_; }
  [[nodiscard]] render::RenderResult render(const PictureSize& size) {
    settings_.render.width = size.width;
    settings_.render.height = size.height;
    return render::render(*database_, *tracer_, settings_.render);
  }
  /// From now on, pixels get samples until they have no more noise than this.
  void stop_by_noise(double noise) {
    settings_.render.samples.reset();
    settings_.render.max_noise = noise;
  }

 private:
  RunLimits limits_;
  Charge copied_;
  std::optional<scene::Database> reduced_;
  const scene::Database* database_;
  RenderSettings settings_;
  std::unique_ptr<render::Tracer> tracer_;
  std::optional<scene::Refusal> refusal_;
};

PictureSize scaled(const PictureSize& size, double factor) {
  const auto side = [&](int pixels) { return std::clamp(static_cast<int>(std::lround(pixels * factor)), 1, pixels); };
  return {side(size.width), side(size.height)};
}

}  // namespace

EffectCosts measure_effects(const Session& session, const scene::Database& database, int quality) {
  EffectCosts costs;
  const std::vector<std::string>& without = session.options().without;
  const auto is_over = [&](const render::RenderResult& result) {
    costs.refusal = result.refusal;
    costs.complete = result.complete;
    return result.refusal || !result.complete;
  };
  Rendering whole(session, database, quality, without);
  if ((costs.refusal = whole.refusal())) return costs;

  const PictureSize& asked = session.options().size;
  double factor = std::min(1.0, static_cast<double>(kFirstWidth) / asked.width);
  render::RenderResult result;
  while (true) {
    costs.size = scaled(asked, factor);
    result = whole.render(costs.size);
    if (is_over(result)) return costs;
    if (factor >= 1 || result.statistics.seconds > kLongEnough) break;
    factor = std::min(1.0, 2 * factor);
  }
  costs.rays = all_rays(result.statistics.paths);

  std::vector<double> whole_seconds;
  for (const render::PlannedEffect& planned : result.statistics.plan.called_for) {
    std::vector<std::string> others = without;
    others.emplace_back(planned.effect->name);
    Rendering rest(session, database, quality, std::move(others));
    if ((costs.refusal = rest.refusal())) return costs;
    EffectCost cost{.name = planned.effect->name};
    std::vector<double> differences;
    for (int pair = 0; pair < kPairs; ++pair) {
      const render::RenderResult with = whole.render(costs.size), bare = rest.render(costs.size);
      if (is_over(with) || is_over(bare)) return costs;
      whole_seconds.push_back(with.statistics.seconds);
      differences.push_back(with.statistics.seconds - bare.statistics.seconds);
      cost.rays = static_cast<std::int64_t>(costs.rays - all_rays(bare.statistics.paths));
    }
    cost.seconds = median(std::move(differences));
    costs.effects.push_back(cost);
  }
  if (result.statistics.plan.is_soft()) {
    const auto priced = [&](double noise) {
      whole.stop_by_noise(noise);
      const render::RenderResult picture = whole.render(costs.size);
      is_over(picture);
      return NoiseCost::Picture{noise, picture.statistics.samples_per_pixel, picture.statistics.seconds};
    };
    costs.noise = NoiseCost{priced(kSoftNoise), priced(kSoftNoise / 2)};
    if (costs.refusal || !costs.complete) return costs;
  }
  costs.seconds = whole_seconds.empty() ? result.statistics.seconds : median(std::move(whole_seconds));
  return costs;
}

}  // namespace isl::cli
