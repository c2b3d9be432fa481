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

/// A number that a label could mean. The label as read has weight 1; a repaired reading (a restored decimal
/// point) has less.
struct NumberReading {
  double value = 0;
  double weight = 1;
};

/// The number in computable form: without a leading plus sign and without apostrophes as thousands separators
/// ("1'000").
std::string withoutGroupSigns(std::string_view utf8);

/// Decimal point or comma, any Unicode minus, blanks, plus and apostrophes of thousands ignored. nullopt if
/// anything else stands in it.
std::optional<double> printedNumber(std::string_view utf8);

/// All readings of a label: as it stands, and with a decimal point restored that small print may have lost.
/// The second weighs less if the label was read with certainty. `confidence` 0..1 of the reading.
std::vector<NumberReading> numberReadings(std::string_view utf8, double confidence = 0);

/// Adjusts readings of numbers in one print if one of them has lost its point ("08" can only be 0.8): with
/// the point it then has full weight, and in all other labels a lost point is as likely as none. `texts` as
/// they were read.
void expectLostPoints(const std::vector<std::string>& texts,
                      std::vector<std::vector<NumberReading>>& readings);

/// Interpretation of a sign that precedes three digits: thousands separator or decimal point?
enum class ThousandsSign {
  none,      ///< no number has that form, or other numbers show that the sign is a decimal point
  certain,   ///< thousands separator: whole numbers stand beside them ("500", "1,000")
  possible,  ///< ambiguous: there are only numbers like "1,000" and "2,000"
};

/// Adjusts readings of numbers in one print in which a sign separates thousands: "500, 1,000, 1,500"
/// increases by 500. If that is certain, the decimal readings are removed.
ThousandsSign expectThousands(const std::vector<std::string>& texts,
                              std::vector<std::vector<NumberReading>>& readings);

/// Returns true if a number was read digit by digit as a similar one: "8" for 0, "66" for 60.
bool resembles(std::string_view read, std::string_view number);

/// A text's digits alone, in their order.
std::string digitsOf(std::string_view text);

}  // namespace detent::importer
