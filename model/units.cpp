// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/units.h"

#include <algorithm>
#include <array>
#include <string>

#include "model/check.h"
#include "model/text.h"

namespace detent {
namespace {

constexpr double standardGravity_m_per_s2 = 9.80665;  // exact by definition (3rd CGPM, 1901)
constexpr double newtonsPerPoundForce = 4.4482216152605;

using Spellings = std::array<std::string_view, 20>;  // unused entries at the end are empty

/// Definition of a unit.
template <class Unit>
struct UnitEntry {
  Unit unit;
  double inBaseUnits;  // newtons, millimetres
  std::string_view symbol;
  Spellings exact;  // spellings whose case matters; tried before lowering
  Spellings words;  // in lower case
};

// "p" is pond, used on old German sheets.
constexpr UnitEntry<ForceUnit> forceUnits[] = {
    {ForceUnit::newton,
     1,
     "N",
     {"N", "n", "Н", "牛", "牛顿", "牛頓", "ニュートン", "뉴턴"},
     {"newton", "newtons"}},
    {ForceUnit::millinewton, 1e-3, "mN", {"mN", "мН"}, {"mn", "millinewton", "millinewtons"}},
    {ForceUnit::centinewton, 1e-2, "cN", {"cN", "CN", "сН"}, {"cn", "centinewton", "centinewtons"}},
    {ForceUnit::decinewton, 1e-1, "dN", {"dN"}, {"decinewton", "decinewtons"}},
    {ForceUnit::kilonewton, 1e3, "kN", {"kN", "KN"}, {"kilonewton", "kilonewtons"}},
    {ForceUnit::dyne, 1e-5, "dyn", {}, {"dyn", "dyne", "dynes"}},
    {ForceUnit::micronewton,
     1e-6,
     "\xC2\xB5N",
     {"uN", "\xC2\xB5N", "\xCE\xBCN", "мкН"},
     {"micronewton", "micronewtons"}},
    {ForceUnit::meganewton, 1e6, "MN", {"MN", "МН"}, {"meganewton", "meganewtons"}},
    {ForceUnit::gramForce,
     standardGravity_m_per_s2 / 1000,
     "gf",
     {"гс", "г", "Г", "克", "克力", "公克", "グラム", "그램"},
     {"gf",    "gf.",        "g",           "g.f",        "g.f.",  "gr",     "gr.",
      "grf",   "gm",         "gms",         "gram",       "grams", "gramme", "grammes",
      "gramm", "gram-force", "grams-force", "gram force", "p",     "pond"}},
    {ForceUnit::kilogramForce,
     standardGravity_m_per_s2,
     "kgf",
     {"кгс", "кг", "千克力", "公斤", "㎏", "㎏f"},
     {"kgf", "kg", "kg.f", "kp", "kilopond", "kilogram", "kilograms", "kilogram-force"}},
    {ForceUnit::ounceForce,
     newtonsPerPoundForce / 16,
     "ozf",
     {},
     {"ozf", "oz", "oz.", "oz.f", "ounce", "ounces", "ounce-force"}},
    {ForceUnit::poundForce,
     newtonsPerPoundForce,
     "lbf",
     {},
     {"lbf", "lb", "lb.", "lb.f", "lbs", "lbs.", "pound", "pounds"}}};

// The second spelling of micrometres has the micro sign, the third a Greek mu.
constexpr UnitEntry<LengthUnit> lengthUnits[] = {
    {LengthUnit::millimetre,
     1,
     "mm",
     {},
     {"mm", "mm.", "millimetre", "millimetres", "millimeter", "millimeters", "㎜", "мм", "毫米", "公釐",
      "公厘", "ミリ", "ミリメートル"}},
    {LengthUnit::centimetre,
     10,
     "cm",
     {},
     {"cm", "centimetre", "centimetres", "centimeter", "centimeters", "㎝", "см", "厘米"}},
    {LengthUnit::micrometre,
     1e-3,
     "\xC2\xB5m",
     {},
     {"um", "\xC2\xB5m", "\xCE\xBCm", "micrometre", "micrometres", "micrometer", "micrometers", "micron",
      "microns", "㎛", "мкм", "微米"}},
    {LengthUnit::inch,
     25.4,
     "in",
     {},
     {"in", "in.", "ins", "inch", "inches", "\"", "zoll", "英寸", "英吋", "インチ", "дюйм"}},
    {LengthUnit::mil, 0.0254, "mil", {}, {"mil", "mils", "thou"}},
    {LengthUnit::metre, 1e3, "m", {"m", "м"}, {"metre", "metres", "meter", "meters", "米"}},
    {LengthUnit::nanometre,
     1e-6,
     "nm",
     {"nm", "нм"},
     {"nanometre", "nanometres", "nanometer", "nanometers", "纳米"}}};

template <class Unit, std::size_t count>
const UnitEntry<Unit>& entryOf(const UnitEntry<Unit> (&units)[count], Unit unit) {
  const auto found = std::ranges::find(units, unit, &UnitEntry<Unit>::unit);
  DETENT_CHECK(found != std::end(units), "unit is one of the enumeration");
  return *found;
}

template <class Unit, std::size_t count>
std::optional<Unit> unitFrom(const UnitEntry<Unit> (&units)[count], std::string_view text) {
  const std::string_view symbol = trimmed(text);
  if (symbol.empty()) return {};
  for (const auto& entry : units)
    if (std::ranges::find(entry.exact, symbol) != entry.exact.end()) return entry.unit;
  const std::string word = lowered(symbol);
  for (const auto& entry : units)
    if (std::ranges::find(entry.words, word) != entry.words.end()) return entry.unit;
  return {};
}

// "Mn" may be mega or milli; lowering it could be wrong by nine orders of magnitude.
bool mayBeMega(std::string_view text) { return text == "Mn"; }

}  // namespace

double newtonsPer(ForceUnit unit) { return entryOf(forceUnits, unit).inBaseUnits; }
double millimetresPer(LengthUnit unit) { return entryOf(lengthUnits, unit).inBaseUnits; }

std::string_view symbolOf(ForceUnit unit) { return entryOf(forceUnits, unit).symbol; }
std::string_view symbolOf(LengthUnit unit) { return entryOf(lengthUnits, unit).symbol; }

std::optional<ForceUnit> forceUnitFrom(std::string_view text) {
  if (mayBeMega(trimmed(text))) return {};
  return unitFrom(forceUnits, text);
}

std::optional<LengthUnit> lengthUnitFrom(std::string_view text) { return unitFrom(lengthUnits, text); }

}  // namespace detent
