#include "demos/render/image.h"

#include <png.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace demos::render {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const std::string& why) {
  throw OutputError("cannot write '" + path + "': " + why);
}

png_image describe(const Image& image) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.format = PNG_FORMAT_RGB;
  png.width = png_uint_32(image.size.width);
  png.height = png_uint_32(image.size.height);
  return png;
}

/// The bytes of `image` as a PNG file.
std::vector<png_byte> encode(const Image& image) {
  png_image png = describe(image);
  png_alloc_size_t count = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::vector<png_byte> bytes(count);
  if (png_image_write_to_memory(&png, bytes.data(), &count, 0, image.rgb.data(), 0, nullptr) == 0)
    throw std::runtime_error(std::string("libpng cannot encode a picture: ") + png.message);
  bytes.resize(count);
  return bytes;
}

/// Luma, 0 to 255 (Rec. 709 weights).
double brightness(const Image& image, int x, int y) {
  const std::uint8_t* p = image.pixel(x, y);
  return 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
}

/// SSIM of the window of `side` pixels at (x0, y0).
double windowSimilarity(const Image& a, const Image& b, int x0, int y0, int side) {
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
  // (0.01 L)² and (0.03 L)² with L = 255: the paper's constants, which keep flat windows from dividing by nothing.
  constexpr double c1 = 6.5025, c2 = 58.5225;
  return (2 * meanA * meanB + c1) * (2 * covariance + c2) /
         ((meanA * meanA + meanB * meanB + c1) * (varianceA + varianceB + c2));
}

}  // namespace

Image::Image(Size size, Colour fill)
    : size(size), rgb(3 * std::size_t(size.width) * size.height, 0) {
  for (std::size_t i = 0; i < rgb.size(); i += 3) {
    rgb[i] = fill.r;
    rgb[i + 1] = fill.g;
    rgb[i + 2] = fill.b;
  }
}

void Image::paste(const Image& source, int x, int y) {
  const int left = std::max(0, x), right = std::min(size.width, x + source.size.width);
  if (left >= right) return;
  for (int row = std::max(0, y); row < std::min(size.height, y + source.size.height); ++row)
    std::copy_n(source.pixel(left - x, row - y), 3 * (right - left), pixel(left, row));
}

void prepareFolder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) fail(folder, error.message());
  const std::string probe = (fs::path(folder) / ".delassus-probe").string();
  std::FILE* file = std::fopen(probe.c_str(), "wb");
  if (file == nullptr) fail(folder, std::strerror(errno));
  std::fclose(file);
  fs::remove(probe, error);
}

std::string partOf(const std::string& file) {
  const fs::path path(file);
  const std::string name = "." + path.stem().string() + ".part" + path.extension().string();
  return (path.parent_path() / name).string();
}

void finishPart(const std::string& file) {
  std::error_code error;
  fs::rename(partOf(file), file, error);
  if (error) {
    std::error_code ignored;
    fs::remove(partOf(file), ignored);
    fail(file, error.message());
  }
}

void savePng(const std::string& file, const Image& image) {
  const std::vector<png_byte> bytes = encode(image);
  std::FILE* out = std::fopen(partOf(file).c_str(), "wb");
  if (out == nullptr) fail(file, std::strerror(errno));
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), out) == bytes.size();
  if (std::fclose(out) != 0 || !written) {
    const std::string why = std::strerror(errno);
    std::remove(partOf(file).c_str());
    fail(file, why);
  }
  finishPart(file);
}

Image loadPng(const std::string& file) {
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

double structuralSimilarity(const Image& a, const Image& b) {
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
