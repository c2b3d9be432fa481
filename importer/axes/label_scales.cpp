// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/label_scales.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

namespace detent::importer {
namespace {

std::string written(double value, int decimals) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

/// The number's text without trailing zeros behind the decimal point.
std::string shortened(std::string text) {
  if (text.find('.') == std::string::npos) return text;
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace

std::vector<int> evenSteps(const std::vector<double>& centers_px) {
  constexpr double evenWithin = 0.15;  // share of a step
  double pitch = std::numeric_limits<double>::max();
  for (std::size_t i = 1; i < centers_px.size(); ++i)
    pitch = std::min(pitch, centers_px[i] - centers_px[i - 1]);
  if (!(pitch > 4)) return {};
  // the smallest gap may be off by a pixel; the mean of all gaps is more exact
  for (int round = 0; round < 2; ++round)
    pitch = (centers_px.back() - centers_px.front()) /
            std::max(1.0, std::round((centers_px.back() - centers_px.front()) / pitch));
  std::vector<int> steps;
  for (const double c : centers_px) {
    const double k = (c - centers_px.front()) / pitch;
    if (std::abs(k - std::round(k)) > evenWithin) return {};
    steps.push_back(static_cast<int>(std::lround(k)));
  }
  return steps;
}

std::vector<LabelScale> scalesOf(std::vector<int> steps, bool rising) {
  struct Mantissa {
    double value, prior;
    int decimals;
  };
  constexpr std::array mantissas{Mantissa{1, 0, 0},    Mantissa{2, 0, 0},    Mantissa{5, 0, 0},
                                 Mantissa{2.5, -1, 1}, Mantissa{4, -2, 0},   Mantissa{3, -2, 0},
                                 Mantissa{1.5, -2, 1}, Mantissa{6, -3, 0},   Mantissa{8, -3, 0},
                                 Mantissa{1.2, -3, 1}, Mantissa{1.25, -3, 2}};
  // nats: penalties for a scale that does not begin at 0, and for zeros behind the decimal point
  constexpr double notFromZero = -2, zerosBehind = -0.5;
  constexpr int furthestStart = 12;
  if (!rising)
    for (int& k : steps) k = -k;
  const int lowest = *std::min_element(steps.begin(), steps.end());
  std::vector<LabelScale> scales;
  for (const Mantissa& m : mantissas)
    for (int power = -2; power <= 3; ++power) {
      const double step = m.value * std::pow(10.0, power);
      const int decimals = std::max(0, m.decimals - power);
      if (decimals > 3) continue;
      for (int start = 0; start <= furthestStart; ++start) {
        LabelScale even, plain;
        even.prior = plain.prior = m.prior + (start > 0 ? notFromZero : 0);
        even.step = plain.step = step;
        even.lowest = plain.lowest = step * start;
        for (const int k : steps) {
          even.texts.push_back(written(step * (k - lowest + start), decimals));
          plain.texts.push_back(shortened(even.texts.back()));
        }
        if (plain.texts != even.texts) {
          even.prior += zerosBehind;
          scales.push_back(std::move(plain));
        }
        scales.push_back(std::move(even));
      }
    }
  return scales;
}

}  // namespace detent::importer
