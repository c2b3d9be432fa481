// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Reading pixels: words and numbers in a box of a view. The only place that knows Tesseract.
// An engine is started at the first reading (about 50 ms per language) and kept for the thread.

#include <string>
#include <vector>

#include "importer/axes/axis_calibration.h"

namespace detent::importer {

enum class TextKind {
  number,  ///< digits, sign, decimal point or comma
  words,   ///< anything Latin
  unit     ///< letters that units of force and length are written with, brackets and strokes; no digit
};

/// One thread at a time; cheap to make, engines are shared per thread.
class TextReader {
 public:
  /// The view's pixels must outlive the reader.
  explicit TextReader(const PageView& view);

  /// One line of text in `box` (view pixels). `angle_deg` of its baseline, counter-clockwise: 0 or ±90, 180.
  /// Empty text with confidence 0 if there is nothing to read or no engine can be started.
  SeenText readLine(const Box& box, TextKind kind, double angle_deg = 0);

  /// The same for a line that must not be misread. A doubtful line is read again with thinner strokes (bold
  /// print closes the holes of digits) and at another size; the reading with the highest confidence is
  /// returned.
  SeenText readLineCarefully(const Box& box, TextKind kind, double angle_deg = 0);

  /// Readings of a line of words at other sizes than readLine's, because small print is read differently at
  /// each size.
  std::vector<SeenText> readLineOtherwise(const Box& box, double angle_deg = 0);

  /// False if Tesseract or its language data are missing; then everything reads as empty.
  static bool available();

 private:
  const PageView& view_;
};

}  // namespace detent::importer
