// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/units.h"

#include <array>
#include <string>

#include "model/check.h"

namespace detent {
namespace {

constexpr double standardGravity_m_per_s2 = 9.80665;  // exact by definition (3rd CGPM, 1901)
constexpr double newtonsPerPoundForce = 4.4482216152605;

struct ForceName {
  std::string_view name;
  ForceUnit unit;
};
struct LengthName {
  std::string_view name;
  LengthUnit unit;
};

// Symbols where case carries meaning: tried before anything is lowered ("MN" is not a unit of a button).
constexpr std::array exactForceSymbols{ForceName{"N", ForceUnit::newton},
                                       ForceName{"mN", ForceUnit::millinewton},
                                       ForceName{"cN", ForceUnit::centinewton},
                                       ForceName{"CN", ForceUnit::centinewton},
                                       ForceName{"n", ForceUnit::newton},
                                       ForceName{"dN", ForceUnit::decinewton},
                                       ForceName{"kN", ForceUnit::kilonewton},
                                       ForceName{"KN", ForceUnit::kilonewton},
                                       ForceName{"Н", ForceUnit::newton},
                                       ForceName{"мН", ForceUnit::millinewton},
                                       ForceName{"сН", ForceUnit::centinewton},
                                       ForceName{"гс", ForceUnit::gramForce},
                                       ForceName{"г", ForceUnit::gramForce},
                                       ForceName{"Г", ForceUnit::gramForce},
                                       ForceName{"кгс", ForceUnit::kilogramForce},
                                       ForceName{"кг", ForceUnit::kilogramForce},
                                       ForceName{"牛", ForceUnit::newton},
                                       ForceName{"牛顿", ForceUnit::newton},
                                       ForceName{"牛頓", ForceUnit::newton},
                                       ForceName{"ニュートン", ForceUnit::newton},
                                       ForceName{"克", ForceUnit::gramForce},
                                       ForceName{"克力", ForceUnit::gramForce},
                                       ForceName{"公克", ForceUnit::gramForce},
                                       ForceName{"グラム", ForceUnit::gramForce},
                                       ForceName{"그램", ForceUnit::gramForce},
                                       ForceName{"뉴턴", ForceUnit::newton},
                                       ForceName{"千克力", ForceUnit::kilogramForce},
                                       ForceName{"公斤", ForceUnit::kilogramForce},
                                       ForceName{"㎏", ForceUnit::kilogramForce},
                                       ForceName{"㎏f", ForceUnit::kilogramForce}};

constexpr std::array forceWords{ForceName{"newton", ForceUnit::newton},
                                ForceName{"newtons", ForceUnit::newton},
                                ForceName{"millinewton", ForceUnit::millinewton},
                                ForceName{"millinewtons", ForceUnit::millinewton},
                                ForceName{"centinewton", ForceUnit::centinewton},
                                ForceName{"centinewtons", ForceUnit::centinewton},
                                ForceName{"cn", ForceUnit::centinewton},
                                ForceName{"gf", ForceUnit::gramForce},
                                ForceName{"g", ForceUnit::gramForce},
                                ForceName{"gr", ForceUnit::gramForce},
                                ForceName{"grf", ForceUnit::gramForce},
                                ForceName{"gram", ForceUnit::gramForce},
                                ForceName{"grams", ForceUnit::gramForce},
                                ForceName{"gramme", ForceUnit::gramForce},
                                ForceName{"grammes", ForceUnit::gramForce},
                                ForceName{"gramm", ForceUnit::gramForce},
                                ForceName{"gram-force", ForceUnit::gramForce},
                                ForceName{"grams-force", ForceUnit::gramForce},
                                ForceName{"p", ForceUnit::gramForce},  // pond, on old German sheets
                                ForceName{"pond", ForceUnit::gramForce},
                                ForceName{"kgf", ForceUnit::kilogramForce},
                                ForceName{"kg", ForceUnit::kilogramForce},
                                ForceName{"kilogram-force", ForceUnit::kilogramForce},
                                ForceName{"kilogram", ForceUnit::kilogramForce},
                                ForceName{"kilograms", ForceUnit::kilogramForce},
                                ForceName{"ozf", ForceUnit::ounceForce},
                                ForceName{"oz", ForceUnit::ounceForce},
                                ForceName{"ounce", ForceUnit::ounceForce},
                                ForceName{"ounces", ForceUnit::ounceForce},
                                ForceName{"ounce-force", ForceUnit::ounceForce},
                                ForceName{"lbf", ForceUnit::poundForce},
                                ForceName{"lb", ForceUnit::poundForce},
                                ForceName{"lbs", ForceUnit::poundForce},
                                ForceName{"pound", ForceUnit::poundForce},
                                ForceName{"pounds", ForceUnit::poundForce},
                                ForceName{"gram force", ForceUnit::gramForce},
                                ForceName{"gf.", ForceUnit::gramForce},
                                ForceName{"g.f", ForceUnit::gramForce},
                                ForceName{"g.f.", ForceUnit::gramForce},
                                ForceName{"gr.", ForceUnit::gramForce},
                                ForceName{"gm", ForceUnit::gramForce},
                                ForceName{"gms", ForceUnit::gramForce},
                                ForceName{"kg.f", ForceUnit::kilogramForce},
                                ForceName{"kp", ForceUnit::kilogramForce},
                                ForceName{"kilopond", ForceUnit::kilogramForce},
                                ForceName{"oz.", ForceUnit::ounceForce},
                                ForceName{"oz.f", ForceUnit::ounceForce},
                                ForceName{"lb.", ForceUnit::poundForce},
                                ForceName{"lb.f", ForceUnit::poundForce},
                                ForceName{"lbs.", ForceUnit::poundForce},
                                ForceName{"decinewton", ForceUnit::decinewton},
                                ForceName{"decinewtons", ForceUnit::decinewton},
                                ForceName{"kilonewton", ForceUnit::kilonewton},
                                ForceName{"kilonewtons", ForceUnit::kilonewton},
                                ForceName{"dyn", ForceUnit::dyne},
                                ForceName{"dyne", ForceUnit::dyne},
                                ForceName{"dynes", ForceUnit::dyne}};

constexpr std::array lengthWords{LengthName{"mm", LengthUnit::millimetre},
                                 LengthName{"millimetre", LengthUnit::millimetre},
                                 LengthName{"millimetres", LengthUnit::millimetre},
                                 LengthName{"millimeter", LengthUnit::millimetre},
                                 LengthName{"millimeters", LengthUnit::millimetre},
                                 LengthName{"cm", LengthUnit::centimetre},
                                 LengthName{"centimetre", LengthUnit::centimetre},
                                 LengthName{"centimetres", LengthUnit::centimetre},
                                 LengthName{"centimeter", LengthUnit::centimetre},
                                 LengthName{"centimeters", LengthUnit::centimetre},
                                 LengthName{"um", LengthUnit::micrometre},
                                 LengthName{"\xC2\xB5m", LengthUnit::micrometre},
                                 LengthName{"\xCE\xBCm", LengthUnit::micrometre},
                                 LengthName{"micrometre", LengthUnit::micrometre},
                                 LengthName{"micrometres", LengthUnit::micrometre},
                                 LengthName{"micrometer", LengthUnit::micrometre},
                                 LengthName{"micrometers", LengthUnit::micrometre},
                                 LengthName{"micron", LengthUnit::micrometre},
                                 LengthName{"microns", LengthUnit::micrometre},
                                 LengthName{"in", LengthUnit::inch},
                                 LengthName{"inch", LengthUnit::inch},
                                 LengthName{"inches", LengthUnit::inch},
                                 LengthName{"\"", LengthUnit::inch},
                                 LengthName{"in.", LengthUnit::inch},
                                 LengthName{"mil", LengthUnit::mil},
                                 LengthName{"mils", LengthUnit::mil},
                                 LengthName{"thou", LengthUnit::mil},
                                 LengthName{"zoll", LengthUnit::inch},
                                 LengthName{"mm.", LengthUnit::millimetre},
                                 LengthName{"㎜", LengthUnit::millimetre},
                                 LengthName{"мм", LengthUnit::millimetre},
                                 LengthName{"毫米", LengthUnit::millimetre},
                                 LengthName{"公釐", LengthUnit::millimetre},
                                 LengthName{"公厘", LengthUnit::millimetre},
                                 LengthName{"ミリ", LengthUnit::millimetre},
                                 LengthName{"ミリメートル", LengthUnit::millimetre},
                                 LengthName{"㎝", LengthUnit::centimetre},
                                 LengthName{"см", LengthUnit::centimetre},
                                 LengthName{"厘米", LengthUnit::centimetre},
                                 LengthName{"㎛", LengthUnit::micrometre},
                                 LengthName{"мкм", LengthUnit::micrometre},
                                 LengthName{"微米", LengthUnit::micrometre},
                                 LengthName{"英寸", LengthUnit::inch},
                                 LengthName{"英吋", LengthUnit::inch},
                                 LengthName{"インチ", LengthUnit::inch},
                                 LengthName{"дюйм", LengthUnit::inch},
                                 LengthName{"ins", LengthUnit::inch}};

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

std::string lowered(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

// "MN" and "MM" would be mega: lowering them would silently be wrong by nine (or more) orders of magnitude.
bool isMegaNewton(std::string_view text) { return text == "MN" || text == "Mn"; }

}  // namespace

double newtonsPer(ForceUnit unit) {
  switch (unit) {
    case ForceUnit::newton:
      return 1;
    case ForceUnit::millinewton:
      return 1e-3;
    case ForceUnit::centinewton:
      return 1e-2;
    case ForceUnit::gramForce:
      return standardGravity_m_per_s2 / 1000;
    case ForceUnit::kilogramForce:
      return standardGravity_m_per_s2;
    case ForceUnit::ounceForce:
      return newtonsPerPoundForce / 16;
    case ForceUnit::poundForce:
      return newtonsPerPoundForce;
    case ForceUnit::decinewton:
      return 1e-1;
    case ForceUnit::kilonewton:
      return 1e3;
    case ForceUnit::dyne:
      return 1e-5;
  }
  DETENT_CHECK(false, "force unit is one of the enumeration");
  return 0;
}

double millimetresPer(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::millimetre:
      return 1;
    case LengthUnit::centimetre:
      return 10;
    case LengthUnit::micrometre:
      return 1e-3;
    case LengthUnit::inch:
      return 25.4;
    case LengthUnit::mil:
      return 0.0254;
  }
  DETENT_CHECK(false, "length unit is one of the enumeration");
  return 0;
}

std::string_view symbolOf(ForceUnit unit) {
  switch (unit) {
    case ForceUnit::newton:
      return "N";
    case ForceUnit::millinewton:
      return "mN";
    case ForceUnit::centinewton:
      return "cN";
    case ForceUnit::gramForce:
      return "gf";
    case ForceUnit::kilogramForce:
      return "kgf";
    case ForceUnit::ounceForce:
      return "ozf";
    case ForceUnit::poundForce:
      return "lbf";
    case ForceUnit::decinewton:
      return "dN";
    case ForceUnit::kilonewton:
      return "kN";
    case ForceUnit::dyne:
      return "dyn";
  }
  DETENT_CHECK(false, "force unit is one of the enumeration");
  return {};
}

std::string_view symbolOf(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::millimetre:
      return "mm";
    case LengthUnit::centimetre:
      return "cm";
    case LengthUnit::micrometre:
      return "\xC2\xB5m";
    case LengthUnit::inch:
      return "in";
    case LengthUnit::mil:
      return "mil";
  }
  DETENT_CHECK(false, "length unit is one of the enumeration");
  return {};
}

std::optional<ForceUnit> forceUnitFrom(std::string_view text) {
  const std::string_view symbol = trimmed(text);
  for (const ForceName& entry : exactForceSymbols)
    if (symbol == entry.name) return entry.unit;
  if (isMegaNewton(symbol)) return {};
  const std::string word = lowered(symbol);
  if (word == "mn") return ForceUnit::millinewton;
  for (const ForceName& entry : forceWords)
    if (word == entry.name) return entry.unit;
  return {};
}

std::optional<LengthUnit> lengthUnitFrom(std::string_view text) {
  const std::string word = lowered(trimmed(text));
  for (const LengthName& entry : lengthWords)
    if (word == entry.name) return entry.unit;
  return {};
}

}  // namespace detent
