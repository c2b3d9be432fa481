// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/interchange/snippets.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/check.h"

namespace detent::playback {

namespace {

constexpr int mostUnits = 8;
constexpr std::size_t mostSnippets = 15, shortFrames = 7;  // a frame of a later snippet takes two bytes
constexpr std::size_t freeBytes = snippetMemoryBytes - 4;  // two counts, two end pointers of sequences
constexpr double cheapest = 1e-3, dearest = 1e7;           // bounds of the price of a byte, in squared levels
constexpr int halvings = 14;  // bisection steps over that range, on a logarithmic scale

/// The cheapest points of an envelope up to each cell: squared error plus `perByte` for every byte.
class CheapestPoints {
 public:
  CheapestPoints(const LevelPath& levelPath, double perByte)
      : cells_(levelPath.levels.size()),
        perByte_(perByte),
        nextOnset_(cells_ + 1, cells_),
        reached_(cells_ + 1),
        sums_(cells_ + static_cast<std::size_t>(mostUnits * snippetUnits.back()) + 1) {
    std::vector<bool> begins(cells_, false);
    for (const std::size_t onset : levelPath.onsets)
      if (onset < cells_) begins[onset] = true;
    for (std::size_t cell = cells_; cell-- > 1;)
      nextOnset_[cell - 1] = begins[cell] ? cell : nextOnset_[cell];
    for (std::size_t i = 0; i + 1 < sums_.size(); ++i) {
      const double level = i < cells_ ? levelPath.levels[i] : 0, place = static_cast<double>(i) + 0.5;
      sums_[i + 1] = {sums_[i].levels + level, sums_[i].byPlace + level * place,
                      sums_[i].squares + level * level};
    }
    Reached start;
    start.cost = 0;
    for (std::size_t cell = 0; cell < cells_; ++cell) {
      const Reached& before = cell == 0 ? start : cheapestAt(cell);
      for (std::size_t timebase = 0; timebase < snippetUnits.size(); ++timebase) {
        goOn(cell, before, timebase, true);
        if (cell > 0) goOn(cell, reached_[cell][timebase], timebase, false);
      }
    }
  }

  std::size_t cells() const { return cells_; }
  /// Largest size of points and frames up to a cell: two bytes per frame, and one byte to end at level 0.
  std::size_t mostBytesAt(std::size_t cell) const {
    const Reached& end = cheapestAt(cell);
    return end.points + 3 * snippetsAt(cell) + 1;
  }
  std::size_t snippetsAt(std::size_t cell) const {
    return std::max<std::size_t>(1, cheapestAt(cell).snippets);
  }

  SnippetRow upTo(std::size_t cell) const {
    SnippetRow row;
    row.held = cell;
    row.cut = cell < cells_;
    bool begun = true;  // the previous point began a snippet
    for (const Reached* end = cell > 0 ? &cheapestAt(cell) : nullptr; end != nullptr;) {
      if (begun) row.snippets.push_back({end->timebase, {}});
      row.snippets.back().points.push_back(end->point);
      begun = end->begins;
      end = end->fromCell > 0 ? &reached_[end->fromCell][end->fromTimebase] : nullptr;
    }
    for (Snippet& snippet : row.snippets) std::ranges::reverse(snippet.points);
    std::ranges::reverse(row.snippets);
    if (row.snippets.empty()) row.snippets.push_back({0, {{}}});
    if (row.snippets.back().points.back().level != 0) row.snippets.back().points.push_back({});
    return row;
  }

 private:
  /// The cheapest way to reach a cell with a last point of one time unit.
  struct Reached {
    double cost = std::numeric_limits<double>::infinity();
    SnippetPoint point;
    bool begins = false;  ///< this point begins a snippet
    std::size_t timebase = 0, points = 0, snippets = 0;
    std::size_t fromCell = 0, fromTimebase = 0;
  };
  struct Sums {
    double levels = 0, byPlace = 0, squares = 0;
  };

  const Reached& cheapestAt(std::size_t cell) const {
    return *std::ranges::min_element(reached_[cell], {}, &Reached::cost);
  }

  void goOn(std::size_t cell, const Reached& before, std::size_t timebase, bool begins) {
    if (!(before.cost < std::numeric_limits<double>::infinity())) return;
    const auto unit = static_cast<std::size_t>(snippetUnits[timebase]);
    const bool mayRamp = !begins && !onsetAt(cell);
    for (int units = 1; units <= mostUnits; ++units) {
      const std::size_t end = cell + static_cast<std::size_t>(units) * unit;
      if (end > nextOnset_[cell] && nextOnset_[cell] < cells_) break;
      offer(cell, before, timebase, begins, flat(cell, end, units));
      if (mayRamp) offer(cell, before, timebase, begins, ramp(cell, end, units, before.point.level));
      if (end >= cells_) break;
    }
  }
  bool onsetAt(std::size_t cell) const { return cell > 0 && nextOnset_[cell - 1] == cell; }

  struct Piece {
    SnippetPoint point;
    double error = 0;
  };
  Sums within(std::size_t from, std::size_t to) const {
    return {sums_[to].levels - sums_[from].levels, sums_[to].byPlace - sums_[from].byPlace,
            sums_[to].squares - sums_[from].squares};
  }
  static int levelNear(double level) {
    return std::clamp(static_cast<int>(std::lround(level)), 0, snippetLevels);
  }
  Piece flat(std::size_t from, std::size_t to, int units) const {
    const Sums sums = within(from, to);
    const double count = static_cast<double>(to - from);
    const int level = levelNear(sums.levels / count);
    return {{false, units, level}, sums.squares - 2 * level * sums.levels + level * level * count};
  }
  /// A linear ramp from level `start`, by least squares over the cells' middles.
  Piece ramp(std::size_t from, std::size_t to, int units, int start) const {
    const Sums sums = within(from, to);
    const double count = static_cast<double>(to - from);
    const double above = sums.squares - 2 * start * sums.levels + start * start * count;
    const double alongIt =
        (sums.byPlace - static_cast<double>(from) * sums.levels) / count - start * count / 2;
    const double ofIt = count / 3 - 1 / (12 * count);
    const int level = levelNear(start + alongIt / ofIt);
    const double rise = level - start;
    return {{true, units, level}, above - 2 * rise * alongIt + rise * rise * ofIt};
  }

  void offer(std::size_t from, const Reached& before, std::size_t timebase, bool begins, const Piece& piece) {
    const std::size_t end = from + static_cast<std::size_t>(piece.point.units * snippetUnits[timebase]);
    Reached& best = reached_[std::min(end, cells_)][timebase];
    const double cost = before.cost + piece.error + perByte_ * (begins ? 3 : 1);
    if (cost >= best.cost) return;
    best = {cost, piece.point,    begins, timebase, before.points + 1, before.snippets + (begins ? 1 : 0),
            from, before.timebase};
  }

  std::size_t cells_;
  double perByte_;
  std::vector<std::size_t> nextOnset_;  // next onset after each cell; cells_ if there is none
  std::vector<std::array<Reached, snippetUnits.size()>> reached_;
  std::vector<Sums> sums_;  // sums over the cells before each one
};

using Rows = std::array<SnippetRow, 2>;

bool fits(const Rows& rows) {
  std::size_t bytes = 0, snippets = 0;
  for (const SnippetRow& row : rows)
    for (const Snippet& snippet : row.snippets)
      bytes += snippet.points.size() + (++snippets > shortFrames ? 3 : 2);
  return bytes <= freeBytes && snippets <= mostSnippets;
}

/// Rows reduced to each one's share of the memory.
Rows cutToShares(const std::array<CheapestPoints, 2>& halves) {
  Rows rows;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const CheapestPoints &own = halves[i], &other = halves[1 - i];
    const auto share = [](std::size_t all, std::size_t othersNeed) {
      return std::max(all / 2, all - std::min(all, othersNeed));
    };
    const std::size_t bytes = share(freeBytes, other.mostBytesAt(other.cells()));
    const std::size_t snippets = share(mostSnippets, other.snippetsAt(other.cells()));
    std::size_t cell = own.cells();
    while (cell > 0 && (own.mostBytesAt(cell) > bytes || own.snippetsAt(cell) > snippets)) --cell;
    rows[i] = own.upTo(cell);
  }
  return rows;
}

}  // namespace

std::array<SnippetRow, 2> snippetsOf(const std::array<LevelPath, 2>& halves) {
  const auto at = [&halves](double perByte) {
    return std::array{CheapestPoints(halves[0], perByte), CheapestPoints(halves[1], perByte)};
  };
  const auto whole = [](const std::array<CheapestPoints, 2>& plans) {
    return Rows{plans[0].upTo(plans[0].cells()), plans[1].upTo(plans[1].cells())};
  };
  Rows best = whole(at(cheapest));
  if (fits(best)) return best;
  const std::array<CheapestPoints, 2> coarsest = at(dearest);
  best = whole(coarsest);
  if (!fits(best)) return cutToShares(coarsest);
  double low = std::log(cheapest), high = std::log(dearest);
  for (int i = 0; i < halvings; ++i) {
    const double middle = (low + high) / 2;
    Rows rows = whole(at(std::exp(middle)));
    const bool fit = fits(rows);
    (fit ? high : low) = middle;
    if (fit) best = std::move(rows);
  }
  return best;
}

std::array<int, snippetMemoryBytes> memoryOf(const std::array<SnippetRow, 2>& rows) {
  DETENT_CHECK(fits(rows), "rows that the memory holds");
  std::array<int, snippetMemoryBytes> memory{};
  std::size_t snippets = 0;
  for (const SnippetRow& row : rows) snippets += row.snippets.size();
  memory[0] = static_cast<int>(snippets);
  memory[1] = static_cast<int>(rows.size());
  std::size_t pointer = 2, at = 2 + snippets + rows.size();
  for (const SnippetRow& row : rows) {
    for (const Snippet& snippet : row.snippets) {
      for (const SnippetPoint& point : snippet.points)
        memory[at++] = (point.ramp ? 0x80 : 0) | (point.units - 1) << 4 | point.level;
      memory[pointer++] = static_cast<int>(at - 1);
    }
  }
  std::size_t number = 0;
  for (const SnippetRow& row : rows) {
    for (const Snippet& snippet : row.snippets) {
      ++number;  // sequence 0 is silence in the chip
      memory[at++] = static_cast<int>(snippet.timebase << 3 | (number & 7));
      if (number > shortFrames) memory[at++] = 0x81;  // sent once; sets the fourth bit of the number
    }
    memory[pointer++] = static_cast<int>(at - 1);
  }
  return memory;
}

}  // namespace detent::playback
