#include "importer/trace/follow_curve.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace detent::importer::inks {

namespace {

constexpr float kFullFrom = 0.65F;  // a thin line's ridge shares its ink between two pixels: this much counts as all

/// How a state of the search was reached; two bits per direction.
enum class Step : std::uint8_t { start = 0, alongX = 1, alongXTurned = 2, alongY = 3 };

class CurveSearch {
 public:
  CurveSearch(const CurveField& field, const Box& within, const FollowOptions& options)
      : field_(field), options_(options) {
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
  float inkAt(int x, int y) const { return std::min(1.0F, field_.own.at(x, y) / kFullFrom); }
  float hiddenAt(int x, int y) const {
    return std::min(1.0F, std::max(field_.otherCurves.at(x, y), field_.clutter.at(x, y)));
  }
  float gainAt(int x, int y) const {
    const float ink = inkAt(x, y), hidden = hiddenAt(x, y);
    const float cost = static_cast<float>(options_.paperCost) * (1 - hidden) +
                       static_cast<float>(options_.hiddenCost) * hidden;
    return ink - (1 - ink) * cost;
  }
  std::size_t rows() const { return static_cast<std::size_t>(y1_ - y0_ + 1); }
  std::uint8_t& stepAt(int x, std::size_t row) { return steps_[static_cast<std::size_t>(x - x0_) * rows() + row]; }

  void sweep() {
    const std::size_t n = rows();
    steps_.assign(static_cast<std::size_t>(x1_ - x0_ + 1) * n, 0);
    const float none = -1e9F;
    std::vector<float> up(n, none), down(n, none), gain(n);
    const float turn = static_cast<float>(options_.reversalCost);
    for (int x = x0_; x <= x1_; ++x) {
      for (std::size_t r = 0; r < n; ++r) gain[r] = gainAt(x, y0_ + static_cast<int>(r));
      for (std::size_t r = 0; r < n; ++r) {
        const float u = up[r], d = down[r];
        Step stepUp = Step::start, stepDown = Step::start;
        float bestUp = 0, bestDown = 0;
        if (u > bestUp) { bestUp = u; stepUp = Step::alongX; }
        if (d - turn > bestUp) { bestUp = d - turn; stepUp = Step::alongXTurned; }
        if (d > bestDown) { bestDown = d; stepDown = Step::alongX; }
        if (u - turn > bestDown) { bestDown = u - turn; stepDown = Step::alongXTurned; }
        up[r] = bestUp + gain[r];
        down[r] = bestDown + gain[r];
        stepAt(x, r) = static_cast<std::uint8_t>(static_cast<int>(stepUp) | (static_cast<int>(stepDown) << 2));
      }
      for (std::size_t r = n - 1; r-- > 0;)
        if (up[r + 1] + gain[r] > up[r]) {
          up[r] = up[r + 1] + gain[r];
          stepAt(x, r) = static_cast<std::uint8_t>((stepAt(x, r) & ~3) | static_cast<int>(Step::alongY));
        }
      for (std::size_t r = 1; r < n; ++r)
        if (down[r - 1] + gain[r] > down[r]) {
          down[r] = down[r - 1] + gain[r];
          stepAt(x, r) = static_cast<std::uint8_t>((stepAt(x, r) & ~12) | (static_cast<int>(Step::alongY) << 2));
        }
      for (std::size_t r = 0; r < n; ++r) {
        note(x, r, true, up[r]);
        note(x, r, false, down[r]);
      }
    }
  }

  void note(int x, std::size_t row, bool isUp, float value) {
    if (value <= bestGain_) return;
    bestGain_ = value;
    endX_ = x;
    endRow_ = row;
    endUp_ = isUp;
  }

  CoarseCurve walkBack() {
    CoarseCurve curve;
    if (bestGain_ <= 0) return curve;
    curve.gain_px = static_cast<double>(bestGain_);
    int x = endX_;
    std::size_t row = endRow_;
    bool isUp = endUp_;
    double ink = 0, visible = 0;
    for (;;) {
      const int y = y0_ + static_cast<int>(row);
      curve.points.push_back({static_cast<double>(x), static_cast<double>(y)});
      const double share = static_cast<double>(inkAt(x, y));
      const double open = std::max(share, 1 - static_cast<double>(hiddenAt(x, y)));
      ink += share;
      visible += open;
      const Step step = static_cast<Step>((stepAt(x, row) >> (isUp ? 0 : 2)) & 3);
      if (step == Step::start) break;
      if (step == Step::alongY) {
        row = isUp ? row + 1 : row - 1;
        continue;
      }
      if (step == Step::alongXTurned) isUp = !isUp;
      --x;
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
  int x0_ = 0, y0_ = 0, x1_ = -1, y1_ = -1;
  std::vector<std::uint8_t> steps_;
  float bestGain_ = 0;
  int endX_ = 0;
  std::size_t endRow_ = 0;
  bool endUp_ = true;
};

}  // namespace

CoarseCurve followCurve(const CurveField& field, const Box& within, const FollowOptions& options) {
  return CurveSearch(field, within, options).best();
}

double lineThickness(const Plane& own) {
  // Runs of ink down the columns: flat stretches give the thickness, steep ones more, so a low quantile is taken.
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
  if (runs.empty()) return 1;
  const auto at = runs.begin() + static_cast<std::ptrdiff_t>(runs.size() / 3);
  std::nth_element(runs.begin(), at, runs.end());
  return std::max(1.0, static_cast<double>(*at));
}

}  // namespace detent::importer::inks
