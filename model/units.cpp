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
constexpr std::array<ForceName, 5> exactForceSymbols{{{"N", ForceUnit::newton},
                                                      {"mN", ForceUnit::millinewton},
                                                      {"cN", ForceUnit::centinewton},
                                                      {"CN", ForceUnit::centinewton},
                                                      {"n", ForceUnit::newton}}};

constexpr std::array<ForceName, 36> forceWords{{{"newton", ForceUnit::newton},
                                                {"newtons", ForceUnit::newton},
                                                {"millinewton", ForceUnit::millinewton},
                                                {"millinewtons", ForceUnit::millinewton},
                                                {"centinewton", ForceUnit::centinewton},
                                                {"centinewtons", ForceUnit::centinewton},
                                                {"cn", ForceUnit::centinewton},
                                                {"gf", ForceUnit::gramForce},
                                                {"g", ForceUnit::gramForce},
                                                {"gr", ForceUnit::gramForce},
                                                {"grf", ForceUnit::gramForce},
                                                {"gram", ForceUnit::gramForce},
                                                {"grams", ForceUnit::gramForce},
                                                {"gramme", ForceUnit::gramForce},
                                                {"grammes", ForceUnit::gramForce},
                                                {"gramm", ForceUnit::gramForce},
                                                {"gram-force", ForceUnit::gramForce},
                                                {"grams-force", ForceUnit::gramForce},
                                                {"gram force", ForceUnit::gramForce},
                                                {"p", ForceUnit::gramForce},  // pond, on old German sheets
                                                {"pond", ForceUnit::gramForce},
                                                {"kgf", ForceUnit::kilogramForce},
                                                {"kg", ForceUnit::kilogramForce},
                                                {"kilogram-force", ForceUnit::kilogramForce},
                                                {"kilogram", ForceUnit::kilogramForce},
                                                {"kilograms", ForceUnit::kilogramForce},
                                                {"ozf", ForceUnit::ounceForce},
                                                {"oz", ForceUnit::ounceForce},
                                                {"ounce", ForceUnit::ounceForce},
                                                {"ounces", ForceUnit::ounceForce},
                                                {"ounce-force", ForceUnit::ounceForce},
                                                {"lbf", ForceUnit::poundForce},
                                                {"lb", ForceUnit::poundForce},
                                                {"lbs", ForceUnit::poundForce},
                                                {"pound", ForceUnit::poundForce},
                                                {"pounds", ForceUnit::poundForce}}};

constexpr std::array<LengthName, 28> lengthWords{{{"mm", LengthUnit::millimetre},
                                                  {"millimetre", LengthUnit::millimetre},
                                                  {"millimetres", LengthUnit::millimetre},
                                                  {"millimeter", LengthUnit::millimetre},
                                                  {"millimeters", LengthUnit::millimetre},
                                                  {"cm", LengthUnit::centimetre},
                                                  {"centimetre", LengthUnit::centimetre},
                                                  {"centimetres", LengthUnit::centimetre},
                                                  {"centimeter", LengthUnit::centimetre},
                                                  {"centimeters", LengthUnit::centimetre},
                                                  {"um", LengthUnit::micrometre},
                                                  {"\xC2\xB5m", LengthUnit::micrometre},
                                                  {"\xCE\xBCm", LengthUnit::micrometre},
                                                  {"micrometre", LengthUnit::micrometre},
                                                  {"micrometres", LengthUnit::micrometre},
                                                  {"micrometer", LengthUnit::micrometre},
                                                  {"micrometers", LengthUnit::micrometre},
                                                  {"micron", LengthUnit::micrometre},
                                                  {"microns", LengthUnit::micrometre},
                                                  {"in", LengthUnit::inch},
                                                  {"inch", LengthUnit::inch},
                                                  {"inches", LengthUnit::inch},
                                                  {"\"", LengthUnit::inch},
                                                  {"in.", LengthUnit::inch},
                                                  {"mil", LengthUnit::mil},
                                                  {"mils", LengthUnit::mil},
                                                  {"thou", LengthUnit::mil},
                                                  {"zoll", LengthUnit::inch}}};

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
