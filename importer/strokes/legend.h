// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A legend's names of the strokes, in the languages of datasheets.

#include <optional>
#include <string>
#include <string_view>

#include "importer/lexicon/lexicon.h"
#include "model/stroke_curve.h"

namespace detent::importer {

/// The stroke a legend text names: "Downstroke", "press (loading)", "Rückhub", "按压". Words are matched whole,
/// a wrong letter or two are forgiven in long ones (OCR). Nothing if it names none, both, or a point rather
/// than a stroke ("reset point").
std::optional<Stroke> strokeNamedBy(std::string_view utf8, TextSource source = TextSource::recognised);

/// Returns true if the text's word for a stroke is a point's name in other legends: "Actuation", "Release".
bool mayNameAPoint(std::string_view utf8);

/// Returns true if two legend texts may be the press and the release of one switch: "press" and "release" do,
/// also "X press" and "X release"; "Switch A" and "Switch B", "down a" and "down b", "A press" and "B
/// release" do not. A text that is empty or names a point is neutral; one that names a switch's wear is no
/// stroke's.
bool mayBeOnePair(std::string_view a, std::string_view b, TextSource source = TextSource::recognised);

/// For more than two legend texts: returns true if these two name the strokes of one switch. Without their
/// words for press and release they are equal, numbers included, and those words differ ("Switch A" and
/// "Switch A release").
bool namesOnePair(std::string_view a, std::string_view b, TextSource source = TextSource::recognised);

/// Returns true if a text can be a curve's name: it contains words and is no point's name.
bool namesACurve(std::string_view utf8, TextSource source = TextSource::recognised);

/// Returns true if a text is a curve's name that names no stroke: "Clicky", "sample 3". Default names of
/// programs do not count.
bool namesNoStroke(std::string_view utf8, TextSource source = TextSource::recognised);

/// Returns true if a text that names no known stroke may be a stroke's word in an unlisted language: a single
/// word of letters that is neither a colour nor another switch's name.
bool mayNameAStroke(std::string_view utf8, TextSource source = TextSource::recognised);

/// Returns true if a text is a program's default name of a series: "data1", "Series 2", "Column B", "'a.txt'
/// using 1:2".
bool isDefaultName(std::string_view utf8);

/// Returns true if one text, or several separated by " / " (two tints that were merged), name the press as
/// well as the release.
bool namesBothStrokes(std::string_view label, TextSource source = TextSource::recognised);

/// Returns true if a text names the release and nothing else: "Release", "Return stroke", "Rückhub", "Press /
/// Release"; "Release force" names a quantity, "Switch B release" a switch.
bool namesNothingButRelease(std::string_view utf8, TextSource source = TextSource::recognised);

/// A legend text without its words for press and release: "Switch A release" gives "Switch A",
/// "downstroke_aura" gives "aura", "press" nothing; of several texts parted by " / " each name once.
std::string switchNamedBy(std::string_view utf8, TextSource source = TextSource::recognised);

}  // namespace detent::importer
