// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and units as printed, and as misread.

#include <cstdio>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "importer/axes/axis_multiplier.h"
#include "importer/axes/cyrillic_look.h"
#include "importer/axes/printed_number.h"
#include "importer/axes/uneven_scale.h"
#include "importer/lexicon/lexicon.h"
#include "importer/lexicon/printed_factor.h"
#include "importer/lexicon/printed_unit.h"

using namespace detent;
using namespace detent::importer;

TEST_CASE("A number that begins with a zero has lost its point, and its neighbours may have", "[axes]") {
  const std::vector<std::string> texts{"28", "20", "16", "08"};
  std::vector<std::vector<NumberReading>> readings;
  for (const std::string& text : texts) readings.push_back(numberReadings(text, 0.95));
  const auto weightOf = [&](std::size_t i, double value) {
    for (const NumberReading& r : readings[i])
      if (std::abs(r.value - value) < 1e-9) return r.weight;
    return 0.0;
  };
  CHECK(weightOf(0, 2.8) < weightOf(0, 28));
  expectLostPoints(texts, readings);
  CHECK(weightOf(0, 2.8) == weightOf(0, 28));
  CHECK(weightOf(3, 0.8) == 1);
  CHECK(weightOf(3, 8) == 0);

  std::vector<std::vector<NumberReading>> whole{numberReadings("20", 0.95), numberReadings("0", 0.95)};
  expectLostPoints({"20", "0"}, whole);
  CHECK(whole[0].size() == 2);
  CHECK(whole[0][1].weight < 0.5);
}

TEST_CASE("numbers as plots print them") {
  CHECK(printedNumber("120") == 120);
  CHECK(printedNumber("0.5") == 0.5);
  CHECK(printedNumber("0,5") == 0.5);
  CHECK(printedNumber(".5") == 0.5);
  CHECK(printedNumber("-20") == -20);
  CHECK(printedNumber("\xE2\x88\x92"
                      "20") == -20);
  CHECK(printedNumber("4.") == 4);
  CHECK(printedNumber(" 60 ") == 60);
  CHECK(printedNumber("+0.5") == 0.5);
  CHECK(printedNumber("1'250") == 1250);
  CHECK(printedNumber("12\xE2\x80\x99"
                      "000") == 12000);
  CHECK_FALSE(printedNumber("5'25").has_value());   // a foot-and-inch length
  CHECK_FALSE(printedNumber("0'500").has_value());  // no thousand begins with zero
  CHECK_FALSE(printedNumber("2+3").has_value());
}

TEST_CASE("numbers that readers take for each other") {
  for (const auto& [read, number] :
       {std::pair{"8", "0"}, {"0.8", "0.0"}, {"66", "60"}, {"7.5", "1.5"}, {"80", "80"}})
    CHECK(resembles(read, number));
  for (const auto& [read, number] : {std::pair{"3.7", "3.5"}, {"8", "80"}, {"20", "40"}, {"", "0"}})
    CHECK_FALSE(resembles(read, number));
}

TEST_CASE("what is no number is none") {
  for (const char* text : {"", "-", ".", "mm", "1e5", "12a", "--3", "1.2.3", "0123456789", "\xE5\x8A\x9B"})
    CHECK_FALSE(printedNumber(text).has_value());
}

TEST_CASE("every printed decimal is read back") {
  REQUIRE(rc::check("decimal", [] {
    const int whole = *rc::gen::inRange(-9999, 9999), decimals = *rc::gen::inRange(0, 3);
    const double value = whole / std::pow(10.0, decimals);
    char text[32];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    RC_ASSERT(printedNumber(text) == Approx(value).margin(1e-12));
  }));
}

TEST_CASE("a lost decimal point is among the readings") {
  const auto has = [](const char* text, double value) {
    for (const auto& r : numberReadings(text))
      if (std::abs(r.value - value) < 1e-12) return true;
    return false;
  };
  CHECK(has("15", 15));
  CHECK(has("15", 1.5));
  CHECK(has("05", 0.5));
  CHECK(numberReadings("05").front().weight < 0.5);
  CHECK(numberReadings("1.5").size() == 1);
  CHECK(numberReadings("x").empty());
}

TEST_CASE("units in titles") {
  const auto force = [](const char* title) {
    const auto unit = forceUnitIn(title);
    return unit ? std::string(symbolOf(unit->unit)) : std::string("none");
  };
  const auto length = [](const char* title) {
    const auto unit = lengthUnitIn(title);
    return unit ? std::string(symbolOf(unit->unit)) : std::string("none");
  };
  const std::string cN(symbolOf(ForceUnit::centinewton)), gf(symbolOf(ForceUnit::gramForce)),
      N(symbolOf(ForceUnit::newton)), ozf(symbolOf(ForceUnit::ounceForce)),
      mN(symbolOf(ForceUnit::millinewton));
  CHECK(force("Force [cN]") == cN);
  CHECK(force("Kraft / cN") == cN);
  CHECK(force("Kraft in cN") == cN);
  CHECK(force("F (gf)") == gf);
  CHECK(force("\xE5\x8A\x9B(gf)") == gf);
  CHECK(force("Force\xE5\x8A\x9B\xEF\xBC\x88gf\xEF\xBC\x89") == gf);
  CHECK(force("Force (g)") == gf);
  CHECK(force("~ Fi (ef)") == gf);  // a g in small print, its word set apart from it
  CHECK(force("Force [N]") == N);
  CHECK(force("Kraft [mN]") == mN);
  CHECK(force("Force [ozf]") == ozf);
  CHECK(force("Force [eN]") == cN);  // as misread
  CHECK(force("Operating force [0z]") == ozf);
  CHECK(force("Force [mMN]") == mN);
  CHECK(force("Force") == "none");
  CHECK(force("Release of the force") == "none");
  CHECK(force("Force-Travel-Diagram") == "none");
  const std::string mm(symbolOf(LengthUnit::millimetre)), in(symbolOf(LengthUnit::inch));
  CHECK(length("Travel [mm]") == mm);
  CHECK(length("Weg / mm") == mm);
  CHECK(length("Position (mm)") == mm);
  CHECK(length("\xE8\xA1\x8C\xE7\xA8\x8B(mm)") == mm);
  CHECK(length("Displacement [inch]") == in);
  CHECK(length("5 +T#E (1mm)") == mm);  // as misread, in small print
  CHECK(length("Travel") == "none");
}

TEST_CASE("titles that are names of columns end in their unit") {
  for (const auto& [title, unit] : {std::pair{"force_g", ForceUnit::gramForce},
                                    {"Force_gf", ForceUnit::gramForce},
                                    {"press_force_cN", ForceUnit::centinewton},
                                    {"load_mN", ForceUnit::millinewton},
                                    {"force_n", ForceUnit::newton},
                                    {"Force..N.", ForceUnit::newton},
                                    {"forceN", ForceUnit::newton},
                                    {"ForceGf", ForceUnit::gramForce},
                                    {"F_gf", ForceUnit::gramForce},
                                    {"force_ozf", ForceUnit::ounceForce}}) {
    CAPTURE(title);
    REQUIRE(forceUnitIn(title));
    CHECK(forceUnitIn(title)->unit == unit);
    CHECK(forceUnitIn(title)->sure >= 0.85);
  }
  for (const auto& [title, unit] : {std::pair{"travel_mm", LengthUnit::millimetre},
                                    {"disp_um", LengthUnit::micrometre},
                                    {"Displacement.mm", LengthUnit::millimetre},
                                    {"travelMm", LengthUnit::millimetre},
                                    {"x_mm", LengthUnit::millimetre},
                                    {"stroke_in", LengthUnit::inch},
                                    {"Stroke-mm", LengthUnit::millimetre},
                                    {"pos_mil", LengthUnit::mil}}) {
    CAPTURE(title);
    REQUIRE(lengthUnitIn(title));
    CHECK(lengthUnitIn(title)->unit == unit);
  }
  for (const char* title : {"F_N", "force_value", "force_1", "MaxForce", "no.1", "_N", "KraftV", "“oN"}) {
    CAPTURE(title);
    CHECK_FALSE(forceUnitIn(title));
  }
  CHECK(lengthUnitIn("{1 / mm"));  // what ideographs may come back as
  CHECK(otherQuantityIn("{1 / mm").empty());
  CHECK_FALSE(lengthUnitIn("Depth of plug-in"));
  CHECK(otherQuantityIn("time_ms") == "time (ms)");
}

TEST_CASE("what stands in a title's brackets is the unit, whole or not at all") {
  const auto force = [](const char* title) {
    const auto unit = forceUnitIn(title);
    return unit ? std::string(symbolOf(unit->unit)) : std::string("none");
  };
  const auto length = [](const char* title) {
    const auto unit = lengthUnitIn(title);
    return unit ? std::string(symbolOf(unit->unit)) : std::string("none");
  };
  CHECK(force("Kraft [dN]") == "dN");
  CHECK(force("Force (kN)") == "kN");
  CHECK(force("Load [kp]") == "kgf");
  CHECK(force("Force (lb)") == "lbf");
  CHECK(force("Force [dyn]") == "dyn");
  CHECK(force("\xE5\x8A\x9B\xEF\xBC\x88\xE5\x85\x8B\xEF\xBC\x89") == "gf");  // 力（克）
  CHECK(force("\xE5\x8A\x9B (\xE5\x8D\x95\xE4\xBD\x8D:gf)") == "gf");        // 力 (单位:gf)
  CHECK(force("Iegf]") == "none");
  CHECK(force("Force lgf]") == "gf");  // the opening bracket was read as a letter
  CHECK(length("Weg [mil]") == "mil");
  CHECK(length("Stroke (thou)") == "mil");
  CHECK(length("\xE8\xA1\x8C\xE7\xA8\x8B(\xE6\xAF\xAB\xE7\xB1\xB3)") == "mm");  // 行程(毫米)
  CHECK(length("Travel [ym]") == "\xC2\xB5m");                                  // as misread
  for (const char* other : {"Pressure (kPa)", "Force [x10 gf]", "Stiffness (N/mm)", "Torque (mNm)",
                            "Load [%]", "Force [arb. u.]", "Voltage [V]",
                            "Temperature [\xC2\xB0"
                            "C]",
                            "y (mm)", "Force [MN]"})
    CHECK(force(other) == "none");
  for (const char* other :
       {"Time [s]", "Wavelength (nm)", "Frequency [Hz]", "Cycles (x1000)", "Distance (m)", "Sample"})
    CHECK(length(other) == "none");
}

TEST_CASE("a title that measures something else says what") {
  CHECK(otherQuantityIn("Pressure (kPa)") == "pressure (kPa)");
  CHECK(otherQuantityIn("Stiffness (N/mm)") == "stiffness (N/mm)");
  CHECK(otherQuantityIn("Force [x10 gf]") == "x10gf");
  CHECK(otherQuantityIn("Time") == "time");
  for (const char* own :
       {"Force [cN]", "Travel (mm)", "Operating force over time of use [N]", "Kraft", "F (gf)"})
    CHECK(otherQuantityIn(own).empty());
}

TEST_CASE("a tick behind a number is no part of it, and sure readings are repaired less readily") {
  CHECK(*printedNumber("80-") == 80);
  CHECK(*printedNumber("-80") == -80);
  CHECK_FALSE(printedNumber("-").has_value());
  CHECK(numberReadings("80", 0.95).back().weight < numberReadings("80", 0.5).back().weight);
}

TEST_CASE("a word with one letter misread is still that word") {
  const auto names = [](const char* title) { return quantityNamedIn(title, TextSource::recognised).name; };
  CHECK(names("foroe (gf)") == "force");
  CHECK(names("positon (nm)") == "travel");
  CHECK(names("Schaltkraft") == "force");
  CHECK(names("hut").empty());  // short words are too many
  CHECK(names("").empty());
  CHECK(lengthUnitIn("Positon (nm)")->unit == LengthUnit::millimetre);
}

TEST_CASE(
    "a unit is read behind any words, a comma and an arrow, and in Cyrillic letters that resemble Latin "
    "ones") {
  const auto force = [](const char* title) {
    const auto unit = forceUnitIn(title);
    return unit ? std::string(symbolOf(unit->unit)) : std::string("none");
  };
  const auto length = [](const char* title) {
    const auto unit = lengthUnitIn(title);
    return unit ? std::string(symbolOf(unit->unit)) : std::string("none");
  };
  CHECK(force(": Force, Ibf") == "lbf");
  CHECK(force("Load [IbF]") == "lbf");
  CHECK(force("Force <gf>") == "gf");
  CHECK(force("HRED CN]") == "none");  // of "[N]" or of "cN]"
  CHECK(force("HRED Igf]") == "gf");
  CHECK(force("Load Ibf") == "lbf");
  CHECK(force("Ycunue, H") == "N");                         // Усилие, Н
  CHECK(force("Yeunnue, H") == "none");                     // letters too far from it: H may be henry
  CHECK(force("Ycunue Haxatua [r]") == "gf");               // Усилие нажатия [г]
  CHECK(force("Cuna (rc)") == "gf");                        // Сила (гс)
  CHECK(length("Xog (MKM) \xE2\x80\x94>") == "\xC2\xB5m");  // Ход (мкм) →
  CHECK(length("Travel, in") == "in");
  CHECK(length("\xE2\x82\xACmm>") == "mm");  // a bracket of a stroke font
  CHECK(length("Displacement / mm \xE2\x86\x92") == "mm");
  CHECK(length("Depth pm") == "\xC2\xB5m");
  CHECK(forceUnitIn("Kraft. N").value().sure >= 0.9);  // the comma as it is read
  CHECK(force("Op. force, N") == "N");
  for (const char* none : {"Load of", "Force H", "Type r", "Play of force"}) CHECK(force(none) == "none");
  for (const char* none : {"Travel in", "Depth am", "Start, then in two"}) CHECK(length(none) == "none");
}

namespace {

/// Possible meanings of a row of labels after its signs were read together.
std::vector<std::vector<NumberReading>> readTogether(const std::vector<std::string>& texts,
                                                     ThousandsSign expected) {
  std::vector<std::vector<NumberReading>> readings;
  for (const std::string& text : texts) readings.push_back(numberReadings(text, 0.95));
  CHECK(expectThousands(texts, readings) == expected);
  return readings;
}

}  // namespace

TEST_CASE("words of strokes in Cyrillic are known by the Latin letters they resemble, one of them wrong") {
  CHECK(withCyrillicWords("HaxaTue") == "Нажатие");
  CHECK(withCyrillicWords("Bo3Bpat, 2") == "Возврат, 2");
  CHECK(withCyrillicWords("OtnyckaHMe") == "Отпускание");
  CHECK(withCyrillicWords("HatuckaHHa") == "Натискання");
  CHECK(withCyrillicWords("BianyckaHHa") == "Відпускання");
  CHECK(withCyrillicWords("OtnyckaHe") == "Отпускане");
  CHECK(withCyrillicWords("npamon xog") == "прямой xog");
  for (const char* other : {"Release", "harpy", "BoxPat", "Return 23", "Prägung"})
    CHECK(withCyrillicWords(other) == other);
}

TEST_CASE("three digits behind a sign are thousands where whole numbers stand beside them") {
  CHECK(readTogether({"0", "500", "1,000", "1,500"}, ThousandsSign::certain)[2].front().value == 1000);
  CHECK(readTogether({"0", "1,000", "2,000"}, ThousandsSign::certain)[1].front().value == 1000);
  CHECK(readTogether({"250", "500", "750", "1.000"}, ThousandsSign::certain)[3].front().value == 1000);
  // "0,500" proves that "," is a decimal sign.
  CHECK(readTogether({"0,000", "0,500", "1,000"}, ThousandsSign::none)[2].front().value == 1);
  CHECK(readTogether({"0.5", "1.000"}, ThousandsSign::none)[1].front().value == 1);
  CHECK(readTogether({"050", "1.000"}, ThousandsSign::none)[1].front().value == 1);  // lost its point
  CHECK(readTogether({"1.000", "1.250", "1.500"}, ThousandsSign::none)[1].front().value == 1.25);
  // Here "," may be a decimal sign or a thousands separator.
  CHECK(readTogether({"1,000", "2,000", "3,000"}, ThousandsSign::possible)[0].front().value == 1);
  CHECK(readTogether({"0", "1.000", "2.000"}, ThousandsSign::possible)[1].front().value == 1);
}

TEST_CASE("a heading that names a unit of force and one of length in one bracket") {
  const auto in = [](const char* heading) {
    const auto units = headingUnitsIn(heading);
    return units ? std::string(symbolOf(units->force)) + " " + std::string(symbolOf(units->length)) : "none";
  };
  CHECK(in("Key force vs travel (cN, mm)") == "cN mm");
  CHECK(in("B3F-L [mm; N]") == "N mm");
  CHECK(in("Force over travel [gf / mm]") == "gf mm");
  CHECK(in("Force [N] vs. travel [mm]") == "N mm");
  CHECK(in("Button force in gf against travel in mm") == "gf mm");
  for (const char* none : {"Spring rate (N/mm)", "Key force (cN)", "Force vs travel (cN, mm, s)",
                           "Force vs travel (cN, V)", "Force and time (N, mm)", "Force (N) vs travel (mm, N)",
                           "Force vs travel cN, mm", "Force in N, travel in percent"})
    CHECK(in(none) == "none");
}

TEST_CASE("a power of ten at the end of an axis") {
  for (const auto& [text, power] : {std::pair{"1e1", 10.0},
                                    {"1e-1", 0.1},
                                    {"1e−1", 0.1},
                                    {"le-1", 0.1},
                                    {"×10³", 1000.0},
                                    {"x10^3", 1000.0},
                                    {"× 10⁻²", 0.01},
                                    {"10-1", 0.1},
                                    {"1e+3", 1000.0}}) {
    CAPTURE(text);
    REQUIRE(multiplierIn(text));
    CHECK(*multiplierIn(text) == Approx(power));
  }
  for (const char* text : {"", "103", "10", "1e", "2e3", "Force", "1.5", "1e12", "let", "10 N"}) {
    CAPTURE(text);
    CHECK_FALSE(multiplierIn(text));
  }
}

TEST_CASE("a factor that a title prints beside its unit") {
  struct Title {
    const char *text, *without;
    double factor;
  };
  for (const Title& title : {Title{"Load [x10 gf]", "Load [ gf]", 10},
                             {"Load [x10gf]", "Load [gf]", 10},
                             {"Force ×10³ (N)", "Force  (N)", 1000},
                             {"Force x103 [N]", "Force  [N]", 1000},
                             {"Force x 10^3 [N]", "Force  [N]", 1000},
                             {"(kgf x 10)", "(kgf )", 10},
                             {"Kraft in 0.1 N", "Kraft in  N", 0.1},
                             {"F / 10 mN", "F / mN", 10},
                             {"Force [10^-3 N]", "Force [ N]", 0.001},
                             {"Force [10−3 N]", "Force [ N]", 0.001},
                             {"Kraft ·100 [N]", "Kraft  [N]", 100},
                             {"Travel [1/100 mm]", "Travel [ mm]", 0.01},
                             {"Force, 10 mN", "Force,  mN", 10},
                             {"荷重（10 mN）", "荷重（ mN）", 10},
                             {"Force - 10 (cN)", "Force -  (cN)", 10},
                             {"Key force - 10 (cN)", "Key force -  (cN)", 10},
                             {"Kraft: 100 mN", "Kraft:  mN", 100},
                             {"Travel 0.01 mm", "Travel  mm", 0.01},
                             {"Force*10^{-3} [N]", "Force [N]", 0.001}}) {
    INFO(title.text);
    const auto found = printedFactorIn(title.text);
    REQUIRE(found);
    CHECK(found->factor.value_or(0) == Approx(title.factor));
    CHECK(found->title == title.without);
  }
  for (const char* text : {"Force (gf)", "Force (60 gf)", "Force at speed (10 mm/min) [N]", "Max 100 gf",
                           "x-axis 10", "Force at 10 mm", "Force 10 N, slow", "Force 10 N slow",
                           "Operating force: 100 gf", "Full stroke 10 mm", "Force 10 mm/min", "Force 20 gf",
                           "MX10 (gf)", "3x10 keys", "Force in 10 keys", "x1 [N]", "×10³", "10", ""}) {
    INFO(text);
    CHECK_FALSE(printedFactorIn(text));
  }
}

TEST_CASE("a factor whose exponent was misread is printed and unknown") {
  struct Title {
    const char *text, *without;
  };
  for (const Title& title : {Title{"Force [x10?mN]", "Force [mN]"},
                             {"Force x10? mN", "Force  mN"},
                             {"Force (x107! N)", "Force ( N)"},
                             {"Load [x10*2 gf]", "Load [ gf]"},
                             {"Force ×10° mN", "Force  mN"},
                             {"Force [x1072N]", "Force [N]"},
                             {"Force ×10? (N)", "Force  (N)"},
                             {"Force x10 3 mN", "Force  mN"}}) {
    INFO(title.text);
    const auto found = printedFactorIn(title.text);
    REQUIRE(found);
    CHECK_FALSE(found->factor);
    CHECK(found->title == title.without);
  }
}

TEST_CASE("lines at logarithmic distances show a logarithmic scale, whatever the numbers are read as") {
  const auto lines = [](double top_px, double decade_px, int digits, bool logarithmic, bool upwards) {
    std::vector<GridLine> found;
    for (int decade = 0; decade < 2; ++decade)
      for (int digit = 1; digit <= digits; ++digit) {
        const double share = logarithmic ? std::log10(digit) : (digit - 1) / 9.0;
        found.push_back({top_px + decade_px * (upwards ? 2 - decade - share : decade + share), 1, true});
      }
    return found;
  };
  CHECK(isLogarithmic(lines(13, 166, 9, true, true)));
  CHECK(isLogarithmic(lines(13, 80, 9, true, false)));
  CHECK_FALSE(isLogarithmic(lines(13, 166, 9, false, true)));
  CHECK_FALSE(isLogarithmic(lines(13, 40, 9, false, true)));
  CHECK_FALSE(isLogarithmic(lines(13, 166, 1, true, true)));  // the decades alone
}

TEST_CASE("a scale that is not linear is named") {
  CHECK(unevenScaleOf({{100, 1}, {200, 10}, {300, 100}, {400, 1000}}) == "values on a logarithmic scale");
  CHECK(unevenScaleOf({{400, 20}, {300, 50}, {220, 100}, {140, 200}, {40, 500}}) ==
        "values on a logarithmic scale");
  CHECK(unevenScaleOf({{100, 0}, {200, 0.1}, {300, 0.5}, {400, 2}, {500, 2.2}}) ==
        "categories, not to scale");
  CHECK(unevenScaleOf({{100, 0}, {200, 20}, {301, 40}, {400, 60}}).empty());
  CHECK(unevenScaleOf({{100, 0}, {200, 20}, {300, 4}, {400, 60}}).empty());  // misread
  CHECK(unevenScaleOf({{100, 1}, {200, 10}, {300, 100}}).empty());           // too few
}

TEST_CASE("a break is two even runs of numbers, one behind the other") {
  struct Row {
    const char* what;
    std::vector<std::pair<double, double>> labels;
  };
  const Row breaks[] = {
      {"other distances behind it, the corner's zero twice",
       {{535, 0}, {520, 0}, {416, 20}, {313, 40}, {212, 60}, {187, 80}, {140, 100}, {95, 120}}},
      {"the same from the left", {{-15, 0}, {0, 0}, {104, 20}, {207, 40}, {308, 60}, {333, 80}, {380, 100}}},
      {"five numbers, the last two on from another number", {{0, 0}, {100, 1}, {200, 2}, {250, 7}, {350, 8}}},
      {"five numbers, the first two before another number",
       {{0, 0}, {100, 10}, {130, 50}, {230, 60}, {330, 70}}},
      {"forces downwards", {{50, 0}, {150, 20}, {250, 40}, {280, 100}, {380, 120}}},
      {"negative numbers", {{0, -40}, {100, -20}, {200, 0}, {230, 60}, {330, 80}}},
      {"negative forces downwards", {{0, 0}, {100, -20}, {200, -40}, {230, -100}, {330, -120}}},
      {"tenths, positions within a pixel",
       {{0, 0}, {101, 0.1}, {199, 0.2}, {300, 0.3}, {340, 0.7}, {441, 0.8}, {540, 0.9}}},
      {"a number of a run that could not be read",
       {{0, 0}, {100, 10}, {300, 30}, {330, 70}, {430, 80}, {530, 90}}},
      {"its signs read as digits",
       {{520, 0}, {416, 20}, {313, 40}, {206, 607}, {182, 807}, {118, 100}, {50, 120}}}};
  const Row others[] = {
      {"four numbers: two runs go through any", {{0, 0}, {100, 1}, {150, 7}, {250, 8}}},
      {"even, a number missing", {{0, 0}, {100, 10}, {200, 20}, {400, 40}, {500, 50}}},
      {"even, positions within two pixels", {{0, 0}, {102, 10}, {198, 20}, {302, 30}, {400, 40}}},
      {"even, rounded numbers", {{0, 0}, {100, 0.3}, {200, 0.7}, {300, 1}, {400, 1.3}, {500, 1.7}, {600, 2}}},
      {"the last number misread", {{0, 0}, {100, 10}, {200, 20}, {300, 30}, {400, 46}}},
      {"misread by whole steps", {{0, 0}, {100, 10}, {200, 20}, {300, 30}, {400, 80}}},
      {"the point of the last number lost, others missing",
       {{60, 0}, {205, 1}, {352, 2}, {425, 2.5}, {497, 3}, {643, 4}, {716, 45}}},
      {"the first number misread", {{0, -40}, {100, 10}, {200, 20}, {300, 30}, {400, 40}, {500, 50}}},
      {"a number in the middle misread",
       {{0, 0}, {100, 10}, {200, 20}, {300, 38}, {400, 40}, {500, 50}, {600, 60}}},
      {"three of them without their points", {{0, 0}, {100, 0.5}, {200, 1}, {300, 15}, {500, 25}, {600, 30}}},
      {"two of them misread, not by whole steps",
       {{0, 0}, {100, 10}, {200, 20}, {300, 30}, {500, 74}, {600, 84}}},
      {"the zero in the corner beside its tick",
       {{-60, 0}, {100, 1}, {200, 2}, {300, 3}, {400, 4}, {500, 5}}},
      {"in perspective", {{0, 0}, {140, 1}, {252, 2}, {342, 3}, {414, 4}, {472, 5}}},
      {"two numbers at one position", {{0, 0}, {100, 1}, {200, 2}, {250, 7}, {250, 8}}}};
  for (const Row& row : breaks) {
    INFO(row.what);
    CHECK(unevenScaleOf(row.labels) == "values on a scale with a break");
  }
  for (const Row& row : others) {
    INFO(row.what);
    CHECK(unevenScaleOf(row.labels) != "values on a scale with a break");
  }
  CHECK(unevenScaleOf({}).empty());
  // Two even runs, but the evener distances of their labels say more.
  CHECK(unevenScaleOf({{0, 0}, {100, 1}, {200, 2}, {300, 7}, {400, 8}}) == "categories, not to scale");
  CHECK(unevenScaleOf({{0, 1}, {30, 2}, {70, 5}, {100, 10}, {130, 20}, {170, 50}, {200, 100}}) ==
        "values on a logarithmic scale");
}

TEST_CASE("numbers that count unevenly at even places are no scale, unless a misread one explains them") {
  struct Row {
    const char* what;
    std::vector<double> values, confidences;
    std::vector<int> readings;  // of the progression; -1: aside
    bool uneven;
  };
  for (const Row& row :
       {Row{"five of six in order",
            {80, 60, 40, 20, 10, 0},
            {.95, .91, .96, .96, .96, .89},
            {0, 0, 0, 0, -1, -1},
            true},
        {"two read with doubt",
         {80, 60, 40, 20, 10, 0},
         {.95, .91, .96, .8, .96, .89},
         {0, 0, 0, 0, -1, -1},
         false},
        {"one misread", {80, 64, 48, 32, 10, 0}, {.95, .95, .95, .95, .95, .95}, {0, 0, 0, 0, -1, 0}, false},
        {"one aside, and the corner's zero",
         {80, 64, 48, 32, 10, 0, 0},
         {.95, .95, .95, .95, .95, .95, .95},
         {0, 0, 0, 0, -1, 0, -1},
         false},
        {"not in order",
         {80, 60, 40, 20, 50, 0},
         {.95, .95, .95, .95, .95, .95},
         {0, 0, 0, 0, -1, -1},
         false}}) {
    INFO(row.what);
    AxisLabels read;
    read.progression.emplace();
    for (std::size_t i = 0; i < row.values.size(); ++i) {
      const double y = 88.5 + 114.8 * static_cast<double>(i);
      read.words.push_back({"", {60, y - 5, 80, y + 5}, row.confidences[i]});
      read.readings.push_back({{row.values[i], 1}});
    }
    read.progression->reading = row.readings;
    CHECK(unevenRowIn(read, Axis::y) == (row.uneven ? categoriesScale : ""));
  }
}

TEST_CASE("ends that printed numbers confirm contradict an even scale between them") {
  struct Row {
    const char* what;
    std::vector<double> values;
    std::vector<int> readings;
    double top;
    bool uneven;
  };
  // the axis of a break: 0, 20 and 40 are even and put 90.95 at the top
  for (const Row& row :
       {Row{"the top's number confirms it", {100, 807, 607, 40, 20, 0}, {-1, -1, -1, 0, 0, 0}, 100, true},
        {"no number confirms the top", {60, 807, 607, 40, 20, 0}, {-1, -1, -1, 0, 0, 0}, 100, false},
        {"digits lost", {100, 8, 6, 4, 2, 0}, {-1, -1, -1, 0, 0, 0}, 100, false},
        {"the top is right", {90.95, 807, 607, 40, 20, 0}, {-1, -1, -1, 0, 0, 0}, 90.95, false},
        {"two numbers alone", {100, 807, 607, 47, 20, 0}, {-1, -1, -1, -1, 0, 0}, 100, false}}) {
    INFO(row.what);
    AxisLabels read;
    Progression& p = read.progression.emplace();
    p.reading = row.readings;
    p.tickOf = {49.53, 182.42, 206.42, 312.8, 416.2, 519.5};
    p.perPx = (row.values[4] - row.values[5]) / (416.2 - 519.5);
    p.offset = -519.5 * p.perPx;
    for (std::size_t i = 0; i < row.values.size(); ++i) {
      read.words.push_back({"", {60, p.tickOf[i] - 5, 80, p.tickOf[i] + 5}, i == 5 ? 0.89 : 0.96});
      read.readings.push_back({{row.values[i], 1}});
    }
    CHECK(isUnevenBetween(read, {49.53, row.top}, {519.5, 0}) == row.uneven);
  }
}

TEST_CASE("a break is seen with labels that were read with doubt, other scales without them") {
  const auto scaleOf = [](const std::vector<std::pair<double, double>>& labels,
                          const std::vector<double>& confidences) {
    AxisLabels read;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const auto [y, value] = labels[i];
      read.words.push_back({"", {60, y - 5, 80, y + 5}, confidences[i]});
      read.readings.push_back({{value, 1}});
    }
    return unevenScaleIn(read, Axis::y);
  };
  const std::vector<std::pair<double, double>> broken{{520, 0},   {416, 20},  {313, 40}, {210, 607},
                                                      {186, 807}, {118, 100}, {50, 120}};
  CHECK(scaleOf(broken, {0.89, 0.96, 0.96, 0.86, 0.8, 0.96, 0.96}) == "values on a scale with a break");
  CHECK(scaleOf({{0, 1000}, {100, 100}, {200, 10}, {300, 1}}, {0.95, 0.95, 0.95, 0.8}).empty());
  CHECK(scaleOf({{0, 1000}, {100, 100}, {200, 10}, {300, 1}}, {0.95, 0.95, 0.95, 0.95}) ==
        "values on a logarithmic scale");
}
