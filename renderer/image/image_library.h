// The images of a scene, made ready for patterns: each file is decoded once, when the first image that needs it is
// prepared, and each `function` that is an image is sampled.
#pragma once

#include "base/run_limits.h"
#include "renderer/patterns/kinds/sampled_image.h"
#include "renderer/scene/database.h"
#include "renderer/scene/refusal.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace isl::render {

/// Not thread-safe.
class ImageLibrary final : public ImageSource {
 public:
  explicit ImageLibrary(const RunLimits& run) : run_(run) {}

  [[nodiscard]] std::optional<scene::Refusal> prepare(const scene::Database& database,
                                                      const std::vector<bool>& is_needed, ImageTable& table) override;

 private:
  [[nodiscard]] std::optional<scene::Refusal> prepare(const scene::Database& database, const scene::Image& image,
                                                      ImageTable& table, std::size_t number);
  [[nodiscard]] std::shared_ptr<const Texels> sample(const scene::Database& database, const scene::Image& image,
                                                     const ImageTable& table, std::string& problem);

  RunLimits run_;
  /// By the bytes of the file, which stay as long as a scene refers to them.
  std::map<std::pair<std::shared_ptr<const std::string>, scene::ImageType>, std::shared_ptr<const Texels>> decoded_;
};

/// Tells which values the codes of files stand for in a scene with these settings.
[[nodiscard]] WorkingGamma working_gamma(const scene::Settings& settings);

}  // namespace isl::render
