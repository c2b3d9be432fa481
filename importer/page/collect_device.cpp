// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/collect_device.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <stdexcept>

#include "importer/page/flatten.h"

namespace detent::importer {
namespace {

constexpr double flatness = 0.005;     // page units; the contract of VectorPath
constexpr double hairlineWidth = 0.1;  // page units; PDF's width 0 means the thinnest line a device can draw
constexpr double leastVisibleAlpha = 0.02;  // 1 is opaque

Affine toAffine(const fz_matrix& m) { return {m.a, m.b, m.c, m.d, m.e, m.f}; }

double expansion(const Affine& m) { return std::sqrt(std::abs(m.a * m.d - m.b * m.c)); }

constexpr Box unitSquare{0, 0, 1, 1};  // the square into which MuPDF draws an image before applying its map

/// Nothing if a point is not finite.
std::optional<Box> finiteBox(const std::vector<std::vector<Point>>& polylines) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Box box{inf, inf, -inf, -inf};
  for (const auto& line : polylines)
    for (const Point& p : line) {
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) return {};
      box = box.joined({p.x, p.y, p.x, p.y});
    }
  return box;
}

const fz_path_walker flattenWalker = {
    [](fz_context*, void* to, float x, float y) {
      static_cast<PathFlattener*>(to)->moveTo({x, y});
    },
    [](fz_context*, void* to, float x, float y) {
      static_cast<PathFlattener*>(to)->lineTo({x, y});
    },
    [](fz_context*, void* to, float x1, float y1, float x2, float y2, float x3, float y3) {
      static_cast<PathFlattener*>(to)->curveTo({x1, y1}, {x2, y2}, {x3, y3});
    },
    [](fz_context*, void* to) { static_cast<PathFlattener*>(to)->close(); },
    nullptr,
    nullptr,
    nullptr,
    nullptr};

struct Paint {
  Rgb color;
  double alpha = 1;
};

/// The C++ part of the device: keeps the graphics state that decides what is visible. Throws only C++
/// exceptions.
class Collector {
 public:
  Collector(const Box& bounds, CollectedPage* page, CollectControl* control)
      : page_(page),
        control_(control),
        bounds_(bounds),
        around_(bounds.grown(bounds.width(), bounds.height())),
        clips_{bounds},
        alphas_{1} {}

  CollectControl& control() { return *control_; }

  /// Called at the start of every device call; false: the page exceeds a limit, or a stop was requested.
  bool mayGoOn() {
    if (control_->stop != CollectStop::none) return false;
    ++operations_;
    if (operations_ > control_->maxOperations) return halt(CollectStop::tooManyOperations);
    return true;
  }

  bool halt(CollectStop why) {
    control_->stop = why;
    if (control_->cookie) control_->cookie->abort = 1;
    return false;
  }

  bool fill(fz_context* context, const fz_path* path, const fz_matrix& matrix, const Paint& paint) {
    VectorPath out;
    if (!begin(context, path, matrix, paint, out)) return control_->stop == CollectStop::none;
    out.fill = paint.color;
    noteFilled(out.polylines, paint);
    return store(std::move(out));
  }

  void letter(const SetLetter& letter, double alpha, bool drawn) {
    const Point middle = letter.box.middle();
    const bool inSight = clips_.back().contains(middle) && bounds_.contains(middle);
    page_->visibility.letter(letter, drawn && inSight && !hidden(alpha));
  }

  bool stroke(fz_context* context, const fz_path* path, const fz_stroke_state* state, const fz_matrix& matrix,
              const Paint& paint) {
    VectorPath out;
    if (!begin(context, path, matrix, paint, out)) return control_->stop == CollectStop::none;
    out.stroke = paint.color;
    out.strokeWidth =
        std::min(std::max(hairlineWidth, state->linewidth * expansion(toAffine(matrix))), around_.width());
    out.dashed = isDashed(*state);
    return store(std::move(out));
  }

  bool image(const fz_image* image, const fz_matrix& matrix, double alpha) {
    if (static_cast<double>(image->w) * image->h > control_->maxImagePixels) {
      control_->imageWidth_px = image->w;
      control_->imageHeight_px = image->h;
      return halt(CollectStop::imageTooLarge);
    }
    const Affine map = toAffine(matrix);
    const Box box = map.boxOf(unitSquare);
    const Box seen = box.common(clips_.back());
    if (hidden(alpha) || image->w <= 0 || image->h <= 0 || !(seen.width() > 0) || !(seen.height() > 0))
      return true;
    ImagePlacement placement;
    placement.image = {box, image->w, image->h};
    placement.pixelsToPage = map.after({1.0 / image->w, 0, 0, 1.0 / image->h, 0, 0});
    page_->images.push_back(placement);
    const bool upright = (map.b == 0 && map.c == 0) || (map.a == 0 && map.d == 0);
    const bool hides = upright && image->mask == nullptr && !image->imagemask && !image->use_colorkey;
    page_->visibility.cover(seen, CoverKind::picture, {}, hides && covers(alpha), page_->paths);
    return true;
  }

  /// `exact`: the clip is exactly this box, not an area inside it.
  void pushClip(const Box& box, bool exact) {
    clips_.push_back(clips_.back().common(box));
    exactClips_.push_back(exactClips_.back() && exact);
  }
  bool pushClipOfPath(fz_context* context, const fz_path* path, double grow, const fz_matrix& matrix) {
    PathFlattener flattener(toAffine(matrix), flatness, around_);
    fz_walk_path(context, path, &flattenWalker, &flattener);
    const auto polylines = flattener.takePolylines();
    if (!drawnInTime(polylines)) return halt(CollectStop::tooDense);
    const auto box = finiteBox(polylines);
    pushClip(box ? box->grown(grow, grow) : clips_.back(), grow == 0 && uprightRectangle(polylines));
    return true;
  }
  void pushUnknownClip() { pushClip(clips_.back(), false); }
  void popClip() {
    if (clips_.size() == 1) return;
    clips_.pop_back();
    exactClips_.pop_back();
  }

  void beginGroup(double alpha, bool blends) {
    alphas_.push_back(alphas_.back() * alpha);
    blends_.push_back(blends_.back() || blends);
  }
  void endGroup() {
    if (alphas_.size() == 1) return;
    alphas_.pop_back();
    blends_.pop_back();
  }

  /// Drawing between beginMask and endMask shapes a mask and is not collected.
  void beginMask() { ++maskDepth_; }
  void endMask() {
    maskDepth_ = std::max(0, maskDepth_ - 1);
    pushUnknownClip();
  }

  /// Number of cells that begin within an extent, plus one; infinite for a step of 0. An inverted area has no
  /// extent.
  static double cellsAlong(double extent, double step) {
    return step != 0 ? std::max(0.0, extent) / std::abs(step) + 1 : std::numeric_limits<double>::infinity();
  }

  /// Returns false if the tile has more cells than a page may draw objects. For MuPDF all cells are one
  /// object, between which it does not check its cookie.
  bool beginTile(const Box& area, const Box& cell, double stepX, double stepY, const fz_matrix& matrix) {
    const double cells = cellsAlong(area.width(), stepX) * cellsAlong(area.height(), stepY);
    if (!(cells <= static_cast<double>(control_->maxOperations))) return halt(CollectStop::tooManyOperations);
    operations_ += static_cast<std::size_t>(cells);
    tiles_.push_back({area, cell, stepX, stepY, toAffine(matrix), page_->paths.size()});
    return true;
  }
  void endTile() {
    if (tiles_.empty()) return;
    const Tile tile = tiles_.back();
    tiles_.pop_back();
    repeatTile(tile);
  }

 private:
  struct Tile {
    Box area, cell;  ///< in pattern space
    double stepX = 0, stepY = 0;
    Affine toPage;
    std::size_t firstPath = 0;
  };

  static bool isDashed(const fz_stroke_state& state) {
    for (int i = 1; i < state.dash_len && i < 32; i += 2)
      if (state.dash_list[i] > 0) return true;
    return false;
  }

  bool hidden(double alpha) const {
    return maskDepth_ > 0 || alpha * alphas_.back() < leastVisibleAlpha || clips_.back().empty();
  }

  /// Returns true if a fill is opaque and the clip is exactly its box.
  bool covers(double alpha) const {
    constexpr double opaque = 0.99;  // share of the colour
    return tiles_.empty() && exactClips_.back() && !blends_.back() && alpha * alphas_.back() > opaque;
  }

  void noteFilled(const std::vector<std::vector<Point>>& polylines, const Paint& paint) {
    constexpr double leastSide = 6;  // page units: smaller areas cannot be the background of a letter
    const auto whole = finiteBox(polylines);
    if (!whole) return;
    const Box box = whole->common(clips_.back());
    if (std::min(box.width(), box.height()) < leastSide) return;
    const bool hides = uprightRectangle(polylines) && covers(paint.alpha);
    page_->visibility.cover(box, hides ? CoverKind::rectangle : CoverKind::shape, paint.color, hides,
                            page_->paths);
  }

  /// Hidden objects are collected too, unless a clip excludes them.
  bool begin(fz_context* context, const fz_path* path, const fz_matrix& matrix, const Paint& paint,
             VectorPath& out) {
    if (clips_.back().empty()) return false;
    PathFlattener flattener(toAffine(matrix), flatness, around_);
    fz_walk_path(context, path, &flattenWalker, &flattener);  // these callbacks never longjmp
    points_ += flattener.pointCount();
    if (points_ > control_->maxPathPoints) return halt(CollectStop::tooManyPoints);
    out.polylines = flattener.takePolylines();
    if (!drawnInTime(out.polylines)) return halt(CollectStop::tooDense);
    out.closed = flattener.takeClosed();
    return !hidden(paint.alpha) && !out.polylines.empty();
  }

  /// Returns true if the vertical extent of the lines, summed, is within the limit of one object.
  bool drawnInTime(const std::vector<std::vector<Point>>& polylines) const {
    const auto row = [&](const Point& p) { return std::clamp(p.y, bounds_.y0, bounds_.y1); };
    double rise = 0;
    for (const auto& line : polylines)
      for (std::size_t i = 1; i < line.size(); ++i)
        if (std::isfinite(line[i - 1].y) && std::isfinite(line[i].y))
          rise += std::abs(row(line[i]) - row(line[i - 1]));
    return rise <= control_->maxRise;
  }

  bool store(VectorPath path) {
    const auto box = finiteBox(path.polylines);
    if (!box) return true;
    path.box = box->grown(path.strokeWidth / 2, path.strokeWidth / 2);
    if (!clipped(path)) return true;
    if (path.stroke && !page_->paths.empty() && isFillOf(page_->paths.back(), path)) {
      path.fill = page_->paths.back().fill;
      page_->paths.back() = std::move(path);
    } else {
      page_->paths.push_back(std::move(path));
    }
    return true;
  }

  static bool isFillOf(const VectorPath& filled, const VectorPath& stroked) {
    return filled.fill && !filled.stroke && filled.polylines == stroked.polylines;
  }

  /// Some programs wrap a whole drawing into a pattern of one cell; it is repeated. Fine hatching keeps its
  /// single cell.
  void repeatTile(const Tile& tile) {
    constexpr double maxCopies = 64;  // most copies of one tile
    const double stepX = std::abs(tile.stepX), stepY = std::abs(tile.stepY);
    if (!(stepX > 0) || !(stepY > 0)) return;
    const double firstColumn = std::floor((tile.area.x0 - tile.cell.x1) / stepX) + 1;
    const double lastColumn = std::ceil((tile.area.x1 - tile.cell.x0) / stepX) - 1;
    const double firstRow = std::floor((tile.area.y0 - tile.cell.y1) / stepY) + 1;
    const double lastRow = std::ceil((tile.area.y1 - tile.cell.y0) / stepY) - 1;
    const double copies = (lastColumn - firstColumn + 1) * (lastRow - firstRow + 1);
    const std::size_t count = page_->paths.size() - tile.firstPath;
    if (!(copies > 1) || copies > maxCopies) return;
    std::size_t points = 0;
    for (std::size_t i = tile.firstPath; i < page_->paths.size(); ++i)
      for (const auto& line : page_->paths[i].polylines) points += line.size();
    points_ += points * static_cast<std::size_t>(copies);
    if (points_ > control_->maxPathPoints) {
      halt(CollectStop::tooManyPoints);
      return;
    }
    for (double row = firstRow; row <= lastRow; ++row)
      for (double column = firstColumn; column <= lastColumn; ++column)
        if (row != 0 || column != 0) copyShifted(tile, count, column * stepX, row * stepY);
  }

  void copyShifted(const Tile& tile, std::size_t count, double dx, double dy) {
    const Affine& map = tile.toPage;
    const Affine shift{1, 0, 0, 1, map.a * dx + map.c * dy, map.b * dx + map.d * dy};
    for (std::size_t i = 0; i < count; ++i) {
      VectorPath copy = transformedPath(page_->paths[tile.firstPath + i], shift);
      if (clipped(copy)) page_->paths.push_back(std::move(copy));
    }
  }

  /// Notes the clip in force if it cuts the path. Returns false if the path is completely outside.
  bool clipped(VectorPath& path) const {
    const Box& clip = clips_.back();
    path.clip.reset();
    if (!clip.contains(path.box)) path.clip = clip;
    return clip.touches(path.box);
  }

  CollectedPage* page_;
  CollectControl* control_;
  Box bounds_;  ///< bounds of the page
  Box around_;  ///< the page with its width and height on every side; nothing farther off matters
  std::vector<Box> clips_;
  std::vector<bool> exactClips_{true};
  std::vector<double> alphas_;
  std::vector<bool> blends_{false};
  std::vector<Tile> tiles_;
  int maskDepth_ = 0;
  std::size_t operations_ = 0;
  std::size_t points_ = 0;
};

/// The device that MuPDF calls. It owns `collector`, which drop_device deletes.
struct CollectDevice {
  fz_device base;
  fz_device* recorder;
  Collector* collector;
};

CollectDevice& self(fz_device* device) { return *reinterpret_cast<CollectDevice*>(device); }

/// Runs C++ code inside a callback. C++ exceptions end here; the longjmp happens after all objects were
/// destroyed.
template <class Body>
void inCollector(fz_context* context, fz_device* device, Body body) {
  Collector* collector = self(device).collector;
  bool goOn = false;
  try {
    goOn = collector->mayGoOn() && body(*collector);
  } catch (const std::bad_alloc&) {
    collector->halt(CollectStop::outOfMemory);
  } catch (const std::length_error&) {
    collector->halt(CollectStop::outOfMemory);
  }
  if (!goOn) fz_throw(context, FZ_ERROR_ABORT, "page stopped");
}

Box toBox(const fz_rect& r) { return {r.x0, r.y0, r.x1, r.y1}; }

/// Any colour space to RGB; may longjmp, so it comes before C++ code.
Paint toPaint(fz_context* context, fz_colorspace* space, const float* color, float alpha,
              fz_color_params params) {
  float rgb[FZ_MAX_COLORS] = {0, 0, 0};
  if (space && color) fz_convert_color(context, space, color, fz_device_rgb(context), rgb, nullptr, params);
  const auto byte = [](float v) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(v, 0.0f, 1.0f) * 255));
  };
  return {{byte(rgb[0]), byte(rgb[1]), byte(rgb[2])}, alpha};
}

/// Notes the letters of a text at their places on the page. The colour of a text used as a clip is unknown:
/// grey.
void noteLetters(fz_context* context, fz_device* device, const fz_text* text, fz_matrix matrix,
                 const Paint& paint, bool drawn) {
  constexpr float below_em = -0.1f, above_em = 0.75f;
  for (const fz_text_span* span = text->head; span != nullptr; span = span->next)
    for (int i = 0; i < span->len; ++i) {
      const fz_text_item& item = span->items[i];
      if (item.ucs < 0 || item.gid < 0) continue;
      const float advance_em = fz_advance_glyph(context, span->font, item.gid, static_cast<int>(span->wmode));
      fz_matrix place = span->trm;
      place.e = item.x;
      place.f = item.y;
      place = fz_concat(place, matrix);
      const fz_rect box = fz_transform_rect(fz_make_rect(0, below_em, advance_em, above_em), place);
      const double size = expansion(toAffine(place));
      const SetLetter letter{item.ucs, place.e, place.f, toBox(box), size, size * advance_em, paint.color};
      inCollector(context, device, [&](Collector& c) { return c.letter(letter, paint.alpha, drawn), true; });
    }
}

constexpr Paint notKnown{{128, 128, 128}, 1};

void setCallbacks(fz_device& base) {
  base.close_device = [](fz_context* context, fz_device* device) {
    fz_close_device(context, self(device).recorder);
  };
  base.drop_device = [](fz_context* context, fz_device* device) {
    delete self(device).collector;
    fz_drop_device(context, self(device).recorder);
  };
  base.fill_path = [](fz_context* context, fz_device* device, const fz_path* path, int evenOdd,
                      fz_matrix matrix, fz_colorspace* space, const float* color, float alpha,
                      fz_color_params params) {
    const Paint paint = toPaint(context, space, color, alpha, params);
    inCollector(context, device, [&](Collector& c) { return c.fill(context, path, matrix, paint); });
    fz_fill_path(context, self(device).recorder, path, evenOdd, matrix, space, color, alpha, params);
  };
  base.stroke_path = [](fz_context* context, fz_device* device, const fz_path* path,
                        const fz_stroke_state* state, fz_matrix matrix, fz_colorspace* space,
                        const float* color, float alpha, fz_color_params params) {
    const Paint paint = toPaint(context, space, color, alpha, params);
    inCollector(context, device, [&](Collector& c) { return c.stroke(context, path, state, matrix, paint); });
    fz_stroke_path(context, self(device).recorder, path, state, matrix, space, color, alpha, params);
  };
  base.clip_path = [](fz_context* context, fz_device* device, const fz_path* path, int evenOdd,
                      fz_matrix matrix, fz_rect scissor) {
    inCollector(context, device, [&](Collector& c) { return c.pushClipOfPath(context, path, 0, matrix); });
    fz_clip_path(context, self(device).recorder, path, evenOdd, matrix, scissor);
  };
  base.clip_stroke_path = [](fz_context* context, fz_device* device, const fz_path* path,
                             const fz_stroke_state* state, fz_matrix matrix, fz_rect scissor) {
    const double grow = state->linewidth * expansion(toAffine(matrix));
    inCollector(context, device, [&](Collector& c) { return c.pushClipOfPath(context, path, grow, matrix); });
    fz_clip_stroke_path(context, self(device).recorder, path, state, matrix, scissor);
  };
  base.fill_text = [](fz_context* context, fz_device* device, const fz_text* text, fz_matrix matrix,
                      fz_colorspace* space, const float* color, float alpha, fz_color_params params) {
    noteLetters(context, device, text, matrix, toPaint(context, space, color, alpha, params), true);
    fz_fill_text(context, self(device).recorder, text, matrix, space, color, alpha, params);
  };
  base.stroke_text = [](fz_context* context, fz_device* device, const fz_text* text,
                        const fz_stroke_state* state, fz_matrix matrix, fz_colorspace* space,
                        const float* color, float alpha, fz_color_params params) {
    noteLetters(context, device, text, matrix, toPaint(context, space, color, alpha, params), true);
    fz_stroke_text(context, self(device).recorder, text, state, matrix, space, color, alpha, params);
  };
  base.clip_text = [](fz_context* context, fz_device* device, const fz_text* text, fz_matrix matrix,
                      fz_rect scissor) {
    noteLetters(context, device, text, matrix, notKnown, true);
    inCollector(context, device, [](Collector& c) { return c.pushUnknownClip(), true; });
    fz_clip_text(context, self(device).recorder, text, matrix, scissor);
  };
  base.clip_stroke_text = [](fz_context* context, fz_device* device, const fz_text* text,
                             const fz_stroke_state* state, fz_matrix matrix, fz_rect scissor) {
    noteLetters(context, device, text, matrix, notKnown, true);
    inCollector(context, device, [](Collector& c) { return c.pushUnknownClip(), true; });
    fz_clip_stroke_text(context, self(device).recorder, text, state, matrix, scissor);
  };
  base.ignore_text = [](fz_context* context, fz_device* device, const fz_text* text, fz_matrix matrix) {
    noteLetters(context, device, text, matrix, notKnown, false);
    fz_ignore_text(context, self(device).recorder, text, matrix);
  };
  base.fill_shade = [](fz_context* context, fz_device* device, fz_shade* shade, fz_matrix matrix, float alpha,
                       fz_color_params params) {
    inCollector(context, device, [](Collector&) { return true; });
    fz_fill_shade(context, self(device).recorder, shade, matrix, alpha, params);
  };
  base.fill_image = [](fz_context* context, fz_device* device, fz_image* image, fz_matrix matrix, float alpha,
                       fz_color_params params) {
    inCollector(context, device, [&](Collector& c) { return c.image(image, matrix, alpha); });
    fz_fill_image(context, self(device).recorder, image, matrix, alpha, params);
  };
  base.fill_image_mask = [](fz_context* context, fz_device* device, fz_image* image, fz_matrix matrix,
                            fz_colorspace* space, const float* color, float alpha, fz_color_params params) {
    inCollector(context, device, [&](Collector& c) { return c.image(image, matrix, alpha); });
    fz_fill_image_mask(context, self(device).recorder, image, matrix, space, color, alpha, params);
  };
  base.clip_image_mask = [](fz_context* context, fz_device* device, fz_image* image, fz_matrix matrix,
                            fz_rect scissor) {
    const Box box = toAffine(matrix).boxOf(unitSquare);
    inCollector(context, device, [&](Collector& c) {
      if (!c.image(image, matrix, 0)) return false;  // only the image's size is needed here
      c.pushClip(box, false);
      return true;
    });
    fz_clip_image_mask(context, self(device).recorder, image, matrix, scissor);
  };
  base.pop_clip = [](fz_context* context, fz_device* device) {
    inCollector(context, device, [](Collector& c) { return c.popClip(), true; });
    fz_pop_clip(context, self(device).recorder);
  };
  base.begin_mask = [](fz_context* context, fz_device* device, fz_rect area, int luminosity,
                       fz_colorspace* space, const float* color, fz_color_params params) {
    inCollector(context, device, [](Collector& c) { return c.beginMask(), true; });
    fz_begin_mask(context, self(device).recorder, area, luminosity, space, color, params);
  };
  base.end_mask = [](fz_context* context, fz_device* device) {
    inCollector(context, device, [](Collector& c) { return c.endMask(), true; });
    fz_end_mask(context, self(device).recorder);
  };
  base.begin_group = [](fz_context* context, fz_device* device, fz_rect area, fz_colorspace* space,
                        int isolated, int knockout, int blendMode, float alpha) {
    inCollector(context, device, [&](Collector& c) { return c.beginGroup(alpha, blendMode != 0), true; });
    fz_begin_group(context, self(device).recorder, area, space, isolated, knockout, blendMode, alpha);
  };
  base.end_group = [](fz_context* context, fz_device* device) {
    inCollector(context, device, [](Collector& c) { return c.endGroup(), true; });
    fz_end_group(context, self(device).recorder);
  };
  base.begin_tile = [](fz_context* context, fz_device* device, fz_rect area, fz_rect view, float stepX,
                       float stepY, fz_matrix matrix, int) {
    inCollector(context, device,
                [&](Collector& c) { return c.beginTile(toBox(area), toBox(view), stepX, stepY, matrix); });
    // With a repeated id the recorder would answer "already known", but the paths are needed each time.
    fz_begin_tile(context, self(device).recorder, area, view, stepX, stepY, matrix);
    return 0;
  };
  base.end_tile = [](fz_context* context, fz_device* device) {
    inCollector(context, device, [](Collector& c) { return c.endTile(), true; });
    fz_end_tile(context, self(device).recorder);
  };
  base.render_flags = [](fz_context* context, fz_device* device, int set, int clear) {
    fz_render_flags(context, self(device).recorder, set, clear);
  };
  base.set_default_colorspaces = [](fz_context* context, fz_device* device, fz_default_colorspaces* spaces) {
    fz_set_default_colorspaces(context, self(device).recorder, spaces);
  };
}

}  // namespace

VectorPath transformedPath(const VectorPath& path, const Affine& map) {
  VectorPath out = path;
  for (auto& line : out.polylines)
    for (Point& p : line) p = map(p);
  out.strokeWidth = path.strokeWidth * expansion(map);
  out.box = map.boxOf(path.box);
  if (path.clip) out.clip = map.boxOf(*path.clip);
  return out;
}

fz_device* newCollectDevice(fz_context* context, fz_device* recorder, const Box& bounds, CollectedPage* page,
                            CollectControl* control) {
  auto* device = reinterpret_cast<CollectDevice*>(fz_new_device_of_size(context, sizeof(CollectDevice)));
  try {
    device->collector = new Collector(bounds, page, control);
  } catch (const std::bad_alloc&) {
    device->collector = nullptr;
  }
  if (!device->collector) {
    fz_drop_device(context, &device->base);
    fz_throw(context, FZ_ERROR_MEMORY, "no memory to collect a page");
  }
  device->recorder = fz_keep_device(context, recorder);
  setCallbacks(device->base);
  return &device->base;
}

}  // namespace detent::importer
