#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace demos::render {

/// Width and height in pixels.
struct Size {
  int width = 1280, height = 720;
};

/// sRGB with eight bits a channel.
struct Colour {
  std::uint8_t r = 0, g = 0, b = 0;
};

/// Pixels in rows from the top, three bytes each.
struct Image {
  Size size;
  std::vector<std::uint8_t> rgb;

  explicit Image(Size size, Colour fill = {});
  std::uint8_t* pixel(int x, int y) { return &rgb[3 * (std::size_t(y) * size.width + x)]; }
  const std::uint8_t* pixel(int x, int y) const {
    return &rgb[3 * (std::size_t(y) * size.width + x)];
  }
  /// Copies `source` so that its upper left corner is at (x, y); parts that would lie outside are
  /// left out.
  void paste(const Image& source, int x, int y);
};

/// A file or folder that cannot be written; the message names it and says why.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Makes `folder` if it is missing, and checks that files can be written there. Throws OutputError.
void prepareFolder(const std::string& folder);

/// The hidden name, beside `file`, under which the file is written until it is whole.
std::string partOf(const std::string& file);
/// Gives the whole part its final name. Throws OutputError.
void finishPart(const std::string& file);

/// Writes `image` completely or not at all. The same image gives the same bytes. Throws
/// OutputError.
void savePng(const std::string& file, const Image& image);

}  // namespace demos::render
