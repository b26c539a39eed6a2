#include <librsvg/rsvg.h>

#include <cmath>
#include <new>

#include "prs/components/components.h"

namespace prs {
namespace {

template <class Object>
using Owned = std::unique_ptr<Object, void (*)(Object*)>;

void require(cairo_status_t status) {
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  if (status != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error(std::string("cannot draw a PNG file: ") + cairo_status_to_string(status));
}

[[noreturn]] void fail(GError* error) {
  const std::string reason = error ? error->message : "no reason was given";
  g_clear_error(&error);
  throw std::runtime_error("cannot draw a PNG file: " + reason);
}

cairo_status_t append(void* file, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(file)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

std::string png(const std::string& svg, double scale) {
  GError* error = nullptr;
  const Owned<RsvgHandle> handle(
      rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(svg.data()), svg.size(), &error),
      [](RsvgHandle* h) { g_object_unref(h); });
  if (!handle) fail(error);
  double width = 0.0, height = 0.0;
  if (!rsvg_handle_get_intrinsic_size_in_pixels(handle.get(), &width, &height))
    throw std::runtime_error("cannot draw a PNG file: the SVG file has no size");
  width = std::ceil(scale * width);
  height = std::ceil(scale * height);
  const Owned<cairo_surface_t> surface(
      cairo_image_surface_create(CAIRO_FORMAT_ARGB32, static_cast<int>(width), static_cast<int>(height)),
      cairo_surface_destroy);
  require(cairo_surface_status(surface.get()));
  const Owned<cairo_t> context(cairo_create(surface.get()), cairo_destroy);
  const RsvgRectangle viewport{0.0, 0.0, width, height};
  if (!rsvg_handle_render_document(handle.get(), context.get(), &viewport, &error)) fail(error);
  require(cairo_status(context.get()));
  std::string file;
  require(cairo_surface_write_to_png_stream(surface.get(), append, &file));
  return file;
}

}  // namespace
}  // namespace prs

extern "C" __attribute__((visibility("default"))) const prs::PictureModule prs_module{{}, prs::png};
