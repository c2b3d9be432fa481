// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/small_labels.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <map>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "importer/axes/drawn_text.h"
#include "importer/axes/label_scales.h"
#include "importer/page/quantile.h"

namespace detent::importer {
namespace {

/// The labels' pixels and boxes.
struct Row {
  const std::vector<cv::Mat>& patches;
  const std::vector<Box>& words;
};

/// Compares labels with numbers drawn in one style; each comparison is made once.
class Comparison {
 public:
  Comparison(const Row& row, const Hand& hand)
      : row_(row), hand_(hand), drawn_(hand), seen_(row.words.size()) {}

  /// Returns true if every word is about as wide as its text would be in this style.
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
  /// Drawn pixels end before the advance does, by more for a one; antialiasing makes them wider.
  bool fits(double width_px, const std::string& text) const {
    constexpr double bearing = 0.15, besideOne = 0.35, halo_px = 1.5,
                     // shares of a digit's advance: space beside any digit, and additional space beside a 1
        hands_share = 0.07;
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

/// A scale and its agreement with the labels, in the style that fits best.
struct JudgedLabel {
  const LabelScale* scale = nullptr;
  double score = -std::numeric_limits<double>::max();  ///< nats
  double likeness = -1;                                ///< likeness of the label that agrees least
};

/// Evidence of a label's pixels in nats, allowing for noise and an unknown typeface. Pixels that scaling and
/// blur have correlated count once.
double natsOf(double likeness, const Box& word) {
  // share of the pixels that count as independent; highest correlation that counts
  constexpr double independent = 0.25, most = 0.99;
  const double pixels = independent * (word.width() + 2) * (word.height() + 2);
  const double r = std::clamp(likeness, 0.0, most);
  return -0.5 * pixels * std::log(1 - r * r);
}

/// Styles in these fonts of all usual widths, with a digit height a little below that of the boxes.
std::vector<Hand> labelFonts(double box_px, std::initializer_list<int> fonts,
                             std::initializer_list<double> lower_px) {
  std::vector<Hand> hands;
  for (const int font : fonts)
    for (const double lower : lower_px)
      for (const double widthRatio : {0.72, 0.80, 0.88, 1.0})
        hands.push_back({font, box_px - lower, widthRatio * (box_px - lower)});
  return hands;
}

void judge(std::vector<JudgedLabel>& scales, const Row& row, const std::vector<Hand>& hands) {
  for (const Hand& hand : hands) {
    Comparison comparison(row, hand);
    for (JudgedLabel& judged : scales) {
      const std::vector<std::string>& texts = judged.scale->texts;
      if (!comparison.fits(texts)) continue;
      JudgedLabel now{judged.scale, judged.scale->prior, 1};
      for (std::size_t i = 0; i < texts.size(); ++i) {
        const double like = comparison.likeness(i, texts[i]);
        now.likeness = std::min(now.likeness, like);
        now.score += natsOf(like, row.words[i]);
      }
      if (now.score > judged.score) judged = now;
    }
  }
}

/// Keeps the most likely scales, sorted by likelihood.
void keepBest(std::vector<JudgedLabel>& scales, std::size_t few) {
  std::erase_if(scales, [](const JudgedLabel& j) { return j.likeness < 0; });
  std::sort(scales.begin(), scales.end(),
            [](const JudgedLabel& a, const JudgedLabel& b) { return a.score > b.score; });
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
  const std::vector<LabelScale> scales = scalesOf(steps, rising);
  std::vector<JudgedLabel> judged;
  for (const LabelScale& scale : scales) judged.push_back({&scale});
  judge(judged, row, labelFonts(height, {cv::FONT_HERSHEY_SIMPLEX}, {0.6}));
  keepBest(judged, 24);
  judge(judged, row, labelFonts(height, {cv::FONT_HERSHEY_SIMPLEX, cv::FONT_HERSHEY_COMPLEX}, {0, 0.6, 1.2}));
  keepBest(judged, judged.size());
  if (judged.empty() || judged.front().likeness < leastLike) return {};
  const JudgedLabel& best = judged.front();
  const bool alone = std::none_of(judged.begin(), judged.end(), [&](const JudgedLabel& other) {
    return other.score > best.score - leastMargin && !other.scale->sameValues(*best.scale);
  });
  if (!alone) return {};
  return SmallLabels{best.scale->texts, best.likeness};
}

}  // namespace detent::importer
