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

}  // namespace demos::render
