// Letters as outlines: a font's glyphs, and where they stand in a line of text.
#pragma once

#include "renderer/scene/solids.h"

#include <memory>
#include <string>
#include <string_view>

namespace isl::interpreter {

/// A font that can be scaled, opened from the bytes of its file (TrueType, OpenType or Type 1). Lengths are in units of
/// the em; the base line is v = 0.
class Font {
 public:
  /// `problem` says why there is no font if the result is null.
  [[nodiscard]] static std::unique_ptr<Font> open(std::string bytes, std::string& problem);
  ~Font();
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  /// Lays out a line of text: letters stand side by side by their advance widths and the font's kerning, and the first
  /// letter's outline begins at u = 0 but for its own bearing, as in POV-Ray. There is no shaping.
  class Line {
   public:
    explicit Line(const Font& font) : font_(font) {}
    /// Draws the next letter into an outline, moved by `offset`. Returns false if the font's data are broken. A letter
    /// that the font lacks is drawn as the font's sign for that.
    [[nodiscard]] bool draw(char32_t letter, const scene::PlanePoint& offset, scene::Outline& outline);

   private:
    const Font& font_;
    unsigned previous_ = 0;  ///< the glyph before, for kerning
    bool is_first_ = true;
    double pen_ = 0;
  };

 private:
  struct Face;
  explicit Font(std::unique_ptr<Face> face);
  std::unique_ptr<Face> face_;
};

}  // namespace isl::interpreter
