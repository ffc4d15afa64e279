// An image with what its statement says of it: where it lies (image_placing.h), and what colour or number its texels
// are (palette, transparency, gamma). All formulas are POV-Ray's, as measured.
#pragma once

#include "renderer/patterns/kinds/code_meaning.h"
#include "renderer/patterns/kinds/image_placing.h"
#include "renderer/patterns/kinds/texels.h"
#include "renderer/scene/colour.h"
#include "renderer/scene/database.h"
#include "renderer/scene/image.h"
#include "renderer/scene/refusal.h"
#include "renderer/scene/transform.h"

#include <memory>
#include <optional>
#include <vector>

namespace isl::render {

/// Immutable; lookups allocate nothing.
class SampledImage {
 public:
  SampledImage(const scene::Image& image, std::shared_ptr<const Texels> texels, const WorkingGamma& working);

  [[nodiscard]] const ImagePlacing& placing() const noexcept { return placing_; }
  /// In single precision.
  [[nodiscard]] scene::Colour colour_at(const TexelPlace& place) const noexcept;
  /// The value of an image_pattern, from 0 to 1.
  [[nodiscard]] double value_at(const TexelPlace& place) const noexcept;
  /// The height of bumps: from 0 to 1, or the number of the colour if the index is used.
  [[nodiscard]] double height_at(const TexelPlace& place) const noexcept;
  /// The number of the texture that a material_map chooses.
  [[nodiscard]] int choice_at(const TexelPlace& place) const noexcept;

 private:
  struct Texel {
    float red, green, blue, filter, transmit;
  };

  [[nodiscard]] Texel texel(std::size_t number) const noexcept;
  /// The decoded value of a channel; alpha is not decoded.
  [[nodiscard]] float decoded(std::size_t value) const noexcept;
  [[nodiscard]] float real_at(std::size_t value) const noexcept;
  /// From 0 to 1; that of grey bytes is a whole number of 255ths.
  [[nodiscard]] double brightness(const Texel& texel) const noexcept;
  [[nodiscard]] double red_code(const Texel& texel) const noexcept;
  [[nodiscard]] float alpha(std::size_t number) const noexcept;
  [[nodiscard]] int index(std::size_t number) const noexcept;
  [[nodiscard]] bool uses_index() const noexcept;
  /// The mean of value_of(texel number) over the texels that the interpolation takes.
  template <class ValueOf>
  [[nodiscard]] double mean(const TexelPlace& place, const ValueOf& value_of) const noexcept;

  std::shared_ptr<const Texels> texels_;
  ImagePlacing placing_;
  scene::Image image_;
  CodeMeaning meaning_of_;
  bool is_premultiplied_;
  float added_filter_ = 0, added_transmit_ = 0;  ///< for files without a palette
  std::vector<float> meaning_;                   ///< of each code; empty for real numbers, which are rare
  std::vector<Texel> palette_;
};

/// The images of a database, by their numbers; null for those that no picture needs.
using ImageTable = std::vector<std::unique_ptr<const SampledImage>>;

/// Decodes files and samples functions. cli makes it, since the interpreter does not know files of images, and a scene
/// may call a function of one while it is read.
class ImageSource {
 public:
  virtual ~ImageSource() = default;
  /// Prepares the images of a database for which `is_needed` is true, as long as its column, unless the table has them
  /// already. The refusal tells why one of them cannot be used.
  [[nodiscard]] virtual std::optional<scene::Refusal> prepare(const scene::Database& database,
                                                              const std::vector<bool>& is_needed,
                                                              ImageTable& table) = 0;
};

}  // namespace isl::render
