#include "renderer/accuracy/comparison.h"

#include "base/check.h"
#include "base/parallel.h"
#include "renderer/scene/default_camera.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace isl::render {
namespace {

using Clock = std::chrono::steady_clock;

/// A turn that takes less time is repeated. The value is three orders above the clock's steps and the cost of waking a
/// thread.
constexpr double kShortestTurn = 0.02;

/// The reference's share of the progress, in turns of a setting.
constexpr std::size_t kPartsOfReference = 20;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

class Contest {
 public:
  Contest(const scene::Database& database, const TracerOptions& exact, const std::vector<TracerOptions>& settings,
          std::size_t base, const ComparisonOptions& options)
      : options_(options),
        base_(base),
        pixel_angle_(exact.pixel_angle),
        rays_(centre_rays(database.camera.value_or(scene::default_camera(options.width, options.height)), options.width,
                          options.height, CameraFunctions::of(database))),
        order_(batch_order(options.width, options.height)),
        truth_(rays_.size()),
        parts_(kPartsOfReference + settings.size() * static_cast<std::size_t>(1 + options.rounds)) {
    for (const std::uint32_t ray : order_) batch_rays_.push_back(rays_[ray]);
    for (const TracerOptions& setting : settings) tracers_.emplace_back(database, setting);
    for (const Tracer& tracer : tracers_) {
      if (!result_.refusal) result_.refusal = tracer.refusal();
    }
    times_.resize(settings.size());
    result_.settings.resize(settings.size());
    if (result_.refusal) return;
    const ReferenceHits reference(database, exact);
    result_.refusal = reference.refusal();
    if (result_.refusal) return;
    reference.find(rays_, truth_, options_.run.stop, part(kPartsOfReference));
    if (stopped()) return;
    result_.reference = summarise_reference(rays_, truth_, pixel_angle_);
    if (!options.shadows) return;
    const Tracer tracer(database, exact);
    result_.refusal = tracer.refusal();
    if (result_.refusal) return;
    shadow_rays_ = shadow_rays(database, tracer, rays_, options.run.stop);
    shadow_truth_ = occlusions_of(tracer, shadow_rays_, options.run.stop);
  }

  Comparison run() {
    if (result_.refusal) return std::move(result_);
    for (std::size_t i = 0; i < tracers_.size() && !stopped(); ++i) examine(i);
    const Clock::time_point begin = Clock::now();
    for (int round = 0; round < options_.rounds && !stopped(); ++round) run_round(round, seconds_since(begin));
    for (std::size_t i = 0; i < tracers_.size(); ++i) conclude(i);
    if (options_.progress && !stopped()) options_.progress(1);
    result_.complete = !stopped();
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool stopped() const { return is_set(options_.run.stop); }

  /// The progress function of the next `count` of the parts that the whole consists of.
  [[nodiscard]] TellProgress part(std::size_t count = 1) {
    const double done = static_cast<double>(part_), size = static_cast<double>(count);
    part_ += count;
    if (!options_.progress) return {};
    return [this, done, size](double share) { options_.progress((done + share * size) / static_cast<double>(parts_)); };
  }

  /// Measures the hits of setting i in batches, and the cost of each ray by itself.
  void examine(std::size_t i) {
    Measured& measured = result_.settings[i];
    measured.rays.resize(rays_.size());
    measure_each(tracers_[i], rays_, measured.rays, options_.run.stop, part());
    const std::vector<double> places = hits_of(tracers_[i], batch_rays_, options_.run.stop);
    for (std::size_t k = 0; k < order_.size(); ++k) measured.rays[order_[k]].t = places[k];
    measured.errors.reserve(rays_.size());
    for (std::size_t r = 0; r < rays_.size(); ++r) {
      measured.errors.push_back(error_of(rays_[r], measured.rays[r], truth_[r], pixel_angle_));
    }
    measured.summary = summarise_errors(measured.errors, options_.width);
    if (!options_.shadows) return;
    measured.shadows = summarise_shadows(occlusions_of(tracers_[i], shadow_rays_, options_.run.stop), shadow_truth_);
  }

  /// The cost of the camera rays and, if asked for, of their shadow rays.
  [[nodiscard]] BatchCost cost_of_all(std::size_t i, const TellProgress& tell) const {
    BatchCost cost = cost_of(tracers_[i], batch_rays_, options_.run.stop, tell);
    if (shadow_rays_.empty()) return cost;
    const BatchCost shadows = shadow_cost_of(tracers_[i], shadow_rays_, options_.run.stop);
    cost.processor_seconds += shadows.processor_seconds;
    cost.counters += shadows.counters;
    return cost;
  }

  void run_round(int round, double elapsed) {
    times_of_round_.assign(tracers_.size(), 0);
    for (std::size_t turn = 0; turn < tracers_.size() && !stopped(); ++turn) {
      const std::size_t i = round % 2 == 0 ? turn : tracers_.size() - 1 - turn;
      const TellProgress tell = part();
      if (round > 0 && i != base_ && !has_time(i, elapsed)) continue;
      BatchCost cost = cost_of_all(i, tell);
      double seconds = cost.processor_seconds;
      int passes = 1;
      for (; seconds < kShortestTurn && !stopped(); ++passes) {
        cost = cost_of_all(i, {});
        seconds += cost.processor_seconds;
      }
      times_of_round_[i] = seconds / passes;
      Measured& measured = result_.settings[i];
      const double per_ray = 1 / static_cast<double>(rays_.size() + shadow_rays_.size());
      measured.evaluations_per_ray = static_cast<double>(cost.counters.field_evaluations) * per_ray;
      measured.solver_steps_per_ray = static_cast<double>(cost.counters.cells) * per_ray;
      measured.uncertified_steps = cost.counters.uncertified_steps;
    }
    if (stopped()) return;
    for (std::size_t i = 0; i < tracers_.size(); ++i) {
      if (times_of_round_[i] > 0)
        times_[i].push_back({times_of_round_[i], times_of_round_[i] / times_of_round_[base_]});
    }
  }

  /// True if another turn of setting i fits into its share of the time.
  [[nodiscard]] bool has_time(std::size_t i, double elapsed) const {
    double used = 0;
    for (const Turn& turn : times_[i]) used += turn.seconds;
    const double another = used + used / static_cast<double>(times_[i].size());
    return elapsed < options_.seconds && another < options_.seconds / static_cast<double>(tracers_.size());
  }

  void conclude(std::size_t i) {
    std::vector<double> seconds, ratios;
    for (const Turn& turn : times_[i]) {
      seconds.push_back(turn.seconds);
      ratios.push_back(turn.ratio);
    }
    Measured& measured = result_.settings[i];
    measured.rounds = static_cast<int>(times_[i].size());
    measured.relative_time = median(ratios);
    for (double& ratio : ratios) ratio = std::abs(ratio - measured.relative_time);
    measured.time_spread = median(std::move(ratios));
    measured.processor_seconds = median(std::move(seconds));
  }

  struct Turn {
    double seconds, ratio;
  };

  const ComparisonOptions& options_;
  std::vector<Tracer> tracers_;
  std::size_t base_;
  double pixel_angle_;
  std::vector<Ray> rays_;             ///< row by row
  std::vector<std::uint32_t> order_;  ///< order of the rays in batches
  std::vector<Ray> batch_rays_;       ///< rays_ in that order
  std::vector<ReferenceHit> truth_;
  std::vector<Ray> shadow_rays_;
  std::vector<std::uint8_t> shadow_truth_;
  std::size_t parts_, part_ = 0;
  std::vector<double> times_of_round_;  ///< 0 if the setting had no turn
  std::vector<std::vector<Turn>> times_;
  Comparison result_;
};

}  // namespace

Comparison compare(const scene::Database& database, const TracerOptions& exact,
                   const std::vector<TracerOptions>& settings, std::size_t base, const ComparisonOptions& options) {
  ISL_CHECK(base < settings.size(), "{} of {}", base, settings.size());
  ISL_CHECK(options.rounds >= 1, "{} rounds", options.rounds);
  const Clock::time_point begin = Clock::now();
  Comparison comparison;
  with_threads(options.threads > 0 ? options.threads : default_thread_count(),
               [&] { comparison = Contest(database, exact, settings, base, options).run(); });
  comparison.seconds = seconds_since(begin);
  return comparison;
}

}  // namespace isl::render
