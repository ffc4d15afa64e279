#include "interpreter/fonts/font.h"

#include "interpreter/readers/objects/outline_pen.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

namespace isl::interpreter {
namespace {

using scene::PlanePoint;

/// FreeType calls one function for each piece of an outline; all coordinates are in the font's own units.
struct GlyphPen {
  OutlinePen pen;
  PlanePoint offset;  ///< in units of the font
  double unit;        ///< ems in a unit of the font

  [[nodiscard]] PlanePoint place(const FT_Vector& p) const {
    return {(static_cast<double>(p.x) + offset.u) * unit, (static_cast<double>(p.y) + offset.v) * unit};
  }

  static int move_to(const FT_Vector* to, void* user) {
    auto& self = *static_cast<GlyphPen*>(user);
    self.pen.move_to(self.place(*to));
    return 0;
  }
  static int line_to(const FT_Vector* to, void* user) {
    auto& self = *static_cast<GlyphPen*>(user);
    self.pen.curve_to({self.place(*to)});
    return 0;
  }
  static int conic_to(const FT_Vector* control, const FT_Vector* to, void* user) {
    auto& self = *static_cast<GlyphPen*>(user);
    self.pen.curve_to({self.place(*control), self.place(*to)});
    return 0;
  }
  static int cubic_to(const FT_Vector* first, const FT_Vector* second, const FT_Vector* to, void* user) {
    auto& self = *static_cast<GlyphPen*>(user);
    self.pen.curve_to({self.place(*first), self.place(*second), self.place(*to)});
    return 0;
  }
};

}  // namespace

struct Font::Face {
  std::string bytes;  ///< FreeType reads from here while the face is open
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  Face() = default;
  Face(const Face&) = delete;
  Face& operator=(const Face&) = delete;
  ~Face() {
    if (face) FT_Done_Face(face);
    if (library) FT_Done_FreeType(library);
  }

  /// Symbol fonts have their letters in the private area of Unicode.
  [[nodiscard]] FT_UInt glyph_of(char32_t letter) const {
    constexpr char32_t kSymbols = 0xF000;
    const FT_UInt glyph = FT_Get_Char_Index(face, letter);
    return glyph == 0 && letter < 256 ? FT_Get_Char_Index(face, kSymbols + letter) : glyph;
  }
};

Font::Font(std::unique_ptr<Face> face) : face_(std::move(face)) {}
Font::~Font() = default;

std::unique_ptr<Font> Font::open(std::string bytes, std::string& problem) {
  auto opened = std::make_unique<Face>();
  opened->bytes = std::move(bytes);
  if (FT_Init_FreeType(&opened->library) != 0) {
    problem = "FreeType cannot be used";
    return nullptr;
  }
  const auto* const data = reinterpret_cast<const FT_Byte*>(opened->bytes.data());
  const auto size = static_cast<FT_Long>(opened->bytes.size());
  if (FT_New_Memory_Face(opened->library, data, size, 0, &opened->face) != 0) {
    opened->face = nullptr;
    problem = "it is no font, or a broken one";
    return nullptr;
  }
  const FT_Face face = opened->face;
  if (!FT_IS_SCALABLE(face) || face->units_per_EM == 0) {
    problem = "its letters are pictures of one size, not outlines";
    return nullptr;
  }
  // FreeType has chosen a map of Unicode if the font has one; any other map is better than none.
  if (!face->charmap && face->num_charmaps > 0) FT_Set_Charmap(face, face->charmaps[0]);
  return std::unique_ptr<Font>(new Font(std::move(opened)));
}

bool Font::Line::draw(char32_t letter, const PlanePoint& offset, scene::Outline& outline) {
  const FT_Face face = font_.face_->face;
  const FT_UInt glyph = font_.face_->glyph_of(letter);
  if (FT_Load_Glyph(face, glyph, FT_LOAD_NO_SCALE | FT_LOAD_NO_BITMAP) != 0) return false;
  if (face->glyph->format != FT_GLYPH_FORMAT_OUTLINE) return false;
  if (is_first_) {
    pen_ = -static_cast<double>(face->glyph->metrics.horiBearingX);
  } else if (FT_HAS_KERNING(face)) {
    FT_Vector kerning{};
    if (FT_Get_Kerning(face, previous_, glyph, FT_KERNING_UNSCALED, &kerning) == 0)
      pen_ += static_cast<double>(kerning.x);
  }
  const double unit = 1.0 / face->units_per_EM;
  GlyphPen pen{OutlinePen(outline), {pen_ + offset.u / unit, offset.v / unit}, unit};
  FT_Outline_Funcs functions{};
  functions.move_to = GlyphPen::move_to;
  functions.line_to = GlyphPen::line_to;
  functions.conic_to = GlyphPen::conic_to;
  functions.cubic_to = GlyphPen::cubic_to;
  const bool is_whole = FT_Outline_Decompose(&face->glyph->outline, &functions, &pen) == 0;
  pen.pen.close();
  pen_ += static_cast<double>(face->glyph->metrics.horiAdvance);
  previous_ = glyph;
  is_first_ = false;
  return is_whole;
}

}  // namespace isl::interpreter
