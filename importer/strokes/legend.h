// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a legend calls the strokes, in the languages datasheets are written in.

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

/// Returns true if the stroke's word of a text names a point in other legends: "Actuation", "Release".
bool mayNameAPoint(std::string_view utf8);

/// Whether two legend texts may be the press and the release of one switch: "press" and "release" do, also "X
/// press" and "X release"; "Switch A" and "Switch B", "down a" and "down b", "A press" and "B release" do
/// not. A text that is empty or names a point speaks neither for nor against; one that tells a switch's wear
/// is no stroke's.
bool mayBeOnePair(std::string_view a, std::string_view b, TextSource source = TextSource::recognised);

/// Whether two of more than two legend texts name the strokes of one switch: what is left without their words
/// for press and release is the same, numbers included, and those words differ ("Switch A" and "Switch A
/// release").
bool namesOnePair(std::string_view a, std::string_view b, TextSource source = TextSource::recognised);

/// Whether a text names a curve at all: it has words and is no point's name.
bool namesACurve(std::string_view utf8, TextSource source = TextSource::recognised);

/// Whether a text calls a curve something of its own that has nothing to do with a stroke: "Clicky", "sample
/// 3"; no program's name.
bool namesNoStroke(std::string_view utf8, TextSource source = TextSource::recognised);

/// Whether a text that names no stroke may be a word for one in a language or way of speaking that no list
/// has: one word of letters, no colour and nothing else that switches are called by.
bool mayNameAStroke(std::string_view utf8, TextSource source = TextSource::recognised);

/// Whether a text is what a program calls a series that nobody named: "data1", "Series 2", "Column B",
/// "'a.txt' using 1:2".
bool isDefaultName(std::string_view utf8);

/// Whether one text, or several parted by " / " (two tints make one ink), name the press as well as the
/// release.
bool namesBothStrokes(std::string_view label, TextSource source = TextSource::recognised);

/// Whether a text calls a curve the release and says nothing else: "Release", "Return stroke", "Rückhub",
/// "Press / Release"; "Release force" speaks of a quantity, "Switch B release" of a switch.
bool namesNothingButRelease(std::string_view utf8, TextSource source = TextSource::recognised);

/// A legend text without its words for press and release: "Switch A release" gives "Switch A",
/// "downstroke_aura" gives "aura", "press" nothing; of several texts parted by " / " each name once.
std::string switchNamedBy(std::string_view utf8, TextSource source = TextSource::recognised);

}  // namespace detent::importer
