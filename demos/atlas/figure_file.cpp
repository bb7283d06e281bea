#include "demos/atlas/figure_file.h"

#include <cairo-svg.h>

#include <filesystem>
#include <memory>
#include <stdexcept>

#include "delassus/whole_file.h"

namespace demos::atlas {

namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void drawOn(cairo_surface_t* surface, const Figure& figure) {
  const Context context(cairo_create(surface), &cairo_destroy);
  Canvas canvas(context.get());
  canvas.fill(rectangle({0, 0}, figure.size), white);
  figure.draw(canvas);
  if (cairo_status(context.get()) != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error("figure " + figure.name + ": " +
                             cairo_status_to_string(cairo_status(context.get())));
}

std::string pngOf(const Figure& figure) {
  const Surface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, int(figure.size.x()), int(figure.size.y())),
      &cairo_surface_destroy);
  drawOn(surface.get(), figure);
  std::string bytes;
  cairo_surface_write_to_png_stream(surface.get(), append, &bytes);
  return bytes;
}

std::string svgOf(const Figure& figure) {
  std::string bytes;
  const Surface surface(
      cairo_svg_surface_create_for_stream(append, &bytes, figure.size.x(), figure.size.y()),
      &cairo_surface_destroy);
  cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
  drawOn(surface.get(), figure);
  cairo_surface_finish(surface.get());
  return bytes;
}

}  // namespace

void writeFigure(const std::string& folder, const Figure& figure) {
  const std::string png = pngOf(figure), svg = svgOf(figure);
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed)
    throw std::runtime_error("cannot make the folder '" + folder + "': " + failed.message());
  const std::filesystem::path base = std::filesystem::path(folder) / figure.name;
  delassus::writeFile(base.string() + ".png", png);
  delassus::writeFile(base.string() + ".svg", svg);
}

}  // namespace demos::atlas
