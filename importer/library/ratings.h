// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Ratings of switches by people: score sheets as their author wrote them. Nothing is computed from them.

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace detent::importer {

/// One switch in one person's sheet.
struct Rating {
  std::string name, maker;      ///< as the sheet has them; maker may be empty
  std::string source;           ///< the sheet, absolute
  std::string licence, credit;  ///< see Origin
  std::vector<std::pair<std::string, double>>
      scores;  ///< "Push Feel", 31; in the sheet's order and on its scale
};

/// The switches of a score sheet: CSV with a line of headings, among them "Switch Name" and "Push Feel", and
/// the scores up to the first heading that is empty. Empty for any other text. Source, licence and credit are
/// left empty. Any thread.
std::vector<Rating> ratingsIn(std::string_view csv);

/// "ThereminGoat/switch-scores of \"Alpaca V2\": Push Feel 32, Wobble 22": the author, the switch and the
/// scores.
std::string ratingWords(const Rating& rating);

/// Finds the ratings of a switch by its name. Any thread once it is made.
class RatingsByName {
 public:
  explicit RatingsByName(const std::vector<Rating>& all);
  /// Ratings whose name has the same words in any order, with the maker's name or, if at least two words
  /// remain, without it. Of several in one person's sheets, the most detailed one.
  std::vector<Rating> of(const std::string& switchName) const;

 private:
  std::map<std::string, std::vector<Rating>> byWords_;
};

}  // namespace detent::importer
