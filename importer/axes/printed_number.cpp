// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/printed_number.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <string>

namespace detent::importer {
namespace {

bool isDigitAt(std::string_view s, std::size_t at) { return at < s.size() && s[at] >= '0' && s[at] <= '9'; }

/// The number in ASCII with '.' and '-'; empty if it contains a character that no number has.
std::string plain(std::string_view utf8) {
  const std::string s = withoutGroupSigns(utf8);
  std::string out;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const auto rest = std::string_view(s).substr(i);
    const auto skip = [&](std::string_view token, std::string_view as) {
      if (!rest.starts_with(token)) return false;
      out += as;
      i += token.size() - 1;
      return true;
    };
    const char c = s[i];
    if (c >= '0' && c <= '9') {
      out += c;
    } else if (c == '.' || c == ',') {
      out += '.';
    } else if (c == '-') {
      out += '-';
    } else if (c != ' ' && !skip("\xE2\x88\x92", "-") && !skip("\xE2\x80\x93", "-") &&
               !skip("\xE2\x80\x92", "-") && !skip("\xC2\xA0", "") && !skip("\xE2\x80\x89", "") &&
               !skip("\xE3\x80\x82", ".") && !skip("\xC2\xB7", ".")) {
      return {};
    }
  }
  return out;
}

std::optional<double> parsed(std::string_view s) {
  double value = 0;
  const auto [end, error] = std::from_chars(s.data(), s.data() + s.size(), value, std::chars_format::fixed);
  if (error != std::errc() || end != s.data() + s.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Possible meanings of the separator in a number.
enum class SignIn {
  none,       ///< a whole number
  thousands,  ///< "1,000", "12,500": thousands or decimals
  decimals    ///< "0.125", "1.25", "12.5"
};

SignIn signIn(std::string_view utf8) {
  std::string s = plain(utf8);
  if (s.starts_with('-')) s.erase(0, 1);
  while (!s.empty() && (s.back() == '.' || s.back() == '-')) s.pop_back();
  const auto sign = s.find('.');
  if (sign == std::string::npos) return SignIn::none;
  const bool three =
      sign >= 1 && sign <= 3 && s.size() == sign + 4 && s.find('.', sign + 1) == std::string::npos;
  return three && s.front() != '0' ? SignIn::thousands : SignIn::decimals;
}

}  // namespace

std::string withoutGroupSigns(std::string_view utf8) {
  constexpr std::string_view curved = "\xE2\x80\x99";  // U+2019
  std::string out;
  if (utf8.starts_with('+') && isDigitAt(utf8, 1)) utf8.remove_prefix(1);
  for (std::size_t i = 0; i < utf8.size();) {
    const std::size_t length = utf8[i] == '\'' ? 1 : utf8.substr(i).starts_with(curved) ? curved.size() : 0;
    const std::size_t next = i + length;
    const bool groups = length > 0 && !out.empty() && isDigitAt(out, out.size() - 1) && out != "0" &&
                        isDigitAt(utf8, next) && isDigitAt(utf8, next + 1) && isDigitAt(utf8, next + 2) &&
                        !isDigitAt(utf8, next + 3);
    if (!groups) out += utf8[i];
    i = groups ? next : i + 1;
  }
  return out;
}

bool resembles(std::string_view read, std::string_view number) {
  constexpr std::array<std::string_view, 8> alike{"08", "06", "68", "38", "89", "56", "17", "09"};
  const std::string digits = digitsOf(read), other = digitsOf(number);
  if (digits.size() != other.size()) return false;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    const auto holdsBoth = [&](std::string_view pair) {
      return pair.find(digits[i]) != std::string_view::npos && pair.find(other[i]) != std::string_view::npos;
    };
    if (digits[i] != other[i] && std::ranges::none_of(alike, holdsBoth)) return false;
  }
  return true;
}

std::optional<double> printedNumber(std::string_view utf8) {
  std::string s = plain(utf8);
  // Dust beside a digit is read as a point, and a tick behind it as a minus sign.
  while (s.size() > 1 && (s.back() == '.' || s.back() == '-')) s.pop_back();
  if (s.empty() || s == "-" || s == "." || s.size() > 9) return std::nullopt;
  if (s.front() == '.') s.insert(s.begin(), '0');
  return parsed(s);
}

std::vector<NumberReading> numberReadings(std::string_view utf8, double confidence) {
  // weights of repaired readings; the text as printed has weight 1
  constexpr double repair = 0.45, repairOfSure = 0.3;
  std::vector<NumberReading> readings;
  const auto first = printedNumber(utf8);
  if (!first) return readings;
  readings.push_back({*first, 1.0});
  std::string s = plain(utf8);
  while (s.back() == '-' || s.back() == '.') s.pop_back();
  const auto digits = static_cast<std::size_t>(
      std::count_if(s.begin(), s.end(), [](char c) { return c >= '0' && c <= '9'; }));
  // A number with thousands separators has not lost a decimal point.
  const bool grouped = utf8.front() != '+' && withoutGroupSigns(utf8).size() < utf8.size();
  if (s.find('.') != std::string::npos || digits < 2 || grouped) return readings;
  const std::size_t lead = s.front() == '-' ? 1 : 0;
  const bool leadingZero = s.size() > lead && s[lead] == '0';
  // "05" can only be 0.5; "15" is 15 unless its neighbours say 1.5.
  readings.front().weight = leadingZero ? 0.2 : 1.0;
  double scale = 0.1;
  for (std::size_t k = 1; k < digits; ++k, scale *= 0.1) {
    const bool afterFirst = k + 1 == digits;
    readings.push_back({*first * scale, leadingZero && afterFirst         ? 0.9
                                        : confidence >= readWithCertainty ? repairOfSure
                                                                          : repair});
  }
  return readings;
}

void expectLostPoints(const std::vector<std::string>& texts,
                      std::vector<std::vector<NumberReading>>& readings) {
  const auto lost = [](const std::string& text) {
    const std::string digits = digitsOf(text);
    return digits.size() > 1 && digits.front() == '0' && text.find_first_of(".,") == std::string::npos;
  };
  if (std::ranges::none_of(texts, lost)) return;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (readings[i].empty()) continue;
    for (NumberReading& reading : readings[i]) reading.weight = 1;
    if (lost(texts[i])) readings[i].erase(readings[i].begin());
  }
}

ThousandsSign expectThousands(const std::vector<std::string>& texts,
                              std::vector<std::vector<NumberReading>>& readings) {
  int hundreds = 0, zeros = 0, thousands = 0, decimals = 0;
  bool comma = false;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (readings[i].empty()) continue;
    const SignIn sign = signIn(texts[i]);
    const std::string digits = digitsOf(texts[i]);
    zeros += digits == "0";
    // Numbers of two or three digits may have lost a point; "050" certainly has.
    hundreds += sign == SignIn::none && (digits.size() == 2 || digits.size() == 3) && digits.front() != '0';
    thousands += sign == SignIn::thousands;
    decimals += sign == SignIn::decimals || (digits.size() > 1 && digits.front() == '0');
    comma = comma || (sign == SignIn::thousands && texts[i].find(',') != std::string::npos);
  }
  if (thousands == 0 || decimals > 0) return ThousandsSign::none;
  const bool certain = hundreds > 0 || (comma && zeros > 0);
  // "1,000" may be a whole number with three decimals, which is unusual beside a "0" without decimals.
  if (!certain) return (comma && thousands > 1) || zeros > 0 ? ThousandsSign::possible : ThousandsSign::none;
  for (std::size_t i = 0; i < texts.size(); ++i)
    if (!readings[i].empty() && signIn(texts[i]) == SignIn::thousands)
      readings[i] = {{1000 * readings[i].front().value, 1.0}};
  return ThousandsSign::certain;
}

std::string digitsOf(std::string_view text) {
  std::string digits;
  std::copy_if(text.begin(), text.end(), std::back_inserter(digits),
               [](char c) { return c >= '0' && c <= '9'; });
  return digits;
}

}  // namespace detent::importer
