// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/error_bars.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "importer/page/quantile.h"

namespace detent::importer::trace {

namespace {

constexpr float kBarCore = 0.5F, kBarRim = 0.15F;  // coverage of a line's core, and of its blurred rim
constexpr int kLeastBar_px = 9;                    // height of a bar
constexpr std::size_t kFewestBars = 5;             // bars of one colour
constexpr double kTimesCurve = 2;                  // height of a bar over the curve's beside it
constexpr double kUnlikeArms = 0.25;               // of a bar's height, between its arms

struct ColumnRun {
  int top, bottom;
  int height() const { return bottom - top + 1; }
  double middle() const { return 0.5 * (top + bottom); }
  bool overlaps(const ColumnRun& other) const { return top <= other.bottom && other.top <= bottom; }
};

/// A bar with the rows and the thickness of the curve that it stands on.
struct ErrorBar {
  int left, right;  ///< columns beside it
  ColumnRun rows;
  double leftRow, rightRow, thickness;
};

/// The covered stretches of each column.
class ColumnRuns {
 public:
  explicit ColumnRuns(const Plane& plane) : runs_(static_cast<std::size_t>(plane.width)) {
    for (int x = 0; x < plane.width; ++x)
      for (int y = 0; y < plane.height; ++y) {
        if (plane.at(x, y) < kBarCore) continue;
        const int top = y;
        while (y + 1 < plane.height && plane.at(x, y + 1) >= kBarCore) ++y;
        runs_[static_cast<std::size_t>(x)].push_back({top, y});
      }
  }
  int count() const { return static_cast<int>(runs_.size()); }
  const std::vector<ColumnRun>& at(int x) const { return runs_[static_cast<std::size_t>(x)]; }

  /// The stretch in a column that is nearest to the middle of `bar` and within its rows.
  std::optional<ColumnRun> beside(int x, const ColumnRun& bar) const {
    std::optional<ColumnRun> nearest;
    if (x < 0 || x >= count()) return nearest;
    for (const ColumnRun& run : at(x))
      if (run.overlaps(bar) &&
          (!nearest || std::abs(run.middle() - bar.middle()) < std::abs(nearest->middle() - bar.middle())))
        nearest = run;
    return nearest;
  }

 private:
  std::vector<std::vector<ColumnRun>> runs_;
};

/// The first column on one side of a stretch that is not as tall there; nullopt if it is too wide for a bar.
std::optional<int> columnBesideBar(const ColumnRuns& columns, int x, const ColumnRun& run, int step) {
  constexpr double asTall = 0.7;  // of its height
  const int widest = std::max(4, run.height() / 4);
  for (int by = 1; by <= widest; ++by) {
    const auto next = columns.beside(x + step * by, run);
    if (!next || next->height() < asTall * run.height()) return x + step * (by + 1);  // past the blurred rim
  }
  return {};
}

/// The bar whose left column this is. At an end of its curve it has the curve on one side only.
std::optional<ErrorBar> errorBarAt(const ColumnRuns& columns, int x, const ColumnRun& run) {
  if (run.height() < kLeastBar_px) return {};
  const auto left = columnBesideBar(columns, x, run, -1), right = columnBesideBar(columns, x, run, 1);
  if (!left || !right) return {};
  const auto before = columns.beside(*left, run), after = columns.beside(*right, run);
  if (!before && !after) return {};
  ErrorBar bar{*left,
               *right,
               run,
               before ? before->middle() : after->middle(),
               after ? after->middle() : before->middle(),
               0};
  bar.thickness = std::max(before ? before->height() : 0, after ? after->height() : 0);
  const double row = 0.5 * (bar.leftRow + bar.rightRow);
  const double above = row - run.top, below = run.bottom - row;
  const bool tall = run.height() >= kTimesCurve * bar.thickness;
  if (!tall || std::abs(above - below) > kUnlikeArms * run.height()) return {};
  return bar;
}

void eraseBar(Plane& plane, const ColumnRuns& columns, const ErrorBar& bar) {
  constexpr int rim_px = 2;
  const int x0 = std::max(0, bar.left), x1 = std::min(plane.width - 1, bar.right);
  const int y0 = std::max(0, bar.rows.top - rim_px),
            y1 = std::min(plane.height - 1, bar.rows.bottom + rim_px);
  for (int x = x0; x <= x1; ++x) {
    const double share = (x - bar.left) / static_cast<double>(bar.right - bar.left);
    const double row = std::lerp(bar.leftRow, bar.rightRow, share);
    for (int y = y0; y <= y1; ++y)
      if (std::abs(y - row) > 0.5 * bar.thickness + 1) plane.at(x, y) = 0;
  }
  // A cap is as thin as the bar and no longer than it; the curve may run through it.
  const int thin_px = bar.right - bar.left + rim_px;
  for (const int end : {bar.rows.top, bar.rows.bottom})
    for (const int step : {-1, 1}) {
      const ColumnRun rows{std::max(0, end - thin_px), std::min(plane.height - 1, end + thin_px)};
      for (int by = 0; by < bar.rows.height(); ++by) {
        const int x = (step < 0 ? bar.left : bar.right) + step * by;
        const auto cap = columns.beside(x, rows);
        if (!cap || cap->height() > thin_px) break;
        for (int y = cap->top; y > 0 && y > cap->top - thin_px && plane.at(x, y) > kBarRim; --y)
          plane.at(x, y) = 0;
        for (int y = cap->top + 1; y < plane.height && y < cap->bottom + thin_px && plane.at(x, y) > kBarRim;
             ++y)
          plane.at(x, y) = 0;
      }
    }
}

}  // namespace

std::size_t eraseErrorBars(Plane& plane) {
  const ColumnRuns columns(plane);
  std::vector<ErrorBar> bars;
  for (int x = 0; x < columns.count(); ++x)
    for (const ColumnRun& run : columns.at(x)) {
      const auto bar = errorBarAt(columns, x, run);
      const auto isSame = [&](const ErrorBar& other) {
        return other.right >= bar->left && other.rows.overlaps(bar->rows);
      };
      if (bar && std::ranges::none_of(bars, isSame)) bars.push_back(*bar);
    }
  if (bars.size() < kFewestBars) return 0;
  std::vector<double> heights;
  for (const ErrorBar& bar : bars) heights.push_back(bar.rows.height());
  const double usual = quantileOf(heights, 0.5);
  std::erase_if(bars, [&](const ErrorBar& bar) { return bar.rows.height() > 3 * usual; });
  if (bars.size() < kFewestBars) return 0;
  for (const ErrorBar& bar : bars) eraseBar(plane, columns, bar);
  return bars.size();
}

}  // namespace detent::importer::trace
