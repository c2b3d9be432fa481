// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Words for the press and the release of a button, in the languages that charts are written in.

#include <optional>
#include <string>
#include <string_view>

#include "model/stroke_curve.h"

namespace detent::importer {

/// Small letters, Latin and Greek ones without their accents: what is said in one spelling, and what readers of pixels lose.
std::string folded(std::string_view utf8);

/// The stroke that a word, as `folded` writes it, is a word for. Readers of pixels get a letter of six wrong and two of nine, take
/// "rn" for "m" and "ii" for "ü"; the nearest word counts, and nothing where a word for either stroke is as near.
std::optional<Stroke> strokeOfWord(std::string_view word);

/// The stroke of a word that names one where it is all that is said: Dutch "op", Italian "su". Beside others such words are "on" or an article.
std::optional<Stroke> strokeOfLoneWord(std::string_view word);

/// The stroke of a word of which a legend's sample or its frame hides the beginning or the end: "leasing", "naciskan". Nothing
/// where words for both have such a part.
std::optional<Stroke> strokeOfPart(std::string_view word);

/// Whether a word, as `folded` writes it, is a word for a point on a curve: "point", "Schaltpunkt", "punto".
bool isPointWord(std::string_view word);

/// Which strokes the signs of languages without blanks name anywhere in a text.
struct SignedStrokes {
  bool press = false, release = false;
};
SignedStrokes strokesSignedIn(std::string_view utf8);

/// What is left of a word without the signs that name strokes, and without those for a curve beside them: "A轴下压曲线" is "A轴".
std::string withoutStrokeSigns(std::string_view word);

/// The Cyrillic word for a stroke that a reader who knows Latin letters and digits alone takes for this one, as many of them wrong as
/// are forgiven in a word of its length: "haxatue" is "нажатие". Empty if it is like none.
std::string_view cyrillicWordLike(std::string_view read);

/// Whether a word, as `folded` writes it, says of a curve what every legend says: "stroke", "curve", "phase".
bool isCurveWord(std::string_view word);

}  // namespace detent::importer
