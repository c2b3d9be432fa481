// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/view_grid.h"

#include <algorithm>
#include <cmath>

namespace detent::importer {
namespace {

/// An image whose pixel rows and columns are parallel to the page's sides.
struct AlignedImage {
  Box box;
  double pitchX = 0, pitchY = 0;
};

double coverage(const Box& box, const Box& region) {
  const Box common = box.common(region);
  return common.empty() ? 0 : common.area() / region.area();
}

/// The image's grid if it is upright, turned by quarters or flipped; nothing if its rows drift by more than a
/// quarter pixel across the image.
std::optional<AlignedImage> aligned(const ImagePlacement& placement) {
  constexpr double maxDrift_px = 0.25;
  const Affine& map = placement.pixelsToPage;
  const double w = placement.image.width_px, h = placement.image.height_px;
  const bool upright = std::abs(map.b) * w <= maxDrift_px * std::abs(map.d) &&
                       std::abs(map.c) * h <= maxDrift_px * std::abs(map.a);
  const bool lying = std::abs(map.a) * w <= maxDrift_px * std::abs(map.c) &&
                     std::abs(map.d) * h <= maxDrift_px * std::abs(map.b);
  if (upright) return AlignedImage{placement.image.box, std::abs(map.a), std::abs(map.d)};
  if (lying) return AlignedImage{placement.image.box, std::abs(map.c), std::abs(map.b)};
  return std::nullopt;
}

bool samePitch(const AlignedImage& a, const AlignedImage& b) {
  constexpr double tolerance = 0.002;  // relative
  return std::abs(a.pitchX / b.pitchX - 1) < tolerance && std::abs(a.pitchY / b.pitchY - 1) < tolerance;
}

/// The image on whose pixel grid the region is shown, if images of the same pitch (scanners and word
/// processors cut one picture into strips) cover most of the region. A stretched background of a few pixels
/// does not count.
std::optional<AlignedImage> dominating(const std::vector<ImagePlacement>& placements, const Box& region) {
  constexpr double mostOf = 0.5;               // share of the region's area
  constexpr double coarsestPitch = 72.0 / 40;  // points per pixel: 40 dpi
  std::vector<AlignedImage> images;
  for (const ImagePlacement& placement : placements) {
    const auto image = aligned(placement);
    if (image && coverage(image->box, region) > 0 &&
        std::max(image->pitchX, image->pitchY) <= coarsestPitch && std::min(image->pitchX, image->pitchY) > 0)
      images.push_back(*image);
  }
  const auto byCoverage = [&](const AlignedImage& a, const AlignedImage& b) {
    return coverage(a.box, region) < coverage(b.box, region);
  };
  const auto largest = std::max_element(images.begin(), images.end(), byCoverage);
  if (largest == images.end()) return std::nullopt;
  double covered = 0;
  for (const AlignedImage& image : images)
    if (samePitch(image, *largest)) covered += coverage(image.box, region);
  if (covered < mostOf) return std::nullopt;
  return *largest;
}

/// Returns true if the region is a drawing over a background image, not a picture with a box or a remark on
/// it.
bool carriesDrawing(const Page& page, const Box& region) {
  constexpr std::size_t drawingStartsAt = 8;  // polylines
  std::size_t polylines = 0;
  for (const VectorPath& path : page.paths) {
    if (path.box.touches(region)) polylines += path.polylines.size();
    if (polylines >= drawingStartsAt) return true;
  }
  return false;
}

/// Pixels per page unit of the finest image that covers a fair part of the region; a render is never coarser.
double finestImageScale(const std::vector<ImagePlacement>& images, const Box& region) {
  constexpr double fairPart = 0.05;  // share of the region's area
  double scale = 0;
  for (const ImagePlacement& placement : images) {
    if (coverage(placement.image.box, region) < fairPart) continue;
    const Affine& map = placement.pixelsToPage;
    const double pitch = std::min(std::hypot(map.a, map.b), std::hypot(map.c, map.d));
    if (pitch > 0) scale = std::max(scale, 1 / pitch);
  }
  return scale;
}

/// The whole pixels that cover the region.
PixelRect coveringPixels(const ViewGrid& grid, const Box& region) {
  constexpr double slack_px = 1e-3;  // a region that ends at a pixel's edge includes no further pixel
  const double x0 = std::floor((region.x0 - grid.origin.x) / grid.pitchX + slack_px);
  const double y0 = std::floor((region.y0 - grid.origin.y) / grid.pitchY + slack_px);
  const double x1 = std::ceil((region.x1 - grid.origin.x) / grid.pitchX - slack_px);
  const double y1 = std::ceil((region.y1 - grid.origin.y) / grid.pitchY - slack_px);
  return {static_cast<int>(x0), static_cast<int>(y0), static_cast<int>(std::max(1.0, x1 - x0)),
          static_cast<int>(std::max(1.0, y1 - y0))};
}

bool fits(const ViewGrid& grid, const Box& region, double maxPixels) {
  constexpr double maxSide = 30000;  // MuPDF's rasteriser works with 16-bit coordinates
  const double width = region.width() / grid.pitchX, height = region.height() / grid.pitchY;
  return width <= maxSide && height <= maxSide && width * height <= maxPixels;
}

ViewGrid rendered(const Box& region, int quarterTurns, const std::vector<ImagePlacement>& images,
                  const ViewOptions& options, double maxPixels) {
  constexpr double maxSide_px = 16384;
  const double uprightWidth = quarterTurns % 2 == 0 ? region.width() : region.height();
  double scale = std::min(options.minFrameWidth_px / uprightWidth, options.maxScale_px_per_unit);
  scale = std::max(scale, finestImageScale(images, region));
  scale = std::min({scale, maxSide_px / region.width(), maxSide_px / region.height(),
                    std::sqrt(maxPixels / (region.width() * region.height()))});
  ViewGrid grid;
  grid.origin = {region.x0, region.y0};
  grid.pitchX = grid.pitchY = 1 / scale;
  grid.rect = coveringPixels(grid, region);
  return grid;
}

double turnedAngle(double angle_deg, int quarterTurns) {
  double angle = std::remainder(angle_deg - 90.0 * quarterTurns, 360.0);
  if (angle <= -180) angle += 360;
  return angle == 0 ? 0 : angle;
}

}  // namespace

Affine ViewGrid::pageToUprightCorners() const {
  return {1 / pitchX, 0, 0, 1 / pitchY, -origin.x / pitchX, -origin.y / pitchY};
}

Affine ViewGrid::viewToPage(int quarterTurns) const {
  const Affine centresToPage{pitchX, 0, 0, pitchY, origin.x + pitchX / 2, origin.y + pitchY / 2};
  return centresToPage.after(turnedCropToRaster(rect, quarterTurns));
}

ViewGrid overviewGrid(double width, double height, double scale, double maxSide_px) {
  scale = std::min({scale, maxSide_px / width, maxSide_px / height});
  ViewGrid grid;
  grid.pitchX = grid.pitchY = 1 / scale;
  grid.rect = coveringPixels(grid, {0, 0, width, height});
  return grid;
}

std::optional<ViewGrid> chooseGrid(const Box& region, int quarterTurns, const Page& page,
                                   const std::vector<ImagePlacement>& images, const ViewOptions& options,
                                   double maxPixels) {
  const Box seen{std::max(region.x0, 0.0), std::max(region.y0, 0.0), std::min(region.x1, page.width),
                 std::min(region.y1, page.height)};
  if (seen.empty()) return std::nullopt;
  const auto image = dominating(images, seen);
  if (image && !carriesDrawing(page, seen)) {
    ViewGrid grid;
    grid.origin = {image->box.x0, image->box.y0};
    grid.pitchX = image->pitchX;
    grid.pitchY = image->pitchY;
    grid.nativePixels = true;
    if (fits(grid, seen, maxPixels)) {
      grid.rect = coveringPixels(grid, seen);
      return grid;
    }
  }
  return rendered(seen, quarterTurns, images, options, maxPixels);
}

void carryContent(const Page& page, const Box& region, int quarterTurns, const Affine& pageToView,
                  PageView& view) {
  for (const TextBox& text : page.texts)
    if (text.box.touches(region))
      view.texts.push_back(
          {text.utf8, pageToView.boxOf(text.box), turnedAngle(text.angle_deg, quarterTurns)});
  for (const VectorPath& path : page.paths)
    if (path.box.touches(region)) view.paths.push_back(transformedPath(path, pageToView));
}

}  // namespace detent::importer
