// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Numbers as plots print them, and as recognisers misread them.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace detent::importer {

/// Confidence of the text engine from which a label counts as read, 0..1.
inline constexpr double readWithCertainty = 0.9;

/// A number a label could mean. The first reading weighs 1, repairs (a lost decimal point) less.
struct NumberReading {
  double value = 0;
  double weight = 1;
};

/// A number as it is computed with: without a plus in front and without apostrophes that set thousands apart
/// ("1'000").
std::string withoutGroupSigns(std::string_view utf8);

/// Decimal point or comma, any Unicode minus, blanks, plus and apostrophes of thousands ignored. nullopt if
/// anything else stands in it.
std::optional<double> printedNumber(std::string_view utf8);

/// All readings of a label: as it stands, and with the decimal point that small print loses put back, which
/// weighs less where the label was read with certainty. `confidence` 0..1 of the reading.
std::vector<NumberReading> numberReadings(std::string_view utf8, double confidence = 0);

/// Readings of numbers in one print, `texts` as they were read: where one has lost its point ("08" can only
/// be 0.8) it counts as read, and all others may have lost theirs as well as not.
void expectLostPoints(const std::vector<std::string>& texts,
                      std::vector<std::vector<NumberReading>>& readings);

/// Three digits behind a sign: a thousand, or three decimals?
enum class ThousandsSign {
  none,      ///< no number is written so, or others in the print say that decimals stand there
  certain,   ///< whole numbers stand beside them: "500", "1,000"
  possible,  ///< "1,000" and "2,000" alone may be either
};

/// Readings of numbers in one print where a sign sets thousands apart: "500, 1,000, 1,500" counts by five
/// hundreds. Where it is certain the decimal reading goes.
ThousandsSign expectThousands(const std::vector<std::string>& texts,
                              std::vector<std::vector<NumberReading>>& readings);

/// Returns true if a number was read digit by digit as a similar one: "8" for 0, "66" for 60.
bool resembles(std::string_view read, std::string_view number);

/// A text's digits alone, in their order.
std::string digitsOf(std::string_view text);

}  // namespace detent::importer
