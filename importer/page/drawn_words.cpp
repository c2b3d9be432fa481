// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/drawn_words.h"

#include <cstddef>

#include "importer/page/mupdf_context.h"

namespace detent::importer {
namespace {

/// RAII owner of the MuPDF drawing objects.
struct Drawing {
  explicit Drawing(fz_context* mupdf) : context(mupdf) {}
  ~Drawing() {
    fz_drop_pixmap(context, pixels);
    fz_drop_text(context, text);
    fz_drop_font(context, font);
  }
  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;

  fz_context* context;
  fz_font* font = nullptr;
  fz_text* text = nullptr;
  fz_pixmap* pixels = nullptr;
};

void drawText(Drawing& d, fz_matrix place) {
  fz_context* const context = d.context;
  fz_device* device = nullptr;
  fz_var(device);
  fz_try(context) {
    const float black = 0;
    device = fz_new_draw_device(context, fz_identity, d.pixels);
    fz_fill_text(context, device, d.text, place, fz_device_gray(context), &black, 1, fz_default_color_params);
    fz_close_device(context, device);
  }
  fz_always(context) fz_drop_device(context, device);
  fz_catch(context) fz_rethrow(context);
}

/// Returns false if a character has no glyph: it would be drawn as nothing or as a box.
bool hasAllLetters(const fz_text* text) {
  for (const fz_text_span* span = text->head; span != nullptr; span = span->next)
    for (int i = 0; i < span->len; ++i)
      if (span->items[i].gid == 0 && span->items[i].ucs > ' ') return false;
  return true;
}

}  // namespace

std::optional<Raster> wordsDrawn(const std::string& utf8, int height_px) {
  constexpr std::size_t mostBytes = 64, mostMemory = std::size_t{32} << 20;
  constexpr int least_px = 8, most_px = 256;
  if (utf8.empty() || utf8.size() > mostBytes || height_px < least_px || height_px > most_px) return {};
  const MupdfContext owner(mostMemory);
  fz_context* const context = owner.get();
  if (context == nullptr) return {};
  Drawing d(context);
  std::string error;
  const bool drawn = guarded(context, error, [&] {
    d.font = fz_new_base14_font(context, "Helvetica");
    d.text = fz_new_text(context);
    const auto size = static_cast<float>(height_px);
    fz_show_string(context, d.text, d.font, fz_scale(size, -size), utf8.c_str(), 0, 0, FZ_BIDI_LTR,
                   FZ_LANG_UNSET);
    if (!hasAllLetters(d.text)) return;
    const fz_rect bounds = fz_bound_text(context, d.text, nullptr, fz_identity);
    const fz_irect whole = fz_irect_from_rect(fz_expand_rect(bounds, 2));
    d.pixels = fz_new_pixmap_with_bbox(context, fz_device_gray(context), whole, nullptr, 0);
    fz_clear_pixmap_with_value(context, d.pixels, 255);
    drawText(d, fz_identity);
  });
  if (!drawn || d.pixels == nullptr) return {};
  Raster raster;
  raster.width_px = fz_pixmap_width(context, d.pixels);
  raster.height_px = fz_pixmap_height(context, d.pixels);
  const unsigned char* const samples = fz_pixmap_samples(context, d.pixels);
  const int stride = fz_pixmap_stride(context, d.pixels);
  for (int y = 0; y < raster.height_px; ++y)
    for (int x = 0; x < raster.width_px; ++x)
      raster.rgb.insert(raster.rgb.end(), 3, samples[static_cast<std::ptrdiff_t>(y) * stride + x]);
  return raster;
}

}  // namespace detent::importer
