// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/small_labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <limits>
#include <map>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "importer/axes/drawn_text.h"
#include "importer/page/quantile.h"

namespace detent::importer {
namespace {

constexpr std::size_t fewestLabels = 3, mostLabels = 12;

/// A scale the labels may stand on: value of each, and how usual it is.
struct Scale {
  std::vector<std::string> texts;
  double prior = 0;             ///< nats, <= 0
  double step = 0, lowest = 0;  ///< from label to label, and the smallest value

  /// Zeros behind the point or none: the same numbers.
  bool sameValues(const Scale& other) const { return step == other.step && lowest == other.lowest; }
};

std::string written(double value, int decimals) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

/// Without zeros behind the point.
std::string shortened(std::string text) {
  if (text.find('.') == std::string::npos) return text;
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

/// Places as whole steps from the first; empty if they are not even.
std::vector<int> evenSteps(const std::vector<double>& centers_px) {
  constexpr double evenWithin = 0.15;  // of a step
  double pitch = std::numeric_limits<double>::max();
  for (std::size_t i = 1; i < centers_px.size(); ++i)
    pitch = std::min(pitch, centers_px[i] - centers_px[i - 1]);
  if (!(pitch > 4)) return {};
  for (int round = 0; round < 2; ++round)  // the smallest gap is off by a pixel, all together are not
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

/// All scales of nice steps from zero or a multiple of the step.
std::vector<Scale> scalesOf(std::vector<int> steps, bool rising) {
  struct Mantissa {
    double value, prior;
    int decimals;
  };
  constexpr std::array mantissas{Mantissa{1, 0, 0},    Mantissa{2, 0, 0},    Mantissa{5, 0, 0},
                                 Mantissa{2.5, -1, 1}, Mantissa{4, -2, 0},   Mantissa{3, -2, 0},
                                 Mantissa{1.5, -2, 1}, Mantissa{6, -3, 0},   Mantissa{8, -3, 0},
                                 Mantissa{1.2, -3, 1}, Mantissa{1.25, -3, 2}};
  constexpr double notFromZero = -2,
                   zerosBehind = -0.5;  // nats: axes begin at 0, and no two zeros follow a point
  constexpr int furthestStart = 12;
  if (!rising)
    for (int& k : steps) k = -k;
  const int lowest = *std::min_element(steps.begin(), steps.end());
  std::vector<Scale> scales;
  for (const Mantissa& m : mantissas)
    for (int power = -2; power <= 3; ++power) {
      const double step = m.value * std::pow(10.0, power);
      const int decimals = std::max(0, m.decimals - power);
      if (decimals > 3) continue;
      for (int start = 0; start <= furthestStart; ++start) {
        Scale even, plain;
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

/// The labels' pixels and boxes.
struct Row {
  const std::vector<cv::Mat>& patches;
  const std::vector<Box>& words;
};

/// Labels held against numbers of one hand; each comparison is made once.
class Comparison {
 public:
  Comparison(const Row& row, const Hand& hand)
      : row_(row), hand_(hand), drawn_(hand), seen_(row.words.size()) {}

  /// Whether every word is about as wide as its text would be.
  bool fits(const std::vector<std::string>& texts) const {
    for (std::size_t i = 0; i < texts.size(); ++i)
      if (!fits(row_.words[i].width(), texts[i])) return false;
    return true;
  }

  double likeness(std::size_t label, const std::string& text) {
    const auto [at, fresh] = seen_[label].try_emplace(text, -1.0);
    if (fresh) at->second = drawn_.likeness(row_.patches[label], text);
    return at->second;
  }

 private:
  /// Ink ends short of its advance, by more where a one stands; smoothing makes it wider.
  bool fits(double width_px, const std::string& text) const {
    constexpr double bearing = 0.15, besideOne = 0.35, halo_px = 1.5,
                     hands_share = 0.07;  // both of a digit's advance: white beside it, and more beside a 1
    const double wide_px = advancesOf(text) * hand_.advance_px;
    const double ones = (text.front() == '1') + (text.back() == '1');
    const double least = wide_px * (1 - hands_share) - (bearing + besideOne * ones) * hand_.advance_px - 1;
    return width_px >= least &&
           width_px <= wide_px * (1 + hands_share) - bearing * hand_.advance_px + halo_px;
  }

  const Row& row_;
  Hand hand_;
  DrawnText drawn_;
  std::vector<std::map<std::string, double>> seen_;
};

/// A scale, and how well the labels stand to it in the hand that suits it best.
struct Judged {
  const Scale* scale = nullptr;
  double score = -std::numeric_limits<double>::max();  ///< nats
  double likeness = -1;                                ///< of the least alike label
};

/// Nats of a label's pixels, noise and the difference of typefaces not known beforehand; what scaling and blur join is
/// counted once.
double natsOf(double likeness, const Box& word) {
  constexpr double independent = 0.25, most = 0.99;  // of the pixels; highest correlation that is believed
  const double pixels = independent * (word.width() + 2) * (word.height() + 2);
  const double r = std::clamp(likeness, 0.0, most);
  return -0.5 * pixels * std::log(1 - r * r);
}

/// Hands of these fonts, lower than the boxes by so much, of all common widths.
std::vector<Hand> handsOf(double box_px, std::initializer_list<int> fonts,
                          std::initializer_list<double> lower_px) {
  std::vector<Hand> hands;
  for (const int font : fonts)
    for (const double lower : lower_px)
      for (const double wide : {0.72, 0.80, 0.88, 1.0})
        hands.push_back({font, box_px - lower, wide * (box_px - lower)});
  return hands;
}

void judge(std::vector<Judged>& scales, const Row& row, const std::vector<Hand>& hands) {
  for (const Hand& hand : hands) {
    Comparison comparison(row, hand);
    for (Judged& judged : scales) {
      const std::vector<std::string>& texts = judged.scale->texts;
      if (!comparison.fits(texts)) continue;
      Judged now{judged.scale, judged.scale->prior, 1};
      for (std::size_t i = 0; i < texts.size(); ++i) {
        const double like = comparison.likeness(i, texts[i]);
        now.likeness = std::min(now.likeness, like);
        now.score += natsOf(like, row.words[i]);
      }
      if (now.score > judged.score) judged = now;
    }
  }
}

/// The likeliest few, likeliest first.
void keepBest(std::vector<Judged>& scales, std::size_t few) {
  std::erase_if(scales, [](const Judged& j) { return j.likeness < 0; });
  std::sort(scales.begin(), scales.end(), [](const Judged& a, const Judged& b) { return a.score > b.score; });
  if (scales.size() > few) scales.resize(few);
}

}  // namespace

std::optional<SmallLabels> readSmallLabels(const cv::Mat& darkness, const std::vector<Box>& words,
                                           const std::vector<double>& centers_px, bool rising) {
  constexpr double leastLike = 0.72, leastMargin = 4;  // correlation, nats
  if (words.size() < fewestLabels || words.size() > mostLabels) return {};
  const std::vector<int> steps = evenSteps(centers_px);
  if (steps.empty()) return {};
  std::vector<cv::Mat> patches;
  std::vector<double> heights;
  for (const Box& word : words) {
    patches.push_back(finePatch(darkness, word));
    if (patches.back().empty()) return {};
    heights.push_back(word.height());
  }
  const Row row{patches, words};
  const double height = medianOf(heights);
  const std::vector<Scale> scales = scalesOf(steps, rising);
  std::vector<Judged> judged;
  for (const Scale& scale : scales) judged.push_back({&scale});
  judge(judged, row, handsOf(height, {cv::FONT_HERSHEY_SIMPLEX}, {0.6}));
  keepBest(judged, 24);
  judge(judged, row, handsOf(height, {cv::FONT_HERSHEY_SIMPLEX, cv::FONT_HERSHEY_COMPLEX}, {0, 0.6, 1.2}));
  keepBest(judged, judged.size());
  if (judged.empty() || judged.front().likeness < leastLike) return {};
  const Judged& best = judged.front();
  const bool alone = std::none_of(judged.begin(), judged.end(), [&](const Judged& other) {
    return other.score > best.score - leastMargin && !other.scale->sameValues(*best.scale);
  });
  if (!alone) return {};
  return SmallLabels{best.scale->texts, best.likeness};
}

}  // namespace detent::importer
