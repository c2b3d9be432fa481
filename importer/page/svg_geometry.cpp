// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/svg_geometry.h"

#include <cctype>
#include <charconv>
#include <cmath>
#include <string>

namespace detent::importer {
namespace {

bool isLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// Numbers, command letters and words of an attribute.
class Lexer {
 public:
  explicit Lexer(std::string_view text) : text_(text) {}

  std::optional<double> number() {
    skip();
    if (text_.empty() || isLetter(text_[0])) return std::nullopt;  // "inf" is not a number here
    const std::size_t sign = text_[0] == '+' ? 1 : 0;
    double value = 0;
    const auto [end, error] = std::from_chars(text_.data() + sign, text_.data() + text_.size(), value);
    if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
    text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
    return value;
  }
  /// A path command; 0 if a number or nothing follows.
  char letter() {
    skip();
    return text_.empty() || !isLetter(text_[0]) ? '\0' : taken(1)[0];
  }
  std::string word() {
    skip();
    std::size_t n = 0;
    while (n < text_.size() && isLetter(text_[n])) ++n;
    return taken(n);
  }
  bool take(char c) {
    skip();
    if (text_.empty() || text_[0] != c) return false;
    text_.remove_prefix(1);
    return true;
  }
  bool atEnd() {
    skip();
    return text_.empty();
  }

 private:
  void skip() {
    while (!text_.empty() && (std::isspace(static_cast<unsigned char>(text_[0])) || text_[0] == ','))
      text_.remove_prefix(1);
  }
  std::string taken(std::size_t n) {
    std::string out(text_.substr(0, n));
    text_.remove_prefix(n);
    return out;
  }

  std::string_view text_;
};

/// Follows path commands point by point.
class LineBuilder {
 public:
  /// False: no straight line.
  bool step(char command, Lexer& lexer) {
    const bool relative = std::islower(static_cast<unsigned char>(command)) != 0;
    const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(command)));
    if (kind != 'M' && lines_.empty()) return false;
    const Point origin = relative ? at_ : Point{0, 0};
    const auto first = lexer.number();
    if (!first) return false;
    if (kind == 'H') {
      at_.x = origin.x + *first;
    } else if (kind == 'V') {
      at_.y = origin.y + *first;
    } else {
      const auto second = lexer.number();
      if (!second || (kind != 'M' && kind != 'L')) return false;
      at_ = {origin.x + *first, origin.y + *second};
    }
    if (kind == 'M') {
      start_ = at_;
      lines_.emplace_back();
    } else if (closed_) {
      lines_.push_back({start_});
    }
    closed_ = false;
    lines_.back().push_back(at_);
    return true;
  }
  bool close() {
    if (lines_.empty()) return false;
    lines_.back().push_back(start_);
    at_ = start_;
    closed_ = true;
    return true;
  }
  std::vector<std::vector<Point>> take() { return std::move(lines_); }

 private:
  std::vector<std::vector<Point>> lines_;
  Point at_, start_;
  bool closed_ = false;
};

}  // namespace

std::optional<Affine> svgUprightTransform(std::string_view text) {
  Lexer lexer(text);
  Affine map;
  while (!lexer.atEnd()) {
    const std::string kind = lexer.word();
    if (!lexer.take('(')) return std::nullopt;
    std::vector<double> v;
    while (const auto number = lexer.number()) v.push_back(*number);
    if (!lexer.take(')') || v.empty()) return std::nullopt;
    if (kind == "matrix" && v.size() == 6 && v[1] == 0 && v[2] == 0) {
      map = map.after({v[0], 0, 0, v[3], v[4], v[5]});
    } else if (kind == "translate" && v.size() <= 2) {
      map = map.after({1, 0, 0, 1, v[0], v.size() > 1 ? v[1] : 0});
    } else if (kind == "scale" && v.size() <= 2) {
      map = map.after({v[0], 0, 0, v.back(), 0, 0});
    } else if (kind != "rotate" || v[0] != 0) {
      return std::nullopt;
    }
  }
  if (map.a == 0 || map.d == 0) return std::nullopt;
  return map;
}

std::optional<double> svgNumber(std::string_view text) { return Lexer(text).number(); }

std::optional<std::vector<std::vector<Point>>> svgStraightLines(std::string_view data) {
  Lexer lexer(data);
  LineBuilder builder;
  char command = 0;
  while (!lexer.atEnd()) {
    const char letter = lexer.letter();
    if (letter == 'Z' || letter == 'z') {
      if (!builder.close()) return std::nullopt;
      command = 0;
      continue;
    }
    if (letter) command = letter;
    if (!command || !builder.step(command, lexer)) return std::nullopt;
    if (command == 'M') command = 'L';  // further pairs are lines
    if (command == 'm') command = 'l';
  }
  return builder.take();
}

}  // namespace detent::importer
