// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/trace/plot_text.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "importer/page/pixel_components.h"

namespace detent::importer::trace {

namespace {

/// Mean length of a piece's shorter runs.
double strokeOf(const PixelComponent& piece) {
  return static_cast<double>(piece.area_px) / std::max(piece.runsDown, piece.runsAcross);
}

/// Contrast exceeded by the strongest twentieth of the pixels.
int strongContrast(const cv::Mat& contrast, int from) {
  std::array<int, 256> bins{};
  int n = 0;
  for (const std::uint8_t* p = contrast.datastart; p < contrast.dataend; ++p)
    if (*p >= from) {
      ++bins[*p];
      ++n;
    }
  int above = 0;
  for (int level = 255; level >= from; --level) {
    above += bins[static_cast<std::size_t>(level)];
    if (20 * above >= n) return level;
  }
  return from;
}

bool hasLetterShape(const PixelComponent& piece, const Box& frame) {
  const double height = piece.box.height(), width = piece.box.width();
  return height >= 5 && height <= 0.14 * frame.height() && width <= 4 * height &&
         width <= 0.2 * frame.width() && height >= 2.2 * strokeOf(piece);
}

/// Returns true for touching letters: a wide low piece, busy in both directions. A stretch of a curve is
/// crossed about once per column.
bool hasWordShape(const PixelComponent& piece, const Box& frame) {
  const double height = piece.box.height(), width = piece.box.width();
  return height >= 6 && height <= 0.14 * frame.height() && width >= 1.8 * height &&
         width <= 0.7 * frame.width() && piece.runsDown >= 1.3 * width && piece.runsAcross >= 0.8 * width;
}

double overlap(double a0, double a1, double b0, double b1) { return std::min(a1, b1) - std::max(a0, b0); }

bool standInOneRow(const Box& left, const Box& right) {
  const double small = std::min(left.height(), right.height()),
               tall = std::max(left.height(), right.height());
  const double gap = right.x0 - left.x1;
  return tall <= 2.3 * small && overlap(left.y0, left.y1, right.y0, right.y1) >= 0.55 * small &&
         gap <= 0.8 * tall && gap >= -0.5 * small;
}

/// Chains letters from left to right. Three in a row are text.
std::vector<std::vector<std::size_t>> letterRows(const std::vector<PixelComponent>& pieces,
                                                 const std::vector<std::size_t>& order) {
  std::vector<std::vector<std::size_t>> rows;
  for (std::size_t i : order) {
    std::vector<std::size_t>* home = nullptr;
    for (auto row = rows.rbegin(); row != rows.rend() && !home; ++row) {
      // The last letters of a row, because an 'i' dot or a comma may stand between.
      for (std::size_t back = 0; back < std::min<std::size_t>(3, row->size()) && !home; ++back)
        if (standInOneRow(pieces[(*row)[row->size() - 1 - back]].box, pieces[i].box)) home = &*row;
    }
    if (home)
      home->push_back(i);
    else
      rows.push_back({i});
  }
  return rows;
}

bool mostlyInside(const Box& piece, const Box& word) {
  const Box common = piece.common(word);
  return !common.empty() && common.area() >= 0.8 * piece.area();
}

/// Marks letters among the pieces darker than `threshold` on `mask` and adds their rows.
void markLetters(const cv::Mat& contrast, int threshold, const Box& frame, const std::vector<Box>& words,
                 std::vector<Box>& rows, cv::Mat& mask) {
  const cv::Mat marks = contrast >= threshold;
  const PixelComponents pieces = pixelComponentsOf(marks.data, marks.cols, marks.rows, marks.step);
  const std::size_t n = pieces.all.size();
  std::vector<char> isWord(n, 0), isLetter(n, 0);
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < n; ++i) {
    isWord[i] = hasWordShape(pieces.all[i], frame);
    if (isWord[i] || hasLetterShape(pieces.all[i], frame)) order.push_back(i);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const Box &p = pieces.all[a].box, &q = pieces.all[b].box;
    return p.x0 != q.x0 ? p.x0 < q.x0 : p.y0 < q.y0;
  });
  const std::size_t firstRow = rows.size();
  for (const auto& row : letterRows(pieces.all, order)) {
    if (row.size() < 3 && std::none_of(row.begin(), row.end(), [&](std::size_t i) { return isWord[i] != 0; }))
      continue;
    rows.push_back(pieces.all[row.front()].box);
    for (std::size_t i : row) {
      isLetter[i] = 1;
      rows.back() = rows.back().joined(pieces.all[i].box);
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Box& box = pieces.all[i].box;
    // Dots, accents and missed letters: small pieces inside a row's box or a known word.
    for (std::size_t k = firstRow; k < rows.size() && !isLetter[i]; ++k)
      isLetter[i] = mostlyInside(box, rows[k]);
    for (std::size_t k = 0; k < words.size() && !isLetter[i]; ++k) isLetter[i] = mostlyInside(box, words[k]);
  }
  for (const PixelRun& run : pieces.runs)
    if (isLetter[run.piece])
      std::fill(mask.ptr<std::uint8_t>(run.y) + run.from, mask.ptr<std::uint8_t>(run.y) + run.to,
                std::uint8_t{1});
}

}  // namespace

Lettering findLettering(const PlotArea& area, const Mask& contrasts, float coverageThreshold) {
  Lettering text;
  const cv::Mat contrast(area.raster.height_px, area.raster.width_px, CV_8U,
                         const_cast<std::uint8_t*>(contrasts.data()));
  const int faint = std::max(14, static_cast<int>(0.6F * coverageThreshold));
  const int strong = strongContrast(contrast, faint) / 2;
  std::vector<Box> grown;
  for (const Box& word : area.words) {
    text.rows.push_back(word);
    grown.push_back(word.grown(1.5, 1.5));
  }
  cv::Mat mask(contrast.size(), CV_8U, cv::Scalar(0));
  // Faint text shows only at a low threshold, where letters of strong text are joined by their edges.
  markLetters(contrast, faint, area.frame, grown, text.rows, mask);
  if (strong > faint + 10) markLetters(contrast, strong, area.frame, grown, text.rows, mask);
  cv::dilate(mask, mask, cv::Mat::ones(5, 5, CV_8U));
  text.mask.assign(mask.datastart, mask.dataend);
  return text;
}

}  // namespace detent::importer::trace
