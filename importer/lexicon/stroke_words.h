// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The strokes that words of a legend name, in the languages of lexicon.tsv.

#include <optional>
#include <string>
#include <string_view>

#include "importer/lexicon/letters.h"
#include "importer/lexicon/lexicon.h"
#include "model/stroke_curve.h"

namespace detent::importer {

/// The stroke that a folded word names, by the nearest word of the lexicon. nullopt if a word for the other
/// stroke, or a word that distinguishes switches, is as near ("leading" is no misread "loading"), or if a
/// difference is no known confusion of letters.
std::optional<Stroke> strokeOfWord(std::string_view word, TextSource source = TextSource::recognised);

/// The stroke for which a folded word may be a misread name, even with letters that no known confusion
/// explains. Proves nothing by itself.
std::optional<Stroke> strokeLike(std::string_view word);

/// The stroke of a word that names one only as the whole label: Dutch "op", Italian "su".
std::optional<Stroke> strokeOfLoneWord(std::string_view word);

/// The stroke of a word whose beginning or end is hidden by a legend key or frame: "leasing", "naciskan".
/// Nothing where words for both strokes have such a part.
std::optional<Stroke> strokeOfPart(std::string_view word);

/// Returns true if a folded word names a point on a curve: "point", "Schaltpunkt", "punto".
bool isPointWord(std::string_view word, TextSource source = TextSource::recognised);

/// Returns true if a folded word names a stroke in some legends and a point in others: "actuation",
/// "release".
bool mayBePointWord(std::string_view word);

/// Strokes that signs of languages without blanks, or arrows at a label's end, name.
struct SignedStrokes {
  bool press = false, release = false;
};
SignedStrokes strokesSignedIn(std::string_view utf8);

/// A word without the signs that name strokes, and without those for a curve beside them: "A轴下压曲线" gives
/// "A轴".
std::string withoutStrokeSigns(std::string_view word);

/// The Cyrillic word for a stroke that an engine reads in Latin letters as this word: "нажатие" for
/// "haxatue". Empty if none is near.
std::string_view cyrillicWordLike(std::string_view read);

/// Returns true if a folded word only says that the label belongs to a curve: "stroke", "curve", "phase".
bool isCurveWord(std::string_view word, TextSource source = TextSource::recognised);

/// Returns true if a text holds a sign of this kind anywhere.
bool holdsSign(std::string_view utf8, WordKind kind);

/// A folded text without the phrases that are other things' names: "load cell", "return key".
std::string withoutOtherNames(std::string_view foldedText);

}  // namespace detent::importer
