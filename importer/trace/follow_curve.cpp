// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/follow_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "importer/page/quantile.h"

namespace detent::importer::trace {

namespace {

// Coverages that count as none and as full. A thin line's ridge shares its coverage between two pixels; a
// thick one's is full, so paler marks of the same hue can be separated.
constexpr float kThinFrom = 0.0F, kThinFull = 0.65F;
constexpr float kThickFrom = 0.3F, kThickFull = 0.9F;  // coverages; lines of kThick_px and more
constexpr double kThick_px = 1.8;

constexpr float kLeakWorth =
    0.6F;  // worth of a covered pixel with own colour at the cover's edge, relative to a plain pixel
constexpr float kLeakFull = 0.2F;  // own coverage at the edge that makes such a trace certain
constexpr float kVerticalColumn =
    3;  // cost of a column on a steep end; only a steep end is worth it, not a stretch of curve

/// Stages of a path in order; the first and the last are optional. Only there does a rise or fall earn, and
/// only in one direction: steep ends are followed to their tips, while in between every column counts once,
/// so that a marker line or an arrow on the curve is no detour worth taking.
enum Stage : int { headUp, headDown, body, tailUp, tailDown };
constexpr int kStages = 5;

/// The previous step of a state of the search.
enum class ColumnStep : std::uint8_t { start, alongX, fromBefore, fromOtherBefore, up, down };

/// Largest value within two pixels; at the plane's rim only along it.
float largestNear(const Plane& plane, int x, int y) {
  const int reachX = x >= 2 && x + 2 < plane.width ? 2 : 0, reachY = y >= 2 && y + 2 < plane.height ? 2 : 0;
  float largest = plane.at(x, y);
  for (int v = y - reachY; v <= y + reachY; ++v)
    for (int u = x - reachX; u <= x + reachX; ++u) largest = std::max(largest, plane.at(u, v));
  return largest;
}

class CurveSearch {
 public:
  CurveSearch(const CurveField& field, const Box& within, const FollowOptions& options)
      : field_(field), options_(options) {
    if (options.thickness_px >= kThick_px) {
      coverageFrom_ = kThickFrom;
      coverageFull_ = kThickFull;
    }
    x0_ = std::max(0, static_cast<int>(std::floor(within.x0)));
    y0_ = std::max(0, static_cast<int>(std::floor(within.y0)));
    x1_ = std::min(field.own.width - 1, static_cast<int>(std::ceil(within.x1)));
    y1_ = std::min(field.own.height - 1, static_cast<int>(std::ceil(within.y1)));
  }

  CoarseCurve best() {
    if (x1_ <= x0_ || y1_ <= y0_) return {};
    sweep();
    return pathBackwards();
  }

 private:
  float coverageAt(int x, int y) const {
    return std::clamp((field_.own.at(x, y) - coverageFrom_) / (coverageFull_ - coverageFrom_), 0.0F, 1.0F);
  }
  /// Costs and gains of a column's pixels. A pixel shows the colour, or, under another curve, the traces of a
  /// line beneath it at the cover's edges; other pixels have the price of bridging.
  void priceColumn(int x) {
    const auto paper = static_cast<float>(options_.paperCost),
               hidden = static_cast<float>(options_.hiddenCost),
               text = static_cast<float>(options_.clutterCost);
    std::size_t i = field_.own.index(x, y0_);
    for (std::size_t r = 0; r < rows(); ++r, i += static_cast<std::size_t>(field_.own.width)) {
      const float cover = std::min(1.0F, field_.otherCurves.values[i]);
      const float clutter = std::min(1.0F - cover, field_.clutter.values[i]);
      const int y = y0_ + static_cast<int>(r);
      covered_[r] = coverageAt(x, y);
      if (cover >= 0.5F)
        covered_[r] = std::max(
            covered_[r], kLeakWorth * cover * std::min(1.0F, largestNear(field_.own, x, y) / kLeakFull));
      cost_[r] = paper * (1 - cover - clutter) + hidden * cover + text * clutter;
    }
    for (const Box& box : field_.opaque) {
      if (x < box.x0 || x > box.x1) continue;
      const int from = std::max(y0_, static_cast<int>(std::ceil(box.y0))),
                to = std::min(y1_, static_cast<int>(std::floor(box.y1)));
      for (int y = from; y <= to; ++y)
        cost_[static_cast<std::size_t>(y - y0_)] = static_cast<float>(options_.opaqueCost);
    }
    for (std::size_t r = 0; r < rows(); ++r) {
      cost_[r] *= 1 - covered_[r];
      gain_[r] = covered_[r] - cost_[r];
    }
    gaining_.clear();
    for (std::size_t r = 0; r < rows(); ++r)
      if (gain_[r] > 0) gaining_.push_back(r);
  }
  float visibleAt(int x, int y) const {
    return std::max(0.0F, 1 - field_.otherCurves.at(x, y) - field_.clutter.at(x, y));
  }
  std::size_t rows() const { return static_cast<std::size_t>(y1_ - y0_ + 1); }
  /// The steps into a column's rows.
  ColumnStep* stepsAt(int x, int stage) {
    return steps_.data() +
           (static_cast<std::size_t>(x - x0_) * kStages + static_cast<std::size_t>(stage)) * rows();
  }

  void sweep() {
    const std::size_t n = rows();
    steps_.assign(static_cast<std::size_t>(x1_ - x0_ + 1) * kStages * n, ColumnStep::start);
    for (auto& values : value_) values.assign(n, -1e9F);
    for (auto* column : {&covered_, &cost_, &gain_, &rise_}) column->resize(n);
    for (int x = x0_; x <= x1_; ++x) {
      priceColumn(x);
      for (std::size_t r = 0; r < n; ++r) rise_[r] = -cost_[r] - static_cast<float>(options_.riseCost);
      arrive(x);
      runAlongColumn(x, headUp, true, gain_);
      runAlongColumn(x, headDown, false, gain_);
      runAlongColumn(x, body, true, rise_);
      runAlongColumn(x, body, false, rise_);
      runAlongColumn(x, tailUp, true, gain_);
      runAlongColumn(x, tailDown, false, gain_);
      // A path ends where it gains.
      for (int stage = 0; stage < kStages; ++stage)
        for (const std::size_t r : gaining_)
          if (value_[static_cast<std::size_t>(stage)][r] > bestGain_) {
            bestGain_ = value_[static_cast<std::size_t>(stage)][r];
            endX_ = x;
            endRow_ = r;
            endStage_ = stage;
          }
    }
  }

  /// Moves every stage one column on. Later stages come first, because they use the previous column of
  /// earlier ones.
  void arrive(int x) {
    const std::size_t n = rows();
    const float* gain = gain_.data();
    float *inBody = value_[body].data(), *inUp = value_[headUp].data(), *inDown = value_[headDown].data();
    for (const int stage : {tailUp, tailDown}) {
      float* value = value_[static_cast<std::size_t>(stage)].data();
      ColumnStep* step = stepsAt(x, stage);
      for (std::size_t r = 0; r < n; ++r) {
        const float along = value[r] - kVerticalColumn;
        step[r] = along > inBody[r] ? ColumnStep::alongX : ColumnStep::fromBefore;
        value[r] = std::max(along, inBody[r]) + gain[r];
      }
    }
    ColumnStep* step = stepsAt(x, body);
    for (std::size_t r = 0; r < n; ++r) {
      const float on = std::max(0.0F, inBody[r]), orUp = std::max(on, inUp[r]);
      step[r] = inDown[r] > orUp   ? ColumnStep::fromOtherBefore
                : inUp[r] > on     ? ColumnStep::fromBefore
                : inBody[r] > 0.0F ? ColumnStep::alongX
                                   : ColumnStep::start;
      inBody[r] = std::max(orUp, inDown[r]) + gain[r];
    }
    for (const int stage : {headUp, headDown}) {
      float* value = value_[static_cast<std::size_t>(stage)].data();
      ColumnStep* into = stepsAt(x, stage);
      for (std::size_t r = 0; r < n; ++r) {
        const float along = value[r] - kVerticalColumn;
        into[r] = along > 0 ? ColumnStep::alongX : ColumnStep::start;
        value[r] = std::max(along, 0.0F) + gain[r];
      }
    }
  }

  void runAlongColumn(int x, int stage, bool up, const std::vector<float>& price) {
    float* value = value_[static_cast<std::size_t>(stage)].data();
    ColumnStep* step = stepsAt(x, stage);
    const auto n = static_cast<std::ptrdiff_t>(rows()), next = std::ptrdiff_t{up ? -1 : 1};
    float carried = value[up ? n - 1 : 0];
    for (std::ptrdiff_t r = (up ? n - 1 : 0) + next; r >= 0 && r < n; r += next) {
      const float arrived = carried + price[static_cast<std::size_t>(r)];
      carried = value[r];
      if (arrived <= carried) continue;
      value[r] = carried = arrived;
      step[r] = up ? ColumnStep::up : ColumnStep::down;
    }
  }

  CoarseCurve pathBackwards() {
    CoarseCurve curve;
    if (bestGain_ <= 0) return curve;
    curve.gain_px = static_cast<double>(bestGain_);
    int x = endX_, stage = endStage_;
    std::size_t row = endRow_;
    double covered = 0, visible = 0, inColumn = 0;
    for (;;) {
      const int y = y0_ + static_cast<int>(row);
      curve.points.push_back({static_cast<double>(x), static_cast<double>(y)});
      const double share = static_cast<double>(coverageAt(x, y));
      covered += share;
      inColumn = std::max(inColumn, share);
      visible += std::max(share, static_cast<double>(visibleAt(x, y)));
      const ColumnStep step = stepsAt(x, stage)[row];
      if (step != ColumnStep::up && step != ColumnStep::down) {
        curve.coveredColumns_px += inColumn;
        inColumn = 0;
      }
      if (step == ColumnStep::start) break;
      if (step == ColumnStep::up) {
        ++row;
      } else if (step == ColumnStep::down) {
        --row;
      } else {
        if (step == ColumnStep::fromBefore) stage = stage == body ? headUp : body;
        if (step == ColumnStep::fromOtherBefore) stage = headDown;
        --x;
      }
    }
    std::reverse(curve.points.begin(), curve.points.end());
    curve.coveredShare = visible > 0 ? covered / visible : 0;
    curve.span_px = curve.points.back().x - curve.points.front().x;
    const auto [low, high] = std::minmax_element(curve.points.begin(), curve.points.end(),
                                                 [](Point a, Point b) { return a.y < b.y; });
    curve.rise_px = high->y - low->y;
    return curve;
  }

  const CurveField& field_;
  const FollowOptions& options_;
  float coverageFrom_ = kThinFrom, coverageFull_ = kThinFull;
  int x0_ = 0, y0_ = 0, x1_ = -1, y1_ = -1;
  std::array<std::vector<float>, kStages> value_;
  std::vector<float> covered_, cost_, gain_, rise_;  ///< of the column's rows
  std::vector<std::size_t> gaining_;                 ///< rows of the column
  std::vector<ColumnStep> steps_;                    ///< steps by column, and within a column by stage
  float bestGain_ = 0;
  int endX_ = 0, endStage_ = body;
  std::size_t endRow_ = 0;
};

}  // namespace

CoarseCurve followCurve(const CurveField& field, const Box& within, const FollowOptions& options) {
  return CurveSearch(field, within, options).best();
}

double lineThickness(const Plane& own) {
  // Runs down the columns: flat stretches give the thickness, steep ones more, so a low quantile is used.
  std::vector<float> runs;
  for (int x = 0; x < own.width; x += 2) {
    float run = 0;
    for (int y = 0; y < own.height; ++y) {
      const float c = own.at(x, y);
      if (c > 0.1F) {
        run += c;
      } else if (run > 0) {
        if (run > 0.4F) runs.push_back(run);
        run = 0;
      }
    }
  }
  return std::max(1.0, static_cast<double>(quantileOf(std::move(runs), 1.0 / 3)));
}

}  // namespace detent::importer::trace
