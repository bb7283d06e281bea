#pragma once
/// Pictures that were written, read back and compared.
#include <png.h>

#include <stdexcept>
#include <string>

#include "demos/render/image.h"

namespace demos::render {

/// Reads what `savePng` wrote. Throws std::runtime_error.
inline Image loadPng(const std::string& file) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&png, file.c_str()) == 0)
    throw std::runtime_error("cannot read '" + file + "': " + png.message);
  png.format = PNG_FORMAT_RGB;
  Image image({int(png.width), int(png.height)});
  if (png_image_finish_read(&png, nullptr, image.rgb.data(), 0, nullptr) == 0)
    throw std::runtime_error("cannot read '" + file + "': " + png.message);
  return image;
}

/// Luma, 0 to 255 (Rec. 709 weights).
inline double brightness(const Image& image, int x, int y) {
  const std::uint8_t* p = image.pixel(x, y);
  return 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
}

/// SSIM of the window of `side` pixels at (x0, y0).
inline double windowSimilarity(const Image& a, const Image& b, int x0, int y0, int side) {
  double sumA = 0, sumB = 0, squaresA = 0, squaresB = 0, products = 0;
  for (int y = y0; y < y0 + side; ++y)
    for (int x = x0; x < x0 + side; ++x) {
      const double va = brightness(a, x, y), vb = brightness(b, x, y);
      sumA += va;
      sumB += vb;
      squaresA += va * va;
      squaresB += vb * vb;
      products += va * vb;
    }
  const double n = double(side) * side, meanA = sumA / n, meanB = sumB / n;
  const double varianceA = squaresA / n - meanA * meanA, varianceB = squaresB / n - meanB * meanB;
  const double covariance = products / n - meanA * meanB;
  // (0.01 L)² and (0.03 L)² with L = 255: the paper's constants, which keep flat windows from
  // dividing by nothing.
  constexpr double c1 = 6.5025, c2 = 58.5225;
  return (2 * meanA * meanB + c1) * (2 * covariance + c2) /
         ((meanA * meanA + meanB * meanB + c1) * (varianceA + varianceB + c2));
}

/// Mean structural similarity of the brightness of two images of one size, over windows of 8 x 8
/// pixels (Wang, Bovik, Sheikh, Simoncelli 2004): 1 for equal ones.
inline double structuralSimilarity(const Image& a, const Image& b) {
  if (a.size.width != b.size.width || a.size.height != b.size.height) return 0;
  constexpr int side = 8;
  double sum = 0;
  int windows = 0;
  for (int y = 0; y + side <= a.size.height; y += side / 2)
    for (int x = 0; x + side <= a.size.width; x += side / 2) {
      sum += windowSimilarity(a, b, x, y, side);
      ++windows;
    }
  return windows > 0 ? sum / windows : 0;
}

}  // namespace demos::render
