// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Determines which letters and lines of a page a person sees, and keeps each once: fake bold, shadows and
// halos draw a label several times, and edited pages cover the old one. Private to importer/page.

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "importer/page/page.h"

namespace detent::importer {

/// One letter as it is set. In page units.
struct SetLetter {
  int unicode = 0;
  float x = 0, y = 0;  ///< start on the baseline, exactly as MuPDF reports it
  Box box;             ///< as wide as the advance, as high as the font
  double size = 0;     ///< height of the font
  double advance = 0;
  Rgb color;
};

/// Letters by code and place, with the number of letters of that code that were drawn in the same place
/// before the visible one.
using LetterKeys = std::map<std::tuple<int, float, float>, int>;

enum class CoverKind {
  rectangle,  ///< an upright area of one colour
  picture,
  shape  ///< any other area; its colour at a place is not known
};

enum class Sight {
  seen,
  ofPicture,  ///< drawn invisibly over or under a picture: the text of a scan, if the picture shows it
  hidden
};

/// Tracks visibility while a page is processed in drawing order.
class Visibility {
 public:
  /// `drawn`: false for invisible text, such as the text of scans.
  void letter(const SetLetter& letter, bool drawn);
  /// Records a filled area. `hides`: the area conceals everything below it; hidden paths are removed from
  /// `paths`.
  void cover(const Box& box, CoverKind kind, Rgb color, bool hides, std::vector<VectorPath>& paths);

  /// Returns the visible letters. Of copies in one place it returns one, preferably a drawn one. A word of
  /// a scan's invisible text counts if `isShown` confirms half of its letters: thin letters have little
  /// contrast.
  template <class IsShown>
  LetterKeys seen(const IsShown& isShown) const {
    LetterKeys keys, before;
    const std::vector<bool> once = seenOnce();
    std::vector<bool> shown(letters_.size(), true);
    for (std::size_t first = 0, last = 0; first < letters_.size(); first = last) {
      std::size_t confirmed = 0;
      for (last = first; last < letters_.size() && (last == first || isSameWord(last - 1, last)); ++last)
        confirmed += letters_[last].sight != Sight::ofPicture || isShown(letters_[last].letter.box) ? 1 : 0;
      std::fill(shown.begin() + static_cast<std::ptrdiff_t>(first),
                shown.begin() + static_cast<std::ptrdiff_t>(last), 2 * confirmed >= last - first);
    }
    for (std::size_t i = 0; i < letters_.size(); ++i) {
      const SetLetter& letter = letters_[i].letter;
      const std::tuple key(letter.unicode, letter.x, letter.y);
      const int earlier = before[key]++;
      if (once[i] && (letters_[i].sight == Sight::seen || shown[i])) keys.emplace(key, earlier);
    }
    return keys;
  }

 private:
  struct Noted {
    SetLetter letter;
    Sight sight = Sight::seen;
  };
  struct Cover {
    Box box;
    CoverKind kind = CoverKind::shape;
    Rgb color;
  };

  bool isSameWord(std::size_t before, std::size_t next) const;
  const Cover* coverUnder(Point place) const;
  bool mayCompare(std::size_t things);
  std::vector<bool> seenOnce() const;

  std::vector<Noted> letters_;
  std::vector<Cover> covers_;
  std::size_t comparisons_ = 0;
};

/// The box of an upright rectangle; nothing if the path is anything else.
std::optional<Box> uprightRectangle(const std::vector<std::vector<Point>>& polylines);

/// Keeps one of several lines that have the same colour and form and nearly the same place.
void dropRepeats(std::vector<VectorPath>& paths);

}  // namespace detent::importer
