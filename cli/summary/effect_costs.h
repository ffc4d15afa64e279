// Measures the price of each effect: a small picture is rendered with everything and without the effect, in turn.
#pragma once

#include "cli/session/session.h"
#include "renderer/effects/plan.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace isl::cli {

struct EffectCost {
  std::string_view name;
  double seconds = 0;     ///< that the picture takes longer than without the effect; noise may make it negative
  std::int64_t rays = 0;  ///< that it traces more
};

/// The price of a noise: what a picture takes that has it, and one that has half of it.
struct NoiseCost {
  struct Picture {
    double noise;
    double samples;  ///< a pixel
    double seconds;
  };
  Picture whole, half;
};

struct EffectCosts {
  PictureSize size;
  double seconds = 0;      ///< of the picture with everything, on one thread
  std::uint64_t rays = 0;  ///< of all kinds
  std::vector<EffectCost> effects;
  std::optional<NoiseCost> noise;  ///< if an effect has any
  bool complete = true;            ///< false if the run was stopped
  std::optional<scene::Refusal> refusal;
};

/// Times are medians of pairs that follow each other, so that a busy machine slows both sides alike. `database`: the
/// drawable scene; its picture is rendered with one ray a pixel.
[[nodiscard]] EffectCosts measure_effects(const Session& session, const scene::Database& database, int quality);

}  // namespace isl::cli
