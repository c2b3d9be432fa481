#include "importer/trace/plot_text.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace detent::importer::inks {

namespace {

/// A connected piece of foreground.
struct Piece {
  Box box;  ///< x1, y1 exclusive
  int area = 0;
  float halfStroke = 0;
};

struct Pieces {
  cv::Mat labels;
  std::vector<Piece> all;  ///< index = label; 0 is the background
};

Pieces piecesOf(const cv::Mat& mask, bool wantStroke) {
  Pieces pieces;
  cv::Mat stats, centroids;
  const int n = cv::connectedComponentsWithStats(mask, pieces.labels, stats, centroids, 8, CV_32S);
  pieces.all.resize(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    const double x = stats.at<int>(i, cv::CC_STAT_LEFT), y = stats.at<int>(i, cv::CC_STAT_TOP);
    Piece& piece = pieces.all[static_cast<std::size_t>(i)];
    piece.box = {x, y, x + stats.at<int>(i, cv::CC_STAT_WIDTH), y + stats.at<int>(i, cv::CC_STAT_HEIGHT)};
    piece.area = stats.at<int>(i, cv::CC_STAT_AREA);
  }
  if (!wantStroke) return pieces;
  cv::Mat distance;
  cv::distanceTransform(mask, distance, cv::DIST_L2, 3);
  for (int y = 0; y < mask.rows; ++y) {
    const int* label = pieces.labels.ptr<int>(y);
    const float* d = distance.ptr<float>(y);
    for (int x = 0; x < mask.cols; ++x)
      if (label[x]) {
        Piece& piece = pieces.all[static_cast<std::size_t>(label[x])];
        piece.halfStroke = std::max(piece.halfStroke, d[x]);
      }
  }
  return pieces;
}

cv::Mat foregroundMask(const PlotArea& area, const Backdrop& backdrop) {
  const Raster& r = area.raster;
  const float threshold = std::max(20.0F, inkThreshold(backdrop));
  cv::Mat mask(r.height_px, r.width_px, CV_8U, cv::Scalar(0));
  for (int y = 0; y < r.height_px; ++y) {
    std::uint8_t* row = mask.ptr<std::uint8_t>(y);
    for (int x = 0; x < r.width_px; ++x)
      row[x] = norm(colorAt(r, x, y) - backdrop.at(x, y)) >= threshold ? 1 : 0;
  }
  return mask;
}

bool hasLetterShape(const Piece& piece, const Box& frame) {
  const double height = piece.box.height(), width = piece.box.width();
  const double stroke = std::max(1.0, 2.0 * static_cast<double>(piece.halfStroke) - 1);
  return height >= 5 && height <= 0.14 * frame.height() && width <= 4 * height && width <= 0.2 * frame.width() &&
         height >= 2.2 * stroke;
}

double overlap(double a0, double a1, double b0, double b1) { return std::min(a1, b1) - std::max(a0, b0); }

bool standInOneRow(const Box& left, const Box& right) {
  const double small = std::min(left.height(), right.height()), tall = std::max(left.height(), right.height());
  const double gap = right.x0 - left.x1;
  return tall <= 2.3 * small && overlap(left.y0, left.y1, right.y0, right.y1) >= 0.55 * small && gap <= 0.8 * tall &&
         gap >= -0.5 * small;
}

Box joined(const Box& a, const Box& b) {
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

/// Chains letters from left to right. Three in a row are text; fewer may be anything.
std::vector<std::vector<std::size_t>> letterRows(const std::vector<Piece>& pieces, const std::vector<std::size_t>& order) {
  std::vector<std::vector<std::size_t>> rows;
  for (std::size_t i : order) {
    std::vector<std::size_t>* home = nullptr;
    for (auto row = rows.rbegin(); row != rows.rend() && !home; ++row) {
      // The last letters of a row, not just the very last: an 'i' dot or a comma may stand between.
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
  const double w = overlap(piece.x0, piece.x1, word.x0, word.x1), h = overlap(piece.y0, piece.y1, word.y0, word.y1);
  return w > 0 && h > 0 && w * h >= 0.8 * piece.width() * piece.height();
}

}  // namespace

PlotText findText(const PlotArea& area, const Backdrop& backdrop, const std::vector<Box>& words) {
  PlotText text;
  const cv::Mat foreground = foregroundMask(area, backdrop);
  const Pieces pieces = piecesOf(foreground, true);
  std::vector<std::size_t> order;
  for (std::size_t i = 1; i < pieces.all.size(); ++i)
    if (hasLetterShape(pieces.all[i], area.frame)) order.push_back(i);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const Box &p = pieces.all[a].box, &q = pieces.all[b].box;
    return p.x0 != q.x0 ? p.x0 < q.x0 : p.y0 < q.y0;
  });
  std::vector<char> isLetter(pieces.all.size(), 0);
  for (const auto& row : letterRows(pieces.all, order)) {
    if (row.size() < 3) continue;
    TextRow found;
    found.box = pieces.all[row.front()].box;
    for (std::size_t i : row) {
      isLetter[i] = 1;
      found.letters.push_back(pieces.all[i].box);
      found.box = joined(found.box, pieces.all[i].box);
    }
    text.rows.push_back(std::move(found));
  }
  for (const Box& word : words) {
    const double grow = 1.5;
    const Box grown{word.x0 - grow, word.y0 - grow, word.x1 + grow, word.y1 + grow};
    for (std::size_t i = 1; i < pieces.all.size(); ++i)
      if (mostlyInside(pieces.all[i].box, grown)) isLetter[i] = 1;
    text.rows.push_back({word, {}});
  }
  // Dots, accents and letters missed for their shape: small pieces inside a row's box.
  for (std::size_t i = 1; i < pieces.all.size(); ++i)
    for (const TextRow& row : text.rows)
      if (!isLetter[i] && !row.letters.empty() && mostlyInside(pieces.all[i].box, row.box)) isLetter[i] = 1;
  cv::Mat mask(foreground.size(), CV_8U, cv::Scalar(0));
  for (int y = 0; y < mask.rows; ++y) {
    const int* label = pieces.labels.ptr<int>(y);
    std::uint8_t* row = mask.ptr<std::uint8_t>(y);
    for (int x = 0; x < mask.cols; ++x) row[x] = isLetter[static_cast<std::size_t>(label[x])] ? 1 : 0;
  }
  cv::dilate(mask, mask, cv::Mat::ones(5, 5, CV_8U));
  text.mask.assign(mask.datastart, mask.dataend);
  return text;
}

std::vector<LegendSample> findLegendSamples(const Coverage& coverage, const PlotText& text, const PlotArea& area) {
  std::vector<LegendSample> samples;
  const Raster& r = area.raster;
  for (std::size_t k = 0; k < coverage.ink.size(); ++k) {
    cv::Mat mask(r.height_px, r.width_px, CV_8U, cv::Scalar(0));
    for (int y = 0; y < mask.rows; ++y)
      for (int x = 0; x < mask.cols; ++x) {
        const std::size_t i = coverage.unknown.index(x, y);
        mask.at<std::uint8_t>(y, x) = coverage.ink[k].values[i] > 0.25F && !text.mask[i] ? 1 : 0;
      }
    const Pieces pieces = piecesOf(mask, false);
    for (std::size_t i = 1; i < pieces.all.size(); ++i) {
      const Box& box = pieces.all[i].box;
      if (box.width() > 0.25 * area.frame.width() || pieces.all[i].area < 4) continue;
      for (const TextRow& row : text.rows) {
        const double height = row.box.height(), middle = 0.5 * (row.box.y0 + row.box.y1);
        const double gap = std::max(box.x0 - row.box.x1, row.box.x0 - box.x1);
        const bool level = std::abs(0.5 * (box.y0 + box.y1) - middle) <= 0.4 * height;
        const bool shaped = box.height() <= 1.1 * height && box.width() >= 1.5 * box.height() && box.width() >= 0.6 * height;
        if (level && shaped && gap > -1 && gap <= 1.8 * height) {
          samples.push_back({box, static_cast<int>(k)});
          break;
        }
      }
    }
  }
  return samples;
}

}  // namespace detent::importer::inks
