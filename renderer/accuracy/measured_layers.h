// The layers that tell what a picture's rays cost and how far off they are. They cost nothing while rendering, because
// the pixels' centre rays are traced again for them, one by one.
#pragma once

#include "renderer/accuracy/ray_measures.h"
#include "renderer/image/image.h"

#include <optional>

namespace isl::render {

/// True if any of the layers is measured (accuracy/measured_aovs.h).
[[nodiscard]] bool any_measured(const Aovs& aovs);

/// Bytes that measuring takes, beside the picture.
[[nodiscard]] std::size_t measuring_bytes(std::size_t pixels, const Aovs& aovs);

/// Adds those layers of `image` that `aovs` asks for and that are measured, over its window.
/// `tracer` was made from `database` and `options`; errors are relative to the truth (accuracy/reference_hits.h). If
/// the run is stopped meanwhile, the layers exist, but are meaningless. Returns the reason if the truth takes more
/// memory than the run allows.
[[nodiscard]] std::optional<scene::Refusal> measure_layers(const scene::Database& database,
                                                           const TracerOptions& options, const Tracer& tracer,
                                                           const Aovs& aovs, int threads, const TellProgress& tell,
                                                           Image& image);

}  // namespace isl::render
