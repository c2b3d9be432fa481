// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/progression.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "importer/axes/snapped_lines.h"
#include "importer/page/quantile.h"

namespace detent::importer {
namespace {

constexpr double agree_px = 1.6;  // a tick may be rounded to a whole pixel at either end
// pictures that were scaled without smoothing have unevenly spaced grids
constexpr double agreeOfPitch = 0.035;

/// The largest unit of which all decimal numbers are multiples: that of their last printed digit.
double lastDigitOf(const std::vector<double>& values) {
  double scale = 1;
  const auto whole = [&](double v) { return std::abs(v * scale - std::round(v * scale)) < 1e-6; };
  while (scale < 1e6 && !std::all_of(values.begin(), values.end(), whole)) scale *= 10;
  return 1 / scale;
}

/// Greatest common divisor of the differences of decimal numbers; 0 if all are equal.
double exactStep(const std::vector<double>& values) {
  const double lastDigit = lastDigitOf(values);
  long long step = 0;
  for (const double v : values) step = std::gcd(step, std::llround((v - values.front()) / lastDigit));
  return static_cast<double>(std::abs(step)) * lastDigit;
}

/// The common step of at least five values of which each may be off by the rounding of its last digit: a
/// program that divides an axis evenly prints 0.2137, 0.4273, 0.6410. 0 if there is no such step.
double roundedStep(std::vector<double> values) {
  constexpr std::size_t fewest = 5;
  // least step, in units of the last digit: smaller steps fit many values by chance
  constexpr double leastDigits = 10;
  if (values.size() < fewest) return 0;
  const double lastDigit = lastDigitOf(values);
  std::ranges::sort(values);
  const double step = (values.back() - values.front()) / static_cast<double>(values.size() - 1);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::abs(values[i] - values.front() - static_cast<double>(i) * step) > 1.001 * lastDigit) return 0;
  return step >= leastDigits * lastDigit ? step : 0;
}

/// Common step of decimal numbers; 0 if all are equal.
double commonStep(const std::vector<double>& values) {
  return std::max(exactStep(values), roundedStep(values));
}

/// Prior for a step: 1, 2, 2.5, 4 or 5 × 10^k are usual on axes; others are rarer.
double niceness(double step) {
  const double m = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
  for (const double nice : {1.0, 2.0, 5.0, 10.0})
    if (std::abs(m - nice) < 1e-3 * nice) return 1;
  for (const double fair : {2.5, 4.0, 3.0, 6.0, 8.0, 1.5, 1.2})
    if (std::abs(m - fair) < 1e-3 * fair) return 0.9;
  return 0.6;
}

/// Share of the values between the first and the last one that are present.
double completeness(const std::vector<double>& values, double step) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return static_cast<double>(values.size()) / ((*high - *low) / step + 1);
}

struct Trial {
  double offset = 0, perPx = 0, weight = 0;
  std::vector<int> reading;
};

struct Places {
  std::vector<double> at;  ///< position of each label: of its tick, or its centre
  std::vector<bool> hasTick;
  double agree = agree_px;  ///< tolerance of a label's tick against the progression
};

Places placesOf(const std::vector<LabelPlace>& labels, const std::vector<GridLine>& ticks) {
  Places positions;
  for (const auto& label : labels) {
    const GridLine* tick = nullptr;
    const auto nearer = [&](const GridLine& t) {
      const double off = std::abs(t.position_px - label.center_px);
      if (off > label.reach_px) return false;
      if (tick == nullptr || t.spansFrame != tick->spansFrame) return tick == nullptr || t.spansFrame;
      return off < std::abs(tick->position_px - label.center_px);
    };
    for (const auto& t : ticks)
      if (nearer(t)) tick = &t;
    const double at = tick != nullptr ? tick->position_px : label.center_px;
    const bool has = tick != nullptr;
    positions.at.push_back(at);
    positions.hasTick.push_back(has);
  }
  std::vector<double> apart;
  for (std::size_t i = 1; i < positions.at.size(); ++i)
    apart.push_back(std::abs(positions.at[i] - positions.at[i - 1]));
  if (!apart.empty()) positions.agree = std::max(agree_px, agreeOfPitch * medianOf(std::move(apart)));
  return positions;
}

Trial countAgreeing(const std::vector<LabelPlace>& labels, const Places& positions, double offset,
                    double perPx) {
  Trial trial{offset, perPx, 0, std::vector<int>(labels.size(), -1)};
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const double tolerance =
        (positions.hasTick[i] ? positions.agree : std::max(positions.agree, 0.8 * labels[i].reach_px)) *
        std::abs(perPx);
    double best = 0;
    for (std::size_t k = 0; k < labels[i].readings.size(); ++k) {
      const auto& r = labels[i].readings[k];
      if (std::abs(offset + perPx * positions.at[i] - r.value) > tolerance || r.weight <= best) continue;
      best = r.weight;
      trial.reading[i] = static_cast<int>(k);
    }
    // A label without a tick (the zero in the corner) may stand anywhere near its place, so it counts half.
    trial.weight += positions.hasTick[i] ? best : 0.5 * best;
  }
  return trial;
}

int agreeingTicks(const Trial& t) {
  return static_cast<int>(std::count_if(t.reading.begin(), t.reading.end(), [](int k) { return k >= 0; }));
}

std::vector<double> agreedValues(const std::vector<LabelPlace>& labels, const Trial& t) {
  std::vector<double> values;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (t.reading[i] >= 0) values.push_back(labels[i].readings[static_cast<std::size_t>(t.reading[i])].value);
  return values;
}

std::optional<Trial> bestTrial(const std::vector<LabelPlace>& labels, const Places& positions, bool rising) {
  std::optional<Trial> best;
  double bestScore = 0;
  for (std::size_t i = 0; i < labels.size(); ++i)
    for (std::size_t j = i + 1; j < labels.size(); ++j) {
      const double apart = positions.at[j] - positions.at[i];
      if (std::abs(apart) < 4) continue;
      for (const auto& a : labels[i].readings)
        for (const auto& b : labels[j].readings) {
          const double perPx = (b.value - a.value) / apart;
          if (rising ? perPx <= 0 : perPx >= 0) continue;
          auto trial = countAgreeing(labels, positions, a.value - perPx * positions.at[i], perPx);
          if (agreeingTicks(trial) < 2) continue;
          const auto values = agreedValues(labels, trial);
          const double step = commonStep(values);
          if (!(step > 0)) continue;
          const double score = trial.weight + 0.8 * niceness(step) + 0.8 * completeness(values, step);
          if (score <= bestScore + 1e-9) continue;
          bestScore = score;
          best = std::move(trial);
        }
    }
  return best;
}

/// Removes a reading that alone requires a much finer step than all the others: it is a misreading that fits
/// by chance. A repaired reading ("198" as 19.8 near 20) is removed sooner than one read as it stands (a zero
/// and its tick as 0.4).
void dropStrayReadings(const std::vector<LabelPlace>& labels, Trial& t) {
  constexpr double finerIfRepaired = 4, finerAsRead = 20;  // times
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (t.reading[i] < 0) continue;
    const bool repaired = labels[i].readings[static_cast<std::size_t>(t.reading[i])].weight < 1;
    const double muchFiner = repaired ? finerIfRepaired : finerAsRead;
    Trial others = t;
    others.reading[i] = -1;
    if (agreeingTicks(others) < 3) continue;
    if (exactStep(agreedValues(labels, others)) >= muchFiner * exactStep(agreedValues(labels, t))) t = others;
  }
}

/// Lines at multiples of a step, with their deviations in pixels.
struct OnStep {
  std::vector<std::pair<double, double>> pairs;  // position, value
  double step = 0;
};

OnStep linesOnStep(const std::vector<GridLine>& ticks, const Progression& p, double step, double origin) {
  OnStep on{{}, step};
  const double step_px = step / std::abs(p.perPx);
  const double tolerance = std::min(agree_px, 0.2 * step_px);
  for (const auto& line : ticks) {
    const double t = line.position_px;
    const double v = origin + std::round((p.value(t) - origin) / step) * step;
    const double off = std::abs(p.position(v) - t);
    if (off > tolerance) continue;
    if (!on.pairs.empty() && std::abs(on.pairs.back().second - v) < 0.5 * step) {
      // Two lines for one value: the one that fits better is kept.
      if (off < std::abs(p.position(v) - on.pairs.back().first)) on.pairs.back().first = t;
      continue;
    }
    on.pairs.emplace_back(t, v);
  }
  return on;
}

/// Number of lines that a grid with this step has between its outermost ones.
double expectedLines(const OnStep& on) {
  if (on.pairs.size() < 2) return 0;
  double low = on.pairs.front().second, high = low;
  for (const auto& [x, v] : on.pairs) {
    low = std::min(low, v);
    high = std::max(high, v);
  }
  return (high - low) / on.step + 1;
}

/// The coarsest subdivision that explains the lines. A finer one must be nearly complete and add more than
/// chance could: strokes of letters and leaders stand anywhere.
OnStep chosenSubdivision(const std::vector<GridLine>& ticks, const Progression& p, double origin) {
  OnStep best = linesOnStep(ticks, p, p.step, origin);
  for (const double divide : {2.0, 4.0, 5.0, 10.0, 20.0}) {
    if (p.step / divide / std::abs(p.perPx) < 5) break;
    auto finer = linesOnStep(ticks, p, p.step / divide, origin);
    const auto found = static_cast<double>(finer.pairs.size());
    if (found < 0.8 * expectedLines(finer)) continue;
    if (finer.pairs.size() >= best.pairs.size() + std::max<std::size_t>(2, best.pairs.size() / 3))
      best = std::move(finer);
  }
  return best;
}

void fitLine(const std::vector<std::pair<double, double>>& pairs, Progression& p) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (const auto& [x, v] : pairs) {
    n += 1;
    sx += x;
    sy += v;
    sxx += x * x;
    sxy += x * v;
  }
  const double det = n * sxx - sx * sx;
  if (!(det > 0)) return;
  p.perPx = (n * sxy - sx * sy) / det;
  p.offset = (sy - p.perPx * sx) / n;
  double sum = 0;
  for (const auto& [x, v] : pairs) sum += std::pow(p.position(v) - x, 2);
  p.residual_px = std::sqrt(sum / n);
}

/// Least squares, repeated without lines that a neighbouring mark has displaced.
void fitLineRobustly(std::vector<std::pair<double, double>> pairs, Progression& p) {
  fitLine(pairs, p);
  for (int round = 0; round < 3 && pairs.size() > 3; ++round) {
    std::vector<double> off;
    for (const auto& [x, v] : pairs) off.push_back(std::abs(p.position(v) - x));
    const double bar = std::max(0.55, 3 * medianOf(off));
    const auto worst = std::max_element(off.begin(), off.end());
    if (*worst <= bar) break;
    pairs.erase(pairs.begin() + (worst - off.begin()));
    fitLine(pairs, p);
  }
  p.ticks = static_cast<int>(pairs.size());
  if (const auto line = throughRoundedLines(pairs)) {
    p.offset = line->offset;
    p.perPx = line->perPx;
    double sum = 0;
    for (const auto& [x, v] : pairs) sum += std::pow(p.position(v) - x, 2);
    p.residual_px = std::sqrt(sum / static_cast<double>(pairs.size()));
  }
}

/// Positions and values of the labels that agree.
std::vector<std::pair<double, double>> centresOf(const std::vector<LabelPlace>& labels,
                                                 const Progression& p) {
  std::vector<std::pair<double, double>> centres;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (p.reading[i] >= 0)
      centres.emplace_back(labels[i].center_px,
                           labels[i].readings[static_cast<std::size_t>(p.reading[i])].value);
  return centres;
}

/// Scatter of the labels' distances from the positions of their values. If all are shifted equally, it is 0.
double unevenness_px(const std::vector<std::pair<double, double>>& centres, const Progression& p) {
  double sum = 0, squares = 0;
  for (const auto& [x, v] : centres) sum += p.position(v) - x, squares += std::pow(p.position(v) - x, 2);
  const double n = static_cast<double>(centres.size());
  return std::sqrt(std::max(0.0, squares / n - std::pow(sum / n, 2)));
}

/// Handles a row of evenly spaced labels of which only few have a line within reach. If the scale through
/// those lines does not fit the row, one of the lines belongs to a curve or a leader; the scale of the row is
/// returned then.
std::optional<Progression> scaleOfRow(const std::vector<LabelPlace>& labels, const Progression& p,
                                      int withTick) {
  constexpr int fewest = 5;
  constexpr double evenWithin_px = 0.5, clearly = 3;  // times as uneven
  if (p.labels < fewest || 2 * withTick >= p.labels) return {};
  const auto centres = centresOf(labels, p);
  Progression row = p;
  fitLine(centres, row);
  const double own_px = unevenness_px(centres, row);
  if (own_px > evenWithin_px || unevenness_px(centres, p) < clearly * std::max(own_px, evenWithin_px))
    return {};
  return row;
}

}  // namespace

std::optional<Progression> fitProgression(const std::vector<LabelPlace>& labels,
                                          const std::vector<GridLine>& ticks, bool rising) {
  const Places positions = placesOf(labels, ticks);
  auto trial = bestTrial(labels, positions, rising);
  if (!trial) return std::nullopt;
  dropStrayReadings(labels, *trial);
  Progression p;
  p.offset = trial->offset;
  p.perPx = trial->perPx;
  p.reading = trial->reading;
  p.tickOf = positions.at;
  p.agree_px = positions.agree;
  p.labels = agreeingTicks(*trial);
  const auto values = agreedValues(labels, *trial);
  p.step = commonStep(values);
  p.substep = p.step;

  std::vector<std::pair<double, double>> labelled;
  int withTick = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (p.reading[i] < 0) continue;
    withTick += positions.hasTick[i];
    if (positions.hasTick[i])
      labelled.emplace_back(positions.at[i],
                            labels[i].readings[static_cast<std::size_t>(p.reading[i])].value);
  }
  if (withTick < 2) {
    labelled.clear();
    for (std::size_t i = 0; i < labels.size(); ++i)
      if (p.reading[i] >= 0)
        labelled.emplace_back(positions.at[i],
                              labels[i].readings[static_cast<std::size_t>(p.reading[i])].value);
    fitLine(labelled, p);
    p.ticks = static_cast<int>(labelled.size());
    return p;
  }
  p.fromTicks = true;
  fitLine(labelled, p);
  const auto row = scaleOfRow(labels, p, withTick);
  if (row) p = *row;
  const auto on = chosenSubdivision(ticks, p, values.front());
  if (row && on.pairs.size() < 2) {
    p.fromTicks = false;
    p.ticks = p.labels;
    return p;
  }
  p.substep = on.step;
  auto pairs = row || on.pairs.size() >= labelled.size() ? on.pairs : labelled;
  fitLineRobustly(std::move(pairs), p);
  return p;
}

}  // namespace detent::importer
