#include <ft2build.h>

#include <freetype/freetype.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "demos/render/canvas.h"

namespace demos::render {

namespace {

/// Code points of a UTF-8 text; broken sequences end it.
std::vector<FT_ULong> codePoints(const std::string& text) {
  std::vector<FT_ULong> points;
  for (std::size_t i = 0; i < text.size();) {
    const auto first = static_cast<unsigned char>(text[i]);
    const int more = first < 0x80 ? 0 : first < 0xe0 ? 1 : first < 0xf0 ? 2 : 3;
    if (i + std::size_t(more) >= text.size()) break;
    FT_ULong point = more == 0 ? first : first & (0x3fu >> more);
    for (int k = 1; k <= more; ++k)
      point = point << 6 | (static_cast<unsigned char>(text[i + std::size_t(k)]) & 0x3fu);
    points.push_back(point);
    i += std::size_t(more) + 1;
  }
  return points;
}

std::string fontFile(bool bold) {
  const std::string name = bold ? "DejaVuSans-Bold.ttf" : "DejaVuSans.ttf";
  for (const char* folder : {"/usr/share/fonts/truetype/dejavu/", "/usr/share/fonts/dejavu/",
                             "/usr/share/fonts/TTF/", "/usr/local/share/fonts/"})
    if (std::filesystem::exists(folder + name)) return folder + name;
  throw std::runtime_error("no font " + name + " (package fonts-dejavu-core)");
}

}  // namespace

struct Font::Face {
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  Face() = default;
  Face(const Face&) = delete;
  Face& operator=(const Face&) = delete;
  ~Face() {
    if (face != nullptr) FT_Done_Face(face);
    if (library != nullptr) FT_Done_FreeType(library);
  }
  /// Loads the glyph of a code point at `height` pixels an em.
  const FT_GlyphSlotRec& glyph(FT_ULong point, double height, bool render) {
    FT_Set_Char_Size(face, 0, FT_F26Dot6(std::lround(64 * height)), 72, 72);
    const FT_Int32 flags = FT_LOAD_NO_HINTING | (render ? FT_LOAD_RENDER : FT_LOAD_DEFAULT);
    if (FT_Load_Char(face, point, flags) != 0)
      throw std::runtime_error("FreeType cannot draw a letter of the font");
    return *face->glyph;
  }
};

Font::Font(bool bold) : face_(std::make_unique<Face>()) {
  const std::string file = fontFile(bold);
  if (FT_Init_FreeType(&face_->library) != 0 ||
      FT_New_Face(face_->library, file.c_str(), 0, &face_->face) != 0)
    throw std::runtime_error("FreeType cannot read the font '" + file + "'");
}

Font::~Font() = default;
Font::Font(Font&&) noexcept = default;

double Font::width(const std::string& text, double height) {
  double width = 0;
  for (const FT_ULong point : codePoints(text))
    width += double(face_->glyph(point, height, false).linearHoriAdvance) / 65536;
  return width;
}

double Font::draw(Image& image, const std::string& text, Point place, double height, Paint paint,
                  Align align) {
  if (align != Align::Left) place.x() -= width(text, height) * (align == Align::Centre ? 0.5 : 1);
  Canvas canvas(image);
  for (const FT_ULong point : codePoints(text)) {
    const FT_GlyphSlotRec& glyph = face_->glyph(point, height, true);
    const int left = int(std::lround(place.x())) + glyph.bitmap_left,
              top = int(std::lround(place.y())) - glyph.bitmap_top;
    for (int y = 0; y < int(glyph.bitmap.rows); ++y)
      for (int x = 0; x < int(glyph.bitmap.width); ++x) {
        const unsigned char covered = glyph.bitmap.buffer[y * glyph.bitmap.pitch + x];
        if (covered > 0)
          canvas.blend(left + x, top + y, {paint.colour, paint.alpha * covered / 255});
      }
    place.x() += double(glyph.linearHoriAdvance) / 65536;
  }
  return place.x();
}

}  // namespace demos::render
