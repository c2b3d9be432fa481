// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "importer/frame/plot_frame.h"
#include "importer/page/polyline.h"

namespace detent::importer {
namespace {

Failure refused(const Page& page, Message problem) {
  return {FailureCode::wrongUsage, page.source, "plot frame entered by hand", std::move(problem),
          Message("Give two opposite corners or four (top left, top right, bottom right, bottom left) inside "
                  "the page")};
}

bool convex(const std::vector<Point>& p) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point &a = p[i], &b = p[(i + 1) % p.size()], &c = p[(i + 2) % p.size()];
    if (cross(b - a, c - b) <= 0) return false;
  }
  return true;
}

/// Quarter turns that make the graph upright; its top edge then runs to the right.
int quarterTurnsOf(const std::vector<Point>& p) {
  const double dx = p[1].x - p[0].x, dy = p[1].y - p[0].y;
  if (std::abs(dx) >= std::abs(dy)) return dx > 0 ? 0 : 2;
  return dy < 0 ? 1 : 3;
}

}  // namespace

Result<Found<FrameCandidate>> frameFromCorners(const std::vector<Point>& given, const Page& page) {
  if (given.size() != 2 && given.size() != 4)
    return refused(page, Message("a plot frame needs 2 or 4 corners, not %1", given.size()));
  const double margin = page.unit == PageUnit::pixel ? 0.5 : 0;
  for (const auto& p : given)
    if (!(p.x >= -margin && p.y >= -margin && p.x <= page.width - margin && p.y <= page.height - margin))
      return refused(page, Message("corner (%1, %2) is outside the page", p.x, p.y));
  std::vector<Point> corners = given;
  if (given.size() == 2) {
    const Box box = boundsOf(given);
    corners = {{box.x0, box.y0}, {box.x1, box.y0}, {box.x1, box.y1}, {box.x0, box.y1}};
  }
  if (twiceAreaOf(corners) < 2 || !convex(corners))
    return refused(page, Message("the corners enclose no area in this order"));
  Found<FrameCandidate> found;
  found.confidence = 1;
  found.by = DecidedBy::given;
  found.evidence = {{EvidenceCode::frameGiven}};
  auto& c = found.value;
  c.pageBox = boundsOf(corners);
  c.quarterTurns = quarterTurnsOf(corners);
  if (c.quarterTurns == 0) c.levelToPage = sheetOfCorners(corners, page).value_or(Homography{});
  const Homography toLevel = c.levelToPage.inverse();
  std::vector<Point> level;
  for (const Point& corner : corners) level.push_back(toLevel(corner));
  c.uprightBox = boundsOf(level);
  const double w = c.uprightBox.width(), h = c.uprightBox.height();
  const Box bounds = toLevel.boxOf({-margin, -margin, page.width - margin, page.height - margin});
  c.regionBox = Box{c.uprightBox.x0 - 0.45 * w, c.uprightBox.y0 - 0.4 * h, c.uprightBox.x1 + 0.5 * w,
                    c.uprightBox.y1 + 0.45 * h}
                    .common(bounds);
  if (c.quarterTurns != 0) {  // labels of a turned plot may be on any side of the page's box
    const double room = 0.5 * std::max(w, h);
    c.regionBox = {std::max(bounds.x0, c.pageBox.x0 - room), std::max(bounds.y0, c.pageBox.y0 - room),
                   std::min(bounds.x1, c.pageBox.x1 + room), std::min(bounds.y1, c.pageBox.y1 + room)};
  }
  c.givenCorners = std::move(corners);
  return found;
}

}  // namespace detent::importer
