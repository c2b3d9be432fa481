// SPDX-License-Identifier: GPL-3.0-or-later
// The whole import on plots that are drawn from the input: bytes of a compressed file hardly ever become
// another plot, these always do. Frame, grid, curves in any number, colours, dashes, letters, blocks, noise;
// dark or light, sharp or soft. Nothing may crash, hang, leak, or give a button with a number that is not
// finite.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <fuzzer/FuzzedDataProvider.h>
#include <opencv2/imgproc.hpp>

#include "tests/fuzz/import_document.h"

namespace {

constexpr int kWidth_px = 420, kHeight_px = 320;
const cv::Rect kFrame{50, 20, 350, 260};

class Drawing {
 public:
  Drawing(const std::uint8_t* data, std::size_t size) : choose_(data, size) {
    picture_ = cv::Mat(kHeight_px, kWidth_px, CV_8UC3, anyColour());
    if (choose_.ConsumeBool()) cv::rectangle(picture_, kFrame, anyColour(), thickness());
    grid();
    while (choose_.remaining_bytes() > 2) thing();
    if (soft_) cv::GaussianBlur(picture_, picture_, {3, 3}, 0);
  }

  /// As a file: 24-bit BMP.
  std::vector<unsigned char> bytes() const {
    const std::uint32_t row = 3 * kWidth_px, size = 54 + row * kHeight_px;
    static_assert(3 * kWidth_px % 4 == 0, "rows of a BMP end at four bytes");
    std::vector<unsigned char> file{'B', 'M'};
    for (std::uint32_t word : {size, 0U, 54U, 40U, std::uint32_t{kWidth_px}, std::uint32_t{kHeight_px},
                               1U | 24U << 16U, 0U, row * kHeight_px, 2835U, 2835U, 0U, 0U})
      for (unsigned shift = 0; shift < 32; shift += 8)
        file.push_back(static_cast<unsigned char>(word >> shift));
    for (int y = kHeight_px - 1; y >= 0; --y) file.insert(file.end(), picture_.ptr(y), picture_.ptr(y) + row);
    return file;
  }

 private:
  /// A few common colours, so that strokes may share one, each varied a little.
  cv::Scalar anyColour() {
    static const std::array<cv::Scalar, 8> kColours{{{255, 255, 255},
                                                     {0, 0, 0},
                                                     {30, 30, 220},
                                                     {200, 90, 20},
                                                     {180, 180, 180},
                                                     {60, 160, 60},
                                                     {40, 36, 32},
                                                     {250, 220, 180}}};
    const auto which = choose_.ConsumeIntegral<std::uint8_t>();
    return kColours[which % kColours.size()] + cv::Scalar::all(which / 32.0 - 4);
  }

  int thickness() { return choose_.ConsumeIntegralInRange<int>(1, 4); }

  /// Anywhere in the frame and a little beyond.
  cv::Point place() {
    const double x = choose_.ConsumeIntegral<std::uint8_t>() / 240.0,
                 y = choose_.ConsumeIntegral<std::uint8_t>() / 240.0;
    return {kFrame.x + cvRound(x * kFrame.width), kFrame.y + cvRound(y * kFrame.height)};
  }

  void grid() {
    const int lines = choose_.ConsumeIntegralInRange<int>(0, 7);
    const cv::Scalar color = anyColour();
    for (int k = 1; k <= lines; ++k) {
      const int x = kFrame.x + kFrame.width * k / (lines + 1), y = kFrame.y + kFrame.height * k / (lines + 1);
      cv::line(picture_, {x, kFrame.y}, {x, kFrame.br().y}, color);
      cv::line(picture_, {kFrame.x, y}, {kFrame.br().x, y}, color);
    }
  }

  void thing() {
    switch (choose_.ConsumeIntegralInRange<int>(0, 9)) {
      case 0:
        cv::rectangle(picture_, place(), place(), anyColour(), choose_.ConsumeBool() ? cv::FILLED : 1);
        break;
      case 1:
        cv::circle(picture_, place(), choose_.ConsumeIntegralInRange<int>(0, 40), anyColour(), thickness());
        break;
      case 2:
        cv::putText(picture_, choose_.ConsumeBool() ? "120" : "Press", place(), cv::FONT_HERSHEY_SIMPLEX, 0.5,
                    anyColour());
        break;
      case 3:
        soft_ = true;
        break;
      case 4:
        cv::line(picture_, place(), place(), anyColour(), thickness(), cv::LINE_AA);
        break;
      default:
        curve();
        break;
    }
  }

  /// From left to right in steps of its own; dashed ones miss every second piece.
  void curve() {
    const cv::Scalar color = anyColour();
    const int thick = thickness(), points = choose_.ConsumeIntegralInRange<int>(2, 24);
    const bool dashed = choose_.ConsumeIntegral<std::uint8_t>() > 200, smooth = choose_.ConsumeBool();
    cv::Point at = place();
    for (int k = 0; k < points; ++k) {
      const cv::Point to{at.x + choose_.ConsumeIntegral<std::uint8_t>() % 48,
                         at.y + choose_.ConsumeIntegral<std::int8_t>() / 2};
      if (!dashed || k % 2 == 0) cv::line(picture_, at, to, color, thick, smooth ? cv::LINE_AA : cv::LINE_8);
      at = to;
    }
  }

  FuzzedDataProvider choose_;
  cv::Mat picture_;
  bool soft_ = false;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  detent::importer::fuzz::importDocument(Drawing(data, size).bytes());
  return 0;
}
