// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/corrections.h"

#include <algorithm>
#include <cmath>
#include <QPolygonF>
#include <QTransform>

namespace detent::editor {
namespace {

/// Map from page units to the unit square, in which x runs to the right and y down, as the corners do.
std::optional<QTransform> toSquare(const FrameCorners& corners) {
  QPolygonF quad;
  for (const auto& corner : corners) quad << QPointF(corner.x, corner.y);
  QTransform map;
  if (!QTransform::quadToSquare(quad, map)) return {};
  return map;
}

struct Placed {
  double share = 0, value = 0;
};

std::vector<Placed> placed(GraphAxis axis, const FrameCorners& corners, const std::vector<AxisTick>& ticks) {
  std::vector<Placed> out;
  for (const AxisTick& tick : ticks) {
    if (const auto share = shareAlong(axis, corners, tick.at)) out.push_back({*share, tick.value});
  }
  return out;
}

/// Line by least squares; empty if all places coincide.
std::optional<AxisEnds> throughAll(const std::vector<Placed>& points) {
  double meanShare = 0, meanValue = 0;
  for (const Placed& p : points) meanShare += p.share, meanValue += p.value;
  meanShare /= static_cast<double>(points.size()), meanValue /= static_cast<double>(points.size());
  double spread = 0, along = 0;
  for (const Placed& p : points) {
    spread += (p.share - meanShare) * (p.share - meanShare);
    along += (p.share - meanShare) * (p.value - meanValue);
  }
  constexpr double leastSpread = 1e-8;  // places closer than this count as one
  if (spread < leastSpread || along == 0) return {};
  const double perShare = along / spread;
  const double atStart = meanValue - perShare * meanShare;
  return AxisEnds{atStart, atStart + perShare};
}

/// The found scale, if it goes through at least two found ticks and all given ones. Places that are typed or
/// clicked may be off by a part of the found ticks' distance, as the importer allows for labels.
std::optional<AxisEnds> scaleOfAll(const std::vector<Placed>& given, const std::vector<Placed>& found,
                                   const std::vector<Placed>& foundEnds) {
  constexpr double agreeOfPitch = 2 * 0.035;
  if (found.size() < 2 || foundEnds.size() != 2) return {};
  const auto ends = throughAll(foundEnds);
  if (!ends) return {};
  double pitch = 1;
  for (std::size_t i = 1; i < found.size(); ++i)
    pitch = std::min(pitch, std::abs(found[i].share - found[i - 1].share));
  const double span = std::abs(ends->max - ends->min);
  for (const Placed& p : given)
    if (std::abs(std::lerp(ends->min, ends->max, p.share) - p.value) > agreeOfPitch * pitch * span) return {};
  constexpr double rounding = 1e-9;  // share of the span: in the frame where it was found an end is exact
  const auto exact = [&](double end, double asFound) {
    return std::abs(end - asFound) <= rounding * span ? asFound : end;
  };
  return AxisEnds{exact(ends->min, foundEnds.front().value), exact(ends->max, foundEnds.back().value)};
}

void setEnds(const AxisCorrection& axis, const std::optional<AxisEnds>& fromTicks, std::optional<double>& min,
             std::optional<double>& max) {
  min = axis.min, max = axis.max;
  if (!fromTicks) return;
  min = fromTicks->min, max = fromTicks->max;
}

}  // namespace

std::optional<double> shareAlong(GraphAxis axis, const FrameCorners& corners, importer::Point at) {
  const auto square = toSquare(corners);
  if (!square) return {};
  const QPointF p = square->map(QPointF(at.x, at.y));
  const double share = axis == GraphAxis::x ? p.x() : 1 - p.y();
  if (!std::isfinite(share)) return {};
  return share;
}

importer::Point placeAlong(GraphAxis axis, const FrameCorners& corners, double share) {
  const auto square = toSquare(corners);
  if (!square) return corners[3];
  const QPointF inSquare = axis == GraphAxis::x ? QPointF(share, 1) : QPointF(0, 1 - share);
  const QPointF p = square->inverted().map(inSquare);
  return {p.x(), p.y()};
}

void endsToTicks(AxisCorrection& axis, GraphAxis which, const std::optional<FrameCorners>& corners) {
  if (corners && axis.min) axis.ticks.push_back({placeAlong(which, *corners, 0), *axis.min});
  if (corners && axis.max) axis.ticks.push_back({placeAlong(which, *corners, 1), *axis.max});
  axis.min.reset(), axis.max.reset();
}

void giveEnds(AxisCorrection& axis, GraphAxis which, std::optional<double> min, std::optional<double> max,
              const std::optional<FrameCorners>& corners) {
  constexpr double samePlace = 1e-3;  // share of the axis
  if (axis.ticks.empty() || !corners) {
    axis.ticks.clear();
    if (min) axis.min = min;
    if (max) axis.max = max;
    return;
  }
  AxisCorrection ends{min, max, {}};
  endsToTicks(ends, which, corners);
  for (const AxisTick& end : ends.ticks) {
    const double endShare = shareAlong(which, *corners, end.at).value_or(0);
    std::erase_if(axis.ticks, [&](const AxisTick& tick) {
      const auto share = shareAlong(which, *corners, tick.at);
      return share && std::abs(*share - endShare) < samePlace;
    });
    axis.ticks.push_back(end);
  }
}

std::optional<AxisEnds> endsFromTicks(GraphAxis axis, const FrameCorners& corners,
                                      const std::vector<AxisTick>& given, const std::vector<AxisTick>& found,
                                      const std::vector<AxisTick>& foundEnds) {
  auto points = placed(axis, corners, given);
  if (points.empty()) return {};
  if (const auto kept = scaleOfAll(points, placed(axis, corners, found), placed(axis, corners, foundEnds)))
    return kept;
  if (points.size() == 1) {
    const double at = points.front().share;
    const auto others = placed(axis, corners, found);
    const auto nearer = [at](const Placed& a, const Placed& b) {
      return std::abs(a.share - at) < std::abs(b.share - at);
    };
    const auto farthest = std::max_element(others.begin(), others.end(), nearer);
    if (farthest == others.end()) return {};
    points.push_back(*farthest);
  }
  return throughAll(points);
}

importer::ImportHints hintsFrom(const Corrections& corrections, const std::optional<FoundAxes>& found) {
  importer::ImportHints hints;
  if (corrections.frame) hints.frame.assign(corrections.frame->begin(), corrections.frame->end());
  std::optional<FrameCorners> corners = corrections.frame;
  if (!corners && found) corners = found->corners;
  const auto ends = [&](GraphAxis axis) -> std::optional<AxisEnds> {
    if (!corners) return {};
    const std::vector<AxisTick>& given = corrections.axis(axis).ticks;
    if (!found) return endsFromTicks(axis, *corners, given, {});
    const bool isX = axis == GraphAxis::x;
    return endsFromTicks(axis, *corners, given, isX ? found->xTicks : found->yTicks,
                         isX ? found->xEnds : found->yEnds);
  };
  setEnds(corrections.x, ends(GraphAxis::x), hints.axes.xMin, hints.axes.xMax);
  setEnds(corrections.y, ends(GraphAxis::y), hints.axes.yMin, hints.axes.yMax);
  hints.axes.xUnit = corrections.xUnit, hints.axes.yUnit = corrections.yUnit;
  hints.trace = {corrections.pressColor, corrections.releaseColor, corrections.masks};
  hints.drawn = corrections.drawn;
  hints.strokes = {corrections.swapStrokes, corrections.curve, corrections.noRelease};
  hints.dpi = corrections.dpi;
  return hints;
}

bool CorrectionHistory::apply(const Corrections& next, const QString& label, const QString& mergeKey) {
  if (next == now()) return false;
  steps_.resize(at_ + 1);
  const bool merges = at_ > 0 && !mergeKey.isEmpty() && steps_[at_].mergeKey == mergeKey;
  if (merges) {
    steps_[at_].value = next;
  } else {
    steps_.push_back({next, label, mergeKey});
    ++at_;
  }
  return true;
}

void CorrectionHistory::undo() {
  if (canUndo()) --at_;
}

void CorrectionHistory::redo() {
  if (canRedo()) ++at_;
}

}  // namespace detent::editor
