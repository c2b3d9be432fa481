// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/follow_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "importer/page/quantile.h"

namespace detent::importer::trace {

namespace {

// The coverage that counts as no ink and as nothing but ink. A thin line's ridge shares its ink between two
// pixels; a thick one's is full of it, so that paler things in the same hue are told apart.
constexpr float kThinFrom = 0.0F, kThinFull = 0.65F;
constexpr float kThickFrom = 0.3F, kThickFull = 0.9F;
constexpr double kThick_px = 1.8;

constexpr float kLeakWorth =
    0.6F;  // of a covered pixel with own ink at the cover's edge, against a pixel of plain ink
constexpr float kLeakFull = 0.2F;  // own coverage at the edge that makes such a trace certain
constexpr float kWallColumn =
    3;  // what a column costs on an end wall: only a wall is worth it, not a stretch of curve

/// A path runs through these stages in order; the first and the last are optional. Only there does a rise or
/// fall earn anything, and only in one direction: walls at the ends are followed to their tips, while in
/// between every column counts once, so that a marker line or an arrow that stands on the curve is no detour
/// worth taking.
enum Stage : int { headUp, headDown, body, tailUp, tailDown };
constexpr int kStages = 5;

/// How a state of the search was reached; three bits per stage.
enum class Step : std::uint16_t { start, alongX, fromBefore, fromOtherBefore, up, down };

/// Largest value within two pixels.
Plane largestNearby(const Plane& plane) {
  Plane rows = plane;
  for (int y = 0; y < plane.height; ++y) {
    const float* in = plane.values.data() + plane.index(0, y);
    float* out = rows.values.data() + rows.index(0, y);
    for (int x = 2; x + 2 < plane.width; ++x)
      out[x] = std::max({in[x - 2], in[x - 1], in[x], in[x + 1], in[x + 2]});
  }
  Plane both = rows;
  for (int y = 2; y + 2 < plane.height; ++y)
    for (int dy = -2; dy <= 2; ++dy) {
      const float* in = rows.values.data() + rows.index(0, y + dy);
      float* out = both.values.data() + both.index(0, y);
      for (int x = 0; x < plane.width; ++x) out[x] = std::max(out[x], in[x]);
    }
  return both;
}

class CurveSearch {
 public:
  CurveSearch(const CurveField& field, const Box& within, const FollowOptions& options)
      : field_(field), options_(options), near_(largestNearby(field.own)) {
    if (options.thickness_px >= kThick_px) {
      inkFrom_ = kThickFrom;
      inkFull_ = kThickFull;
    }
    x0_ = std::max(0, static_cast<int>(std::floor(within.x0)));
    y0_ = std::max(0, static_cast<int>(std::floor(within.y0)));
    x1_ = std::min(field.own.width - 1, static_cast<int>(std::ceil(within.x1)));
    y1_ = std::min(field.own.height - 1, static_cast<int>(std::ceil(within.y1)));
  }

  CoarseCurve best() {
    if (x1_ <= x0_ || y1_ <= y0_) return {};
    sweep();
    return walkBack();
  }

 private:
  float inkAt(int x, int y) const {
    return std::clamp((field_.own.at(x, y) - inkFrom_) / (inkFull_ - inkFrom_), 0.0F, 1.0F);
  }
  /// Ink, or where another curve covers the pixel the traces that a line beneath it leaves at the cover's
  /// edges.
  float evidenceAt(int x, int y) const {
    const float ink = inkAt(x, y), cover = std::min(1.0F, field_.otherCurves.at(x, y));
    return cover < 0.5F ? ink
                        : std::max(ink, kLeakWorth * cover * std::min(1.0F, near_.at(x, y) / kLeakFull));
  }
  /// Price of a pixel that shows nothing of the curve.
  float bridgeCost(int x, int y) const {
    const Point p{static_cast<double>(x), static_cast<double>(y)};
    for (const Box& box : field_.opaque)
      if (box.contains(p)) return static_cast<float>(options_.opaqueCost);
    const float cover = std::min(1.0F, field_.otherCurves.at(x, y));
    const float clutter = std::min(1.0F - cover, field_.clutter.at(x, y));
    return static_cast<float>(options_.paperCost) * (1 - cover - clutter) +
           static_cast<float>(options_.hiddenCost) * cover +
           static_cast<float>(options_.clutterCost) * clutter;
  }
  float visibleAt(int x, int y) const {
    return std::max(0.0F, 1 - field_.otherCurves.at(x, y) - field_.clutter.at(x, y));
  }
  std::size_t rows() const { return static_cast<std::size_t>(y1_ - y0_ + 1); }
  std::uint16_t& stepsAt(int x, std::size_t row) {
    return steps_[static_cast<std::size_t>(x - x0_) * rows() + row];
  }
  void setStep(int x, std::size_t row, int stage, Step step) {
    std::uint16_t& steps = stepsAt(x, row);
    const int shift = 3 * stage;
    steps = static_cast<std::uint16_t>((steps & ~(7 << shift)) | (static_cast<int>(step) << shift));
  }

  void sweep() {
    const std::size_t n = rows();
    steps_.assign(static_cast<std::size_t>(x1_ - x0_ + 1) * n, 0);
    for (auto& values : value_) values.assign(n, -1e9F);
    cost_.resize(n);
    gain_.resize(n);
    for (int x = x0_; x <= x1_; ++x) {
      for (std::size_t r = 0; r < n; ++r) {
        const int y = y0_ + static_cast<int>(r);
        const float ink = evidenceAt(x, y);
        cost_[r] = (1 - ink) * bridgeCost(x, y);
        gain_[r] = ink - cost_[r];
      }
      for (std::size_t r = 0; r < n; ++r) arrive(x, r);
      const float rise = static_cast<float>(options_.riseCost);
      runAlongColumn(x, headUp, true, [&](std::size_t r) { return gain_[r]; });
      runAlongColumn(x, headDown, false, [&](std::size_t r) { return gain_[r]; });
      runAlongColumn(x, body, true, [&](std::size_t r) { return -cost_[r] - rise; });
      runAlongColumn(x, body, false, [&](std::size_t r) { return -cost_[r] - rise; });
      runAlongColumn(x, tailUp, true, [&](std::size_t r) { return gain_[r]; });
      runAlongColumn(x, tailDown, false, [&](std::size_t r) { return gain_[r]; });
      for (int stage = 0; stage < kStages; ++stage)
        for (std::size_t r = 0; r < n; ++r)
          if (value_[static_cast<std::size_t>(stage)][r] > bestGain_) {
            bestGain_ = value_[static_cast<std::size_t>(stage)][r];
            endX_ = x;
            endRow_ = r;
            endStage_ = stage;
          }
    }
  }

  /// From the column before, into every stage at this row.
  void arrive(int x, std::size_t r) {
    const std::array<float, kStages> before = {value_[0][r], value_[1][r], value_[2][r], value_[3][r],
                                               value_[4][r]};
    const auto enter = [&](int stage, float from, Step step) {
      value_[static_cast<std::size_t>(stage)][r] = from + gain_[r];
      setStep(x, r, stage, step);
    };
    for (int stage : {headUp, headDown}) {
      const float along = before[static_cast<std::size_t>(stage)] - kWallColumn;
      if (along > 0)
        enter(stage, along, Step::alongX);
      else
        enter(stage, 0, Step::start);
    }
    float best = 0;
    Step step = Step::start;
    if (before[body] > best) {
      best = before[body];
      step = Step::alongX;
    }
    if (before[headUp] > best) {
      best = before[headUp];
      step = Step::fromBefore;
    }
    if (before[headDown] > best) {
      best = before[headDown];
      step = Step::fromOtherBefore;
    }
    enter(body, best, step);
    for (int stage : {tailUp, tailDown}) {
      const float along = before[static_cast<std::size_t>(stage)] - kWallColumn;
      if (along > before[body])
        enter(stage, along, Step::alongX);
      else
        enter(stage, before[body], Step::fromBefore);
    }
  }

  template <class Price>
  void runAlongColumn(int x, int stage, bool up, Price price) {
    std::vector<float>& value = value_[static_cast<std::size_t>(stage)];
    const std::size_t n = rows();
    for (std::size_t k = 1; k < n; ++k) {
      const std::size_t to = up ? n - 1 - k : k, from = up ? to + 1 : to - 1;
      const float arrived = value[from] + price(to);
      if (arrived > value[to]) {
        value[to] = arrived;
        setStep(x, to, stage, up ? Step::up : Step::down);
      }
    }
  }

  CoarseCurve walkBack() {
    CoarseCurve curve;
    if (bestGain_ <= 0) return curve;
    curve.gain_px = static_cast<double>(bestGain_);
    int x = endX_, stage = endStage_;
    std::size_t row = endRow_;
    double ink = 0, visible = 0, inColumn = 0;
    for (;;) {
      const int y = y0_ + static_cast<int>(row);
      curve.points.push_back({static_cast<double>(x), static_cast<double>(y)});
      const double share = static_cast<double>(inkAt(x, y));
      ink += share;
      inColumn = std::max(inColumn, share);
      visible += std::max(share, static_cast<double>(visibleAt(x, y)));
      const Step step = static_cast<Step>((stepsAt(x, row) >> (3 * stage)) & 7);
      if (step != Step::up && step != Step::down) {
        curve.inkColumns_px += inColumn;
        inColumn = 0;
      }
      if (step == Step::start) break;
      if (step == Step::up) {
        ++row;
      } else if (step == Step::down) {
        --row;
      } else {
        if (step == Step::fromBefore) stage = stage == body ? headUp : body;
        if (step == Step::fromOtherBefore) stage = headDown;
        --x;
      }
    }
    std::reverse(curve.points.begin(), curve.points.end());
    curve.inkShare = visible > 0 ? ink / visible : 0;
    curve.span_px = curve.points.back().x - curve.points.front().x;
    const auto [low, high] = std::minmax_element(curve.points.begin(), curve.points.end(),
                                                 [](Point a, Point b) { return a.y < b.y; });
    curve.rise_px = high->y - low->y;
    return curve;
  }

  const CurveField& field_;
  const FollowOptions& options_;
  float inkFrom_ = kThinFrom, inkFull_ = kThinFull;
  Plane near_;  ///< own ink within two pixels
  int x0_ = 0, y0_ = 0, x1_ = -1, y1_ = -1;
  std::array<std::vector<float>, kStages> value_;
  std::vector<float> cost_, gain_;
  std::vector<std::uint16_t> steps_;
  float bestGain_ = 0;
  int endX_ = 0, endStage_ = body;
  std::size_t endRow_ = 0;
};

}  // namespace

CoarseCurve followCurve(const CurveField& field, const Box& within, const FollowOptions& options) {
  return CurveSearch(field, within, options).best();
}

double lineThickness(const Plane& own) {
  // Runs of ink down the columns: flat stretches give the thickness, steep ones more, so a low quantile is
  // taken.
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
