// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/svg/draw_pdf.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include <cairo-pdf.h>
#include <librsvg/rsvg.h>

namespace detent::importer::svg {
namespace {

constexpr double fallbackSide_px = 1000;  // side of a drawing without a size

struct HandleEnd {
  void operator()(RsvgHandle* handle) const { g_object_unref(handle); }
};
struct ContextEnd {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
struct SurfaceEnd {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};

std::string takeWords(GError* error) {
  std::string words = error != nullptr && error->message != nullptr ? error->message : "no reason given";
  g_clear_error(&error);
  return words;
}

struct PageSize {
  double width_px = 0, height_px = 0;

  bool usable() const {
    return width_px > 0 && height_px > 0 && std::isfinite(width_px) && std::isfinite(height_px);
  }
};

/// The size in the root element, else its view box, else the extent of what is drawn.
PageSize sizeOf(RsvgHandle* handle) {
  PageSize size;
  if (rsvg_handle_get_intrinsic_size_in_pixels(handle, &size.width_px, &size.height_px) && size.usable())
    return size;
  gboolean hasWidth = FALSE, hasHeight = FALSE, hasBox = FALSE;
  RsvgLength width, height;
  RsvgRectangle box;
  rsvg_handle_get_intrinsic_dimensions(handle, &hasWidth, &width, &hasHeight, &height, &hasBox, &box);
  if (hasBox) return {box.width, box.height};
  const RsvgRectangle viewport{0, 0, fallbackSide_px, fallbackSide_px};
  RsvgRectangle drawn{};
  if (rsvg_handle_get_geometry_for_layer(handle, nullptr, &viewport, &drawn, nullptr, nullptr))
    return {drawn.x + drawn.width, drawn.y + drawn.height};
  return size;
}

/// Scale of the drawing. Cairo rounds to 1/256 of a unit, so small drawings are enlarged, by a power of two
/// so that nothing else is rounded.
double scaleFor(const PageSize& size, bool rasters) {
  constexpr double side_units = 8192;  // largest side of the PDF
  const double side_px = std::max(size.width_px, size.height_px);
  const double exponent = std::floor(std::log2(side_units / side_px));
  return rasters && exponent > 0 ? 1 : std::exp2(std::clamp(exponent, -16.0, 16.0));
}

cairo_status_t append(void* to, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

DrawnPdf drawPdf(std::string_view svg, bool rasters) {
  DrawnPdf drawn;
  GError* error = nullptr;
  const std::unique_ptr<RsvgHandle, HandleEnd> handle(rsvg_handle_new_from_data(
      reinterpret_cast<const guint8*>(svg.data()), static_cast<gsize>(svg.size()), &error));
  if (!handle) {
    drawn.problem = takeWords(error);
    return drawn;
  }
  constexpr double cssDpi = 96;
  rsvg_handle_set_dpi(handle.get(), cssDpi);
  const PageSize size = sizeOf(handle.get());
  if (!size.usable()) {
    drawn.problem = "it has no usable size";
    return drawn;
  }
  drawn.scale = scaleFor(size, rasters);
  std::string pdf;
  const std::unique_ptr<cairo_surface_t, SurfaceEnd> surface(cairo_pdf_surface_create_for_stream(
      append, &pdf, size.width_px * drawn.scale, size.height_px * drawn.scale));
  const std::unique_ptr<cairo_t, ContextEnd> context(cairo_create(surface.get()));
  cairo_scale(context.get(), drawn.scale, drawn.scale);
  const RsvgRectangle viewport{0, 0, size.width_px, size.height_px};
  if (!rsvg_handle_render_document(handle.get(), context.get(), &viewport, &error)) {
    drawn.problem = takeWords(error);
    return drawn;
  }
  cairo_show_page(context.get());
  cairo_surface_finish(surface.get());
  if (const cairo_status_t status = cairo_surface_status(surface.get()); status != CAIRO_STATUS_SUCCESS)
    drawn.problem = cairo_status_to_string(status);
  else
    drawn.pdf = std::move(pdf);
  return drawn;
}

}  // namespace detent::importer::svg
