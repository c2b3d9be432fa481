// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/seen_text.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "importer/page/polyline.h"
#include "importer/page/same_colour.h"

namespace detent::importer {

bool Visibility::mayCompare(std::size_t things) {
  constexpr std::size_t most = 100000000;  // limit of comparisons, about a third of a second
  comparisons_ += things;
  return comparisons_ <= most;
}

bool Visibility::isSameWord(std::size_t before, std::size_t next) const {
  // share of a letter's size, from the beginning of one letter to that of the next
  constexpr double farthest = 1.5;
  const SetLetter &a = letters_[before].letter, &b = letters_[next].letter;
  return letters_[before].sight == letters_[next].sight &&
         std::hypot(a.x - b.x, a.y - b.y) <= farthest * a.size;
}

const Visibility::Cover* Visibility::coverUnder(Point place) const {
  const auto last = std::find_if(covers_.rbegin(), covers_.rend(),
                                 [&](const Cover& cover) { return cover.box.contains(place); });
  return last == covers_.rend() ? nullptr : &*last;
}

void Visibility::letter(const SetLetter& letter, bool drawn) {
  constexpr double unseen = 30;  // colour levels between a letter and its background; less is invisible
  constexpr Rgb paper{255, 255, 255};
  Sight sight = Sight::seen;
  if (mayCompare(covers_.size())) {
    const Cover* const background = coverUnder(letter.box.middle());
    const bool onPicture = background != nullptr && background->kind == CoverKind::picture;
    const bool onColor = background == nullptr || background->kind == CoverKind::rectangle;
    if (!drawn)
      sight = onPicture ? Sight::ofPicture : Sight::hidden;
    else if (onColor &&
             colorDistance(letter.color, background != nullptr ? background->color : paper) < unseen)
      sight = Sight::hidden;
  }
  letters_.push_back({letter, sight});
}

void Visibility::cover(const Box& box, CoverKind kind, Rgb color, bool hides,
                       std::vector<VectorPath>& paths) {
  covers_.push_back({box, kind, color});
  if (!hides || !mayCompare(letters_.size() + paths.size())) return;
  for (Noted& noted : letters_)
    if (noted.sight != Sight::hidden && box.contains(noted.letter.box.middle()))
      noted.sight = kind == CoverKind::picture ? Sight::ofPicture : Sight::hidden;
  std::erase_if(paths, [&](const VectorPath& path) {
    return box.contains(path.clip ? path.box.common(*path.clip) : path.box);
  });
}

std::vector<bool> Visibility::seenOnce() const {
  constexpr double nearly = 0.3;     // share of a letter's size: copies lie within this distance
  constexpr double ofAdvance = 0.6;  // a repeated letter of a word is a whole advance away
  std::vector<bool> once(letters_.size(), false);
  std::map<int, std::vector<std::size_t>> byCode;  // letters of each code, sorted by x
  for (std::size_t i = 0; i < letters_.size(); ++i)
    if (letters_[i].sight != Sight::hidden) byCode[letters_[i].letter.unicode].push_back(i);
  const auto isCopy = [&](std::size_t i, std::size_t k) {
    const SetLetter &a = letters_[i].letter, &b = letters_[k].letter;
    const bool neighbours = i + 1 == k || k + 1 == i;
    const double within = neighbours ? std::min(nearly * a.size, ofAdvance * a.advance) : nearly * a.size;
    return std::hypot(a.x - b.x, a.y - b.y) < within;
  };
  for (auto& [unicode, indices] : byCode) {
    std::ranges::sort(indices, {}, [&](std::size_t i) { return letters_[i].letter.x; });
    std::vector<std::size_t> kept;
    for (const std::size_t i : indices) {
      bool copy = false;
      for (std::size_t k = kept.size(); k-- > 0 && !copy;) {
        if (letters_[i].letter.x - letters_[kept[k]].letter.x > nearly * letters_[i].letter.size) break;
        copy = isCopy(i, kept[k]);
        // the drawn copy is kept, not the invisible one
        if (copy && letters_[kept[k]].sight == Sight::ofPicture) kept[k] = i;
      }
      if (!copy) kept.push_back(i);
    }
    for (const std::size_t i : kept) once[i] = true;
  }
  return once;
}

std::optional<Box> uprightRectangle(const std::vector<std::vector<Point>>& polylines) {
  if (polylines.size() != 1) return {};
  const std::vector<Point>& ring = polylines.front();
  if (ring.size() < 4 || ring.size() > 5 || (ring.size() == 5 && ring.front() != ring.back())) return {};
  const Box box = boundsOf(ring);
  const double slack = 1e-3 * (box.width() + box.height());
  for (std::size_t i = 0; i < 4; ++i) {
    const Point a = ring[i], b = ring[(i + 1) % 4];
    const bool level = std::abs(a.y - b.y) < slack, upright = std::abs(a.x - b.x) < slack;
    if (level == upright) return {};
  }
  return box;
}

void dropRepeats(std::vector<VectorPath>& paths) {
  constexpr double nearly = 0.75;  // page units; or this share of the line's width
  constexpr double cell = 4;       // page units
  constexpr int mostPlaces = 64;   // lines in one cell; more are a texture
  struct Place {
    std::size_t points = 0;
    long column = 0, row = 0;
    bool operator<(const Place& p) const {
      return std::tie(points, column, row) < std::tie(p.points, p.column, p.row);
    }
  };
  std::map<Place, std::vector<std::size_t>> known;
  std::vector<bool> repeated(paths.size(), false);
  const auto pointsOf = [](const VectorPath& path) {
    std::size_t points = 0;
    for (const auto& line : path.polylines) points += line.size();
    return points;
  };
  const auto repeats = [&](const VectorPath& a, const VectorPath& b) {
    if (a.stroke != b.stroke || a.fill != b.fill || a.dashed != b.dashed ||
        a.polylines.size() != b.polylines.size())
      return false;
    const double within = std::max(nearly, nearly * std::min(a.strokeWidth, b.strokeWidth));
    for (std::size_t l = 0; l < a.polylines.size(); ++l) {
      if (a.polylines[l].size() != b.polylines[l].size()) return false;
      for (std::size_t i = 0; i < a.polylines[l].size(); ++i)
        if (std::hypot(a.polylines[l][i].x - b.polylines[l][i].x, a.polylines[l][i].y - b.polylines[l][i].y) >
            within)
          return false;
    }
    return true;
  };
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (paths[i].polylines.empty() || paths[i].polylines.front().empty()) continue;
    const Point first = paths[i].polylines.front().front();
    const Place place{pointsOf(paths[i]), std::lround(std::floor(std::clamp(first.x, -1e6, 1e6) / cell)),
                      std::lround(std::floor(std::clamp(first.y, -1e6, 1e6) / cell))};
    for (long dx = -1; dx <= 1 && !repeated[i]; ++dx)
      for (long dy = -1; dy <= 1 && !repeated[i]; ++dy)
        if (const auto near = known.find({place.points, place.column + dx, place.row + dy});
            near != known.end())
          repeated[i] =
              std::ranges::any_of(near->second, [&](std::size_t k) { return repeats(paths[i], paths[k]); });
    if (auto& here = known[place]; !repeated[i] && here.size() < mostPlaces) here.push_back(i);
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < paths.size(); ++i)
    if (!repeated[i]) {
      if (kept != i) paths[kept] = std::move(paths[i]);
      ++kept;
    }
  paths.resize(kept);
}

}  // namespace detent::importer
