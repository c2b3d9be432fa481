// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/lexicon/lexicon.h"

#include <algorithm>
#include <string>
#include <string_view>

#include <catch2/catch.hpp>

#include "importer/lexicon/letters.h"
#include "importer/lexicon/printed_unit.h"
#include "importer/lexicon/quantity_symbol.h"
#include "importer/lexicon/stroke_words.h"

using namespace detent;
using namespace detent::importer;

namespace {

std::string forceIn(std::string_view title, TextSource source) {
  const auto unit = forceUnitIn(title, source);
  return unit ? std::string(symbolOf(unit->unit)) : std::string();
}

std::string lengthIn(std::string_view title, TextSource source) {
  const auto unit = lengthUnitIn(title, source);
  return unit ? std::string(symbolOf(unit->unit)) : std::string();
}

/// A title with the units of force and length in it, and what it measures instead.
struct Row {
  const char *title, *force, *length, *other;
};

void check(const Row& row, TextSource source) {
  CAPTURE(row.title);
  CHECK(forceIn(row.title, source) == row.force);
  CHECK(lengthIn(row.title, source) == row.length);
  CHECK(otherQuantityIn(row.title, source) == row.other);
}

}  // namespace

TEST_CASE("every line of the lexicon has a known kind and every quantity a name", "[lexicon]") {
  for (const LexiconEntry& entry : entriesOf(WordKind::quantity)) {
    CAPTURE(entry.word);
    CHECK_FALSE(entry.value.empty());
    CHECK(folded(entry.word) == entry.word);
  }
  for (const LexiconEntry& entry : entriesOf(WordKind::symbol)) {
    CAPTURE(entry.word);
    CHECK(letterCount(entry.word) == 1);
    CHECK((entry.value == "force" || entry.value == "travel"));
  }
  for (const WordKind kind :
       {WordKind::press, WordKind::release, WordKind::point, WordKind::curve, WordKind::variant})
    for (const LexiconEntry& entry : entriesOf(kind)) {
      CAPTURE(entry.word);
      CHECK(folded(entry.word) == entry.word);
    }
  for (const LexiconEntry& press : entriesOf(WordKind::press)) {
    CAPTURE(press.word);
    CHECK(std::ranges::find(entriesOf(WordKind::release), press.word, &LexiconEntry::word) ==
          entriesOf(WordKind::release).end());
  }
}

TEST_CASE("a unit counts with a quantity that agrees or with none", "[lexicon]") {
  for (const Row& row : {Row{"Force [cN]", "cN", "", ""},
                         Row{"Touch weight (g)", "gf", "", ""},
                         Row{"Effort du doigt (cN)", "cN", "", ""},
                         Row{"Opposing force [mN]", "mN", "", ""},
                         Row{"压力 / mN", "mN", "", ""},
                         Row{"Depression of key [mm]", "", "mm", ""},
                         Row{"Betätigungsweg, mm", "", "mm", ""},
                         Row{"按压行程 [mm]", "", "mm", ""},
                         Row{"F (gf)", "gf", "", ""},
                         Row{"s / mm", "", "mm", ""},
                         Row{"Inductance [H]", "", "", "inductance (H)"},
                         Row{"Shock [g]", "", "", "acceleration"},
                         Row{"Samples [N]", "", "", "count"},
                         Row{"Samples [mm]", "", "", "count"},
                         Row{"Output (r)", "", "", "output"},
                         Row{"Wire diameter (mm)", "", "", "diameter"},
                         Row{"样本数 [N]", "", "", "count"},
                         Row{"扭矩 [N·m]", "", "", "torque (N·m)"},
                         Row{"Compressive strain (mm/mm)", "", "", "strain (mm/mm)"},
                         Row{"Pressure (kPa)", "", "", "pressure (kPa)"},
                         Row{"G-force [g]", "", "", "acceleration"},
                         Row{"Force over time of use [N]", "N", "", ""}})
    check(row, TextSource::exact);
}

TEST_CASE("a unit beside a word that nobody knows is a question", "[lexicon]") {
  CHECK(forceIn("Fluffiness [N]", TextSource::exact).empty());
  CHECK(otherQuantityIn("Fluffiness [N]", TextSource::exact) == "fluffiness");
  CHECK(lengthIn("Fluffiness (mm)", TextSource::exact).empty());
  CHECK(forceIn("Fluffiness [N]", TextSource::recognised) == "N");       // the word may be misread
  CHECK(otherQuantityIn("Cherry MX Brown", TextSource::exact).empty());  // no title of an axis
  CHECK(forceIn("Press [N]", TextSource::exact) == "N");
  CHECK(forceIn("Newtons", TextSource::exact) == "N");
}

TEST_CASE("a letter in place of words counts where it is one of what its unit measures", "[lexicon]") {
  for (const Row& row : {Row{"U [N]", "", "", "U"},           Row{"v [N]", "", "", "v"},
                         Row{"\u03C3 [N]", "", "", "\u03C3"}, Row{"x [N]", "", "", "x"},
                         Row{"s [g]", "", "", "s"},           Row{"a / g", "", "", "a"},
                         Row{"a in g", "", "", "a"},          Row{"a, g", "", "", "a"},
                         Row{"a_z [g]", "", "", "a"},         Row{"|a| (g)", "", "", "a"},
                         Row{"a(t) [g]", "", "", "a"},        Row{"\u0394a [g]", "", "", "a"},
                         Row{"amax [gf]", "", "", "a"},       Row{"$a$ [g]", "", "", "a"},
                         Row{"C [lb]", "", "", "C"},          Row{"t [mm]", "", "", "t"},
                         Row{"T [mm]", "", "", "T"},          Row{"U [mm]", "", "", "U"},
                         Row{"F [mm]", "", "", "F"},          Row{"\u03B5 [mm] \u2192", "", "", "\u03B5"},
                         Row{"F [N]", "N", "", ""},           Row{"F_z / mN", "mN", "", ""},
                         Row{"|F| [cN]", "cN", "", ""},       Row{"Fmax [N]", "N", "", ""},
                         Row{"\u0394F [N]", "N", "", ""},     Row{"P, gf", "gf", "", ""},
                         Row{"F in N", "N", "", ""},          Row{"s [mm]", "", "mm", ""},
                         Row{"u, mm", "", "mm", ""},          Row{"\u03B4 [mm]", "", "mm", ""},
                         Row{"\u0394x / mm", "", "mm", ""},   Row{"x\u2081 (mm)", "", "mm", ""},
                         Row{"s(t) [in]", "", "in", ""},      Row{"P.T. (mm)", "", "mm", ""},
                         Row{"(mm)", "", "mm", ""},           Row{"\u529B (N)", "N", "", ""}})
    check(row, TextSource::exact);
}

TEST_CASE("a letter that was read is what it was read as, a digit may be an ideograph", "[lexicon]") {
  for (const Row& row :
       {Row{"U [N]", "", "", "U"}, Row{"w (N)", "", "", "w"}, Row{"W (N)", "N", "", ""},
        Row{"U [mm]", "", "", "U"}, Row{"u [mm]", "", "mm", ""},
        Row{"\u20AC (gf)", "", "", "\u20AC"},  // an epsilon as it is read
        Row{"2 (mN)", "mN", "", ""}, Row{"\u00BB (gf)", "gf", "", ""}, Row{"AE25,mm", "", "mm", ""},
        Row{"5 (mm)", "", "mm", ""}, Row{"I [Ib]", "", "", "I"}, Row{"Aa (gf)", "", "", "a"},
        Row{"Az (mm)", "", "mm", ""}, Row{"lal (gf)", "", "", "a"}, Row{"|F| (N)", "N", "", ""},
        Row{"F, (N)", "N", "", ""}, Row{"Fy (N)", "N", "", ""}, Row{"{1 / mm", "", "mm", ""}})
    check(row, TextSource::recognised);
}

TEST_CASE("the letters of a formula are italic signs of their own", "[lexicon]") {
  for (const Row& row :
       {Row{"𝑎 [g]", "", "", "a"}, Row{"𝐹 [N]", "N", "", ""}, Row{"𝛿 (mm)", "", "mm", ""},
        Row{"𝛥𝑠 / mm", "", "mm", ""}, Row{"𝜀 [mm]", "", "", "ε"}, Row{"ℎ in mm", "", "mm", ""},
        Row{"𝒂 [g]", "", "", "a"}, Row{"𝐙 (mm)", "", "mm", ""}})
    check(row, TextSource::exact);
}

TEST_CASE("a sign that no engine could read is no letter of a quantity", "[lexicon]") {
  check({"\uFFFD [gf]", "gf", "", ""}, TextSource::recognised);
  check({"\uFFFD (mm)", "", "mm", ""}, TextSource::recognised);
}

TEST_CASE("code points of every length come back as they were", "[lexicon]") {
  for (const std::string text : {"", "F [N]", "δ°", "荷重 [gf]", "𝑎𝛿", "\U0010FFFF"}) {
    CAPTURE(text);
    CHECK(utf8Of(codePoints(text)) == text);
    CHECK(codePoints(text).size() == letterCount(text));
  }
  CHECK(codePoints("\xF0\x9D\x91") == std::u32string{0xF0, 0x9D, 0x91});  // cut off
}

TEST_CASE("a title that ends before its unit has no letter in place of words", "[lexicon]") {
  for (const TextSource source : {TextSource::exact, TextSource::recognised})
    for (const char* title :
         {"", " ", "|", "a", "A", "\u0394", "\xCE", "a_{", "a(t)", "a(", "U [", "U []", "lal", "a in "}) {
      CAPTURE(title);
      CHECK_FALSE(symbolBeforeUnit(title, source));
    }
}

TEST_CASE("the axes of force and travel exchanged name each other", "[lexicon]") {
  CHECK(forceIn("Travel (N)", TextSource::exact).empty());
  CHECK(lengthIn("Force (mm)", TextSource::exact).empty());
}

TEST_CASE("misread letters count in recognised text alone", "[lexicon]") {
  CHECK(forceIn("Force [eN]", TextSource::recognised) == "cN");
  CHECK(forceIn("Force [eN]", TextSource::exact).empty());
  // A Cyrillic letter for newtons, as Latin print, where the title names a force; else it may be henry.
  CHECK(forceIn("Load [H]", TextSource::recognised) == "N");
  CHECK(forceIn("Load, mH", TextSource::recognised) == "mN");
  CHECK(forceIn("Sensor [H]", TextSource::recognised).empty());
  CHECK(forceIn("WMuoyKTUBHOCTS, [H", TextSource::recognised).empty());
  CHECK(forceIn("Response, mH", TextSource::recognised).empty());
  CHECK(forceIn("Y [H]", TextSource::exact).empty());
  CHECK(forceIn("Усилие [H]", TextSource::exact) == "N");  // typed in Latin beside Cyrillic words
  CHECK(forceIn("Inductance [H]", TextSource::recognised).empty());
  CHECK(strokeOfWord("reiease", TextSource::recognised) == Stroke::release);
  CHECK_FALSE(strokeOfWord("reiease", TextSource::exact));
  CHECK(strokeOfWord("rueckweg", TextSource::exact) == Stroke::release);  // another spelling
}

TEST_CASE("a word is a stroke's only where every difference is explained", "[lexicon]") {
  for (const char* word :
       {"advanced", "classic", "leading", "pro", "clown", "uptown", "pressure", "reserve", "retro"}) {
    CAPTURE(word);
    CHECK_FALSE(strokeOfWord(word, TextSource::recognised));
    CHECK_FALSE(strokeOfWord(word, TextSource::exact));
  }
  CHECK_FALSE(strokeOfWord("dwnstroke"));
  CHECK(strokeLike("dwnstroke") == Stroke::press);
  CHECK(matchWord("advanced", {WordKind::press}, TextSource::recognised)->explained == false);
}

TEST_CASE("a reading costs what its letters cost", "[lexicon]") {
  CHECK(costOfReading("release", "release", 1, true) == 0.0);
  CHECK(costOfReading("retomo", "retorno", 1, true).value() < 0.1);
  CHECK_FALSE(costOfReading("retxrno", "retorno", 1, true));
  CHECK(costOfReading("retxrno", "retorno", 1, false) == 1.0);
}
