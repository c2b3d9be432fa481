// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/uneven_scale.h"

#include <algorithm>
#include <cmath>

#include "importer/axes/printed_number.h"

namespace detent::importer {
namespace {

/// Largest distance of points from their least-squares line, as a share of the values' span.
double offLine(const std::vector<std::pair<double, double>>& points) {
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& [at, value] : points) x += at, y += value, xx += at * at, xy += at * value;
  const auto n = static_cast<double>(points.size());
  const double slope = (n * xy - x * y) / (n * xx - x * x), start = (y - slope * x) / n;
  double most = 0;
  for (const auto& [at, value] : points) most = std::max(most, std::abs(start + slope * at - value));
  const double span = std::abs(points.back().second - points.front().second);
  return span > 0 ? most / span : 0;
}

/// Returns true if each label has a place and a value of its own, and the values only rise or only fall.
bool isInOrder(const std::vector<std::pair<double, double>>& labels) {
  const bool rises = labels.back().second > labels.front().second;
  for (std::size_t i = 1; i < labels.size(); ++i)
    if (labels[i].first == labels[i - 1].first || labels[i].second == labels[i - 1].second ||
        (labels[i].second > labels[i - 1].second) != rises)
      return false;
  return true;
}

/// Least difference between the values of neighbours.
double stepOf(const std::vector<std::pair<double, double>>& labels) {
  double step = HUGE_VAL;
  for (std::size_t i = 1; i < labels.size(); ++i)
    step = std::min(step, std::abs(labels[i].second - labels[i - 1].second));
  return step;
}

// largest deviation from one line that may be due to places, as a share of the span
constexpr double fits = 0.03;
constexpr std::size_t fewestOfUneven = 5;  // labels: some three of any four nearly fit a line

/// The labels in order of their places, without the zero in the corner that belongs to the other axis as
/// well.
std::vector<std::pair<double, double>> withoutCorner(std::vector<std::pair<double, double>> labels) {
  constexpr std::size_t fewest = 4;
  std::ranges::sort(labels);
  if (labels.size() > fewest && labels.back().second == labels[labels.size() - 2].second) labels.pop_back();
  if (labels.size() > fewest && labels.front().second == labels[1].second) labels.erase(labels.begin());
  return labels;
}

/// Returns true if at most one label is off the line of the others: misread, or beside its tick as the zero
/// in a corner is.
bool fitsButForOne(const std::vector<std::pair<double, double>>& labels) {
  for (std::size_t i = 0; i < labels.size(); ++i) {
    auto others = labels;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    if (offLine(others) <= fits) return true;
  }
  return false;
}

/// Returns true if the labels are two even scales of one step, one behind the other.
bool isBroken(const std::vector<std::pair<double, double>>& labels) {
  constexpr double nearStep = 0.01;  // share of the step
  constexpr double straighter =
      0.25;  // deviation of each run, of the whole; halves of an arc have half of it
  if (labels.size() < fewestOfUneven || fitsButForOne(labels)) return false;
  const double whole = offLine(labels), step = stepOf(labels);
  for (std::size_t i = 1; i < labels.size(); ++i) {
    const double steps = (labels[i].second - labels[i - 1].second) / step;
    if (std::abs(steps - std::round(steps)) > nearStep) return false;
  }
  const auto isEven = [&](const std::vector<std::pair<double, double>>& run) {
    return std::round(stepOf(run) / step) == 1 && offLine(run) <= straighter * whole;
  };
  for (std::size_t split = 2; split + 2 <= labels.size(); ++split) {
    const auto at = labels.begin() + static_cast<std::ptrdiff_t>(split);
    if (isEven({labels.begin(), at}) && isEven({at, labels.end()})) return true;
  }
  return false;
}

}  // namespace

std::string unevenScaleOf(std::vector<std::pair<double, double>> labels) {
  constexpr std::size_t fewest = 4;  // labels
  constexpr double isLinear = 0.06,
                   leastRatio = 5;  // of the span; ratio of the largest to the smallest value
  labels = withoutCorner(std::move(labels));
  if (labels.size() < fewest || labels.front().first == labels.back().first) return {};
  if (!isInOrder(labels)) {  // a value was misread, perhaps with the signs of a break
    const std::pair<double, double> ends = std::minmax(labels.front().second, labels.back().second);
    std::erase_if(labels, [ends](const auto& label) {
      return label.second < ends.first || label.second > ends.second;
    });
    return isInOrder(labels) && isBroken(labels) ? brokenScale : "";
  }
  const auto [low, high] = std::minmax(labels.front().second, labels.back().second);
  const bool uneven = offLine(labels) > isLinear;
  if (uneven && low > 0 && high >= leastRatio * low) {
    std::vector<std::pair<double, double>> logarithms = labels;
    for (auto& [at, value] : logarithms) value = std::log10(value);
    if (offLine(logarithms) <= fits) return logarithmicScale;
  }
  std::vector<std::pair<double, double>> steps;
  for (const auto& [at, value] : labels) steps.emplace_back(static_cast<double>(steps.size()), at);
  if (uneven && offLine(steps) <= fits) return categoriesScale;
  return isBroken(labels) ? brokenScale : "";
}

bool isLogarithmic(const std::vector<GridLine>& lines) {
  // tolerance as a share of a decade (ninths of a linear scale deviate by 0.07), and in px
  constexpr double near = 0.012, near_px = 1;
  // lines between two powers of ten; number of them that may be missing
  constexpr std::size_t between = 8, lost = 1;
  std::vector<double> at;
  for (const GridLine& line : lines) at.push_back(line.position_px);
  std::ranges::sort(at);
  for (std::size_t first = 0; first < at.size(); ++first)
    for (std::size_t last = first + between - lost + 1; last < std::min(at.size(), first + between + 3);
         ++last) {
      const double length_px = at[last] - at[first];
      int rising = 0, falling = 0;
      for (std::size_t i = first + 1; i < last; ++i) {
        const auto isOne = [&](double share) {
          const double digit = std::round(std::pow(10.0, share));
          return digit >= 2 && digit <= 9 &&
                 std::abs(share - std::log10(digit)) * length_px <= std::max(near_px, near * length_px);
        };
        const double share = (at[i] - at[first]) / length_px;
        rising += isOne(share), falling += isOne(1 - share);
      }
      if (std::max(rising, falling) >= static_cast<int>(between - lost)) return true;
    }
  return false;
}

std::string unevenRowIn(const AxisLabels& labels, Axis axis) {
  constexpr int mostDoubtful = 1, fewestAside = 2;  // labels; one label aside is a misprint or was misread
  std::vector<std::pair<double, double>> row;
  int doubtful = 0, aside = 0;
  for (std::size_t i = 0; i < labels.words.size(); ++i) {
    if (labels.readings[i].empty()) continue;
    const int used = labels.progression ? labels.progression->reading[i] : -1;
    const Point middle = labels.words[i].box.middle();
    row.emplace_back(axis == Axis::x ? middle.x : middle.y,
                     labels.readings[i][static_cast<std::size_t>(std::max(0, used))].value);
    doubtful += labels.words[i].confidence < readWithCertainty, aside += used < 0;
  }
  row = withoutCorner(std::move(row));
  if (row.size() < fewestOfUneven || doubtful > mostDoubtful || aside < fewestAside) return {};
  return unevenScaleOf(row) == categoriesScale && !fitsButForOne(row) ? categoriesScale : "";
}

bool isUnevenBetween(const AxisLabels& labels, const std::pair<double, double>& first,
                     const std::pair<double, double>& last) {
  constexpr double atEnd = 0.02, sameValue = 0.005;  // shares of the axis' length, and of its span
  constexpr double mostRatio = 2;  // of two steps: digits that were lost or misread change it by more
  constexpr int fewest = 3;        // labels of the scale that the ends contradict
  if (!labels.progression) return false;
  const Progression& p = *labels.progression;
  const double length_px = std::abs(last.first - first.first), span = std::abs(last.second - first.second);
  const auto isPrintedAt = [&](std::size_t i, const std::pair<double, double>& end) {
    return std::abs(p.tickOf[i] - end.first) <= atEnd * length_px &&
           std::ranges::any_of(labels.readings[i], [&](const NumberReading& reading) {
             return std::abs(reading.value - end.second) <= sameValue * span;
           });
  };
  bool atFirst = false, atLast = false;
  int sure = 0;
  for (std::size_t i = 0; i < labels.words.size(); ++i) {
    const bool isFirst = isPrintedAt(i, first), isLast = isPrintedAt(i, last);
    atFirst = atFirst || isFirst, atLast = atLast || isLast;
    sure += p.reading[i] >= 0 && (isFirst || isLast || labels.words[i].confidence >= readWithCertainty);
  }
  const double ratio = std::abs(p.perPx) * length_px / span;
  const double off =
      std::max(std::abs(p.value(first.first) - first.second), std::abs(p.value(last.first) - last.second));
  return atFirst && atLast && sure >= fewest && off > fits * span && ratio < mostRatio &&
         mostRatio * ratio > 1;
}

std::string unevenScaleIn(const AxisLabels& labels, Axis axis) {
  std::vector<std::pair<double, double>> certain, all;
  for (std::size_t i = 0; i < labels.words.size(); ++i) {
    if (labels.readings[i].empty()) continue;
    const Point middle = labels.words[i].box.middle();
    all.emplace_back(axis == Axis::x ? middle.x : middle.y, labels.readings[i].front().value);
    if (labels.words[i].confidence >= readWithCertainty) certain.push_back(all.back());
  }
  std::string scale = unevenScaleOf(std::move(certain));
  if (!scale.empty()) return scale;
  // Two runs of one step confirm the labels that were read with doubt.
  return unevenScaleOf(std::move(all)) == brokenScale ? brokenScale : unevenRowIn(labels, axis);
}

}  // namespace detent::importer
