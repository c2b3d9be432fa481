// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/placed_page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <QPolygonF>

#include "editor/document/kept_page.h"
#include "editor/importing/page_picture.h"

namespace detent::editor {
namespace {

constexpr double margin = 0.15;       // share of the frame's longer side, as much as axes and titles take
constexpr int largestSide_px = 2000;  // same as that of the import's own view
constexpr int samplesOfCurve = 96;
constexpr int nearCurve_px = 2,
              background_px = 9;   // half width of the search for a curve, and of its background
constexpr int leastContrast = 60;  // levels of 255, in one channel

/// The frame with room for its axes and titles, within the page.
importer::Box around(const importer::Box& frame, const importer::Page& page) {
  const double room = margin * std::max(frame.width(), frame.height());
  return {std::max(0.0, frame.x0 - room), std::max(0.0, frame.y0 - room),
          std::min(page.width, frame.x1 + room), std::min(page.height, frame.y1 + room)};
}

/// Corners of the frame in the picture, from the one at the start of the press and full force, clockwise on
/// the graph.
QPolygonF cornersOf(const importer::Box& frame, const importer::Homography& pageToPicture, int quarterTurns) {
  std::array<importer::Point, 4> corners{
      {{frame.x0, frame.y0}, {frame.x1, frame.y0}, {frame.x1, frame.y1}, {frame.x0, frame.y1}}};
  std::rotate(corners.begin(), corners.begin() + (4 - quarterTurns) % 4, corners.end());
  QPolygonF polygon;
  for (const importer::Point& corner : corners) {
    const importer::Point at = pageToPicture(corner);
    polygon << QPointF(at.x, at.y);
  }
  return polygon;
}

std::array<int, 3> channelsOf(QRgb color) { return {qRed(color), qGreen(color), qBlue(color)}; }

/// The median of the surroundings: the paper, or a filled background.
std::array<int, 3> backgroundAt(const QImage& picture, QPoint at) {
  std::array<std::vector<int>, 3> around;
  const QRect patch =
      QRect(at.x() - background_px, at.y() - background_px, 2 * background_px + 1, 2 * background_px + 1) &
      picture.rect();
  for (int y = patch.top(); y <= patch.bottom(); y += 2)
    for (int x = patch.left(); x <= patch.right(); x += 2) {
      const auto color = channelsOf(picture.pixel(x, y));
      for (std::size_t channel = 0; channel < 3; ++channel) around[channel].push_back(color[channel]);
    }
  std::array<int, 3> background{};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    auto& values = around[channel];
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                     values.end());
    background[channel] = values[values.size() / 2];
  }
  return background;
}

bool hasCurveColor(const QImage& picture, QPoint at) {
  if (!picture.rect().contains(at)) return false;
  const auto background = backgroundAt(picture, at);
  const QRect near =
      QRect(at.x() - nearCurve_px, at.y() - nearCurve_px, 2 * nearCurve_px + 1, 2 * nearCurve_px + 1) &
      picture.rect();
  for (int y = near.top(); y <= near.bottom(); ++y)
    for (int x = near.left(); x <= near.right(); ++x) {
      const auto color = channelsOf(picture.pixel(x, y));
      for (std::size_t channel = 0; channel < 3; ++channel)
        if (std::abs(color[channel] - background[channel]) >= leastContrast) return true;
    }
  return false;
}

double shareOnCurve(const StrokeCurve& curve, const QImage& picture, const QTransform& axesToPixel) {
  int onCurve = 0;
  for (int i = 0; i < samplesOfCurve; ++i) {
    const double at_mm = curve.start_mm() + (i + 0.5) / samplesOfCurve * (curve.end_mm() - curve.start_mm());
    onCurve += hasCurveColor(picture, axesToPixel.map(QPointF(at_mm, curve.force_N(at_mm))).toPoint());
  }
  return double(onCurve) / samplesOfCurve;
}

}  // namespace

std::optional<PlacedPage> placedPage(const Button& button, const importer::Document& sheet,
                                     const importer::Progress& progress) {
  if (!button.provenance() || button.provenance()->frame.size() != 4) return {};
  const Provenance& from = *button.provenance();
  const auto span = frameOf(from);
  const auto page = sheet.page(from.page, progress);
  if (!span || !page) return {};
  const importer::Box frame{from.frame[0], from.frame[1], from.frame[2], from.frame[3]};
  const auto view = sheet.view(*page, around(frame, *page));
  if (!view || view->raster.empty()) return {};
  PlacedPage placed{imageFrom(view->raster, largestSide_px), {}};
  const double shrink = double(placed.picture.width()) / view->raster.width_px;
  const importer::Homography smaller =
      importer::Affine{shrink, 0, 0, shrink, 0.5 * (shrink - 1), 0.5 * (shrink - 1)};
  const importer::Homography pageToPicture = smaller.after(view->viewToPage.inverse());
  const QPolygonF onGraph{{span->left(), span->bottom()},
                          {span->right(), span->bottom()},
                          {span->right(), span->top()},
                          {span->left(), span->top()}};
  double best = leastOnCurve;
  bool lies = false;
  for (int turns = 0; turns < 4; ++turns) {
    QTransform pixelToAxes;
    if (!QTransform::quadToQuad(cornersOf(frame, pageToPicture, turns), onGraph, pixelToAxes)) continue;
    const double share =
        shareOnCurve(button.states().front().graph.press(), placed.picture, pixelToAxes.inverted());
    if (share < best) continue;
    lies = true;
    best = share + 1e-9;  // of equally good orientations the first is kept, because pages are seldom turned
    placed.pixelToAxes = pixelToAxes;
  }
  return lies ? std::optional(std::move(placed)) : std::nullopt;
}

}  // namespace detent::editor
