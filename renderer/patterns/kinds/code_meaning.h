// Turns the codes of an image file into values of the scene, by the file's gamma and the space of the scene's colours.
// The rules are those of POV-Ray 3.7, as measured.
#pragma once

#include "renderer/patterns/kinds/texels.h"
#include "renderer/scene/image.h"

#include <cstdint>

namespace isl::render {

/// The space in which the scene's colours are, and which files are converted to it.
struct WorkingGamma {
  enum class Kind : std::uint8_t { linear, srgb, power };
  Kind kind = Kind::linear;
  double gamma = 1;  ///< of Kind::power: working value = light^(1/gamma)
  /// Before version 3.7, files are converted only if they state their gamma themselves, and without assumed_gamma only
  /// if the scene names it.
  enum class Converts : std::uint8_t { all, stating, named };
  Converts converts = Converts::all;
};

/// From a file's code to the scene's working space.
class CodeMeaning {
 public:
  CodeMeaning(const scene::Image& image, const Texels& texels, const WorkingGamma& working);
  [[nodiscard]] double operator()(double code) const noexcept;

 private:
  WorkingGamma working_;
  Transfer transfer_;
  double gamma_;
  bool keeps_codes_;
};

}  // namespace isl::render
