// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/error_bars.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace detent::importer::trace {

namespace {

constexpr float kBarCore = 0.5F;        // coverage of a line's core
constexpr int kLeastBar_px = 9;         // height of a bar
constexpr std::size_t kFewestBars = 5;  // bars in a row on one curve
constexpr double kTimesCurve = 2;       // height of a bar over the curve's beside it
constexpr double kUnlikeArms = 0.25;    // of a bar's height, between its arms

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
    for (int y = 0; y < plane.height; ++y)
      for (int x = 0; x < plane.width; ++x) {
        if (plane.at(x, y) < kBarCore) continue;
        std::vector<ColumnRun>& column = runs_[static_cast<std::size_t>(x)];
        if (column.empty() || column.back().bottom + 1 < y)
          column.push_back({y, y});
        else
          column.back().bottom = y;
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

/// The next bar on the right along the same curve; letters are not joined to others in this way.
std::optional<std::size_t> nextAlong(const ColumnRuns& columns, const std::vector<ErrorBar>& bars,
                                     std::size_t from) {
  constexpr int mostGap = 3, reach_px = 2;  // columns; rows
  double row = bars[from].rightRow;
  int gap = 0;
  for (int x = bars[from].right; x < columns.count() && gap <= mostGap; ++x) {
    const int at = static_cast<int>(std::lround(row));
    const auto isThere = [&](const ErrorBar& bar) {
      return bar.left <= x && x <= bar.right && std::abs(bar.leftRow - row) <= 0.5 * bar.thickness + reach_px;
    };
    const auto found =
        std::find_if(bars.begin() + static_cast<std::ptrdiff_t>(from) + 1, bars.end(), isThere);
    if (found != bars.end()) return static_cast<std::size_t>(found - bars.begin());
    const auto run = columns.beside(x, {at - reach_px, at + reach_px});
    gap = run ? 0 : gap + 1;
    if (run) row = run->middle();
  }
  return {};
}

/// The bars that stand in a row of at least `kFewestBars` on one curve.
std::vector<ErrorBar> onOneCurve(const ColumnRuns& columns, std::vector<ErrorBar> bars) {
  std::ranges::sort(bars, {}, &ErrorBar::left);
  std::vector<std::size_t> next(bars.size(), bars.size()), before(bars.size(), 1), behind(bars.size(), 1);
  for (std::size_t i = 0; i < bars.size(); ++i) {
    next[i] = nextAlong(columns, bars, i).value_or(bars.size());
    if (next[i] < bars.size()) before[next[i]] = std::max(before[next[i]], before[i] + 1);
  }
  for (std::size_t i = bars.size(); i-- > 0;)
    if (next[i] < bars.size()) behind[i] = behind[next[i]] + 1;
  std::vector<ErrorBar> kept;
  for (std::size_t i = 0; i < bars.size(); ++i)
    if (before[i] + behind[i] > kFewestBars) kept.push_back(bars[i]);
  return kept;
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
  // A cap is as thin as the bar, level with its end and no longer than it.
  constexpr double level_px = 1.5;
  const int thick_px = std::max(1, bar.right - bar.left - 1 - rim_px);
  for (const int end : {bar.rows.top, bar.rows.bottom - thick_px + 1})
    for (const int step : {-1, 1}) {
      const ColumnRun level{end, end + thick_px - 1};
      for (int by = 0; by < bar.rows.height(); ++by) {
        const int x = (step < 0 ? bar.left : bar.right) + step * by;
        const auto cap = columns.beside(x, level);
        if (!cap || cap->height() > thick_px + rim_px || std::abs(cap->middle() - level.middle()) > level_px)
          break;
        const int last = std::min(plane.height - 1, cap->bottom + rim_px);
        for (int y = std::max(0, cap->top - rim_px); y <= last; ++y) plane.at(x, y) = 0;
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
  bars = onOneCurve(columns, std::move(bars));
  for (const ErrorBar& bar : bars) eraseBar(plane, columns, bar);
  return bars.size();
}

}  // namespace detent::importer::trace
