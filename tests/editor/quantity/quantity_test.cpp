// SPDX-License-Identifier: GPL-3.0-or-later
// Every quantity x locale x unit: what is shown can be typed back, and no text means two numbers.
#include <array>
#include <cmath>
#include <QLocale>

#include <rapidcheck.h>

#include "editor/document/message_words.h"
#include "editor/quantity/reading_error.h"
#include "tests/model/property.h"

using namespace detent;
using namespace detent::editor;
using detent::tests::holdsAlways;

namespace {

const std::array locales{"C",     "en_US", "de_DE", "de_CH", "fr_FR",
                         "sv_SE", "en_IN", "ar_EG", "fa_IR", "pt_BR"};
constexpr std::array lengths{LengthUnit::millimetre, LengthUnit::centimetre, LengthUnit::micrometre,
                             LengthUnit::inch, LengthUnit::mil};
constexpr std::array forces{ForceUnit::newton,    ForceUnit::millinewton,   ForceUnit::centinewton,
                            ForceUnit::gramForce, ForceUnit::kilogramForce, ForceUnit::ounceForce,
                            ForceUnit::poundForce};
constexpr std::array quantities{Quantity::length,  Quantity::force, Quantity::slope,
                                Quantity::damping, Quantity::share, Quantity::number};

class InLocale {
 public:
  explicit InLocale(const char* name) { QLocale::setDefault(QLocale(QLatin1String(name))); }
  ~InLocale() { QLocale::setDefault(QLocale::c()); }
  InLocale(const InLocale&) = delete;
  InLocale& operator=(const InLocale&) = delete;
};

bool near(double a, double b, double relative = 1e-9) {
  return std::abs(a - b) <= relative * std::max(std::abs(a), std::abs(b));
}

// Values of a caliper or a datasheet, of any sign and size.
rc::Gen<double> anyValue() {
  return rc::gen::map(
      rc::gen::tuple(rc::gen::inRange(-999999, 1000000), rc::gen::inRange(-6, 3)),
      [](const std::tuple<int, int>& t) { return std::get<0>(t) * std::pow(10.0, std::get<1>(t)); });
}

rc::Gen<DisplayUnits> anyUnits() {
  return rc::gen::map(rc::gen::pair(rc::gen::elementOf(lengths), rc::gen::elementOf(forces)),
                      [](const std::pair<LengthUnit, ForceUnit>& u) {
                        return DisplayUnits{u.first, u.second};
                      });
}

std::optional<double> value(const char* text, Quantity quantity, const DisplayUnits& units = {},
                            std::optional<double> now = {}) {
  return readQuantity(QString::fromUtf8(text), quantity, units, now).value;
}

}  // namespace

TEST_CASE("What is shown is read back, whatever the locale, the unit and the quantity") {
  holdsAlways("with and without its unit", [] {
    const InLocale here(*rc::gen::elementOf(locales));
    const DisplayUnits units = *anyUnits();
    const Quantity quantity = *rc::gen::elementOf(quantities);
    const double shown = *anyValue(), base = shown * shownUnitOf(quantity, units);
    for (const QString& text :
         {quantityText(base, quantity, units, 12), quantityWithUnit(base, quantity, units, 12)}) {
      const QuantityReading reading = readQuantity(text, quantity, units);
      RC_ASSERT(reading.value.has_value());
      RC_ASSERT(near(*reading.value, base, 1e-10));
      RC_ASSERT(near(reading.shown, shown, 1e-10));
    }
  });
  holdsAlways("in a sentence that refuses or warns", [] {
    const InLocale here(*rc::gen::elementOf(locales));
    const DisplayUnits units = *anyUnits();
    const double length = std::abs(*anyValue()), force = *anyValue();
    const QString said =
        inWords(Message("%1|%2", millimetres(units.toMm(length)), newtons(units.toN(force))), units);
    const auto mm = readQuantity(said.section('|', 0, 0), Quantity::length, units);
    const auto N = readQuantity(said.section('|', 1, 1), Quantity::force, units);
    RC_ASSERT(mm.value && N.value);
    RC_ASSERT(near(mm.shown, length, 6e-6));
    RC_ASSERT(near(N.shown, force, 6e-6));
  });
  holdsAlways("numbers have no sign between thousands, and only this locale's or a point before decimals",
              [] {
                const InLocale here(*rc::gen::elementOf(locales));
                const double shown = *anyValue();
                for (const QString& text : {numberText(shown, 12), fixedText(shown, 3)}) {
                  int signs = 0;
                  for (const QChar c : text) {
                    RC_ASSERT(c.isDigit() || c == '-' || c == '+' || c == 'e' || c == '.' || c == ',');
                    signs += c == '.' || c == ',';
                  }
                  RC_ASSERT(signs <= 1);
                }
              });
}

TEST_CASE("A typed number means the same in every locale") {
  holdsAlways("both decimal signs, any known unit", [] {
    const DisplayUnits units = *anyUnits();
    const int whole = *rc::gen::inRange(0, 100000), decimals = *rc::gen::inRange(0, 1000);
    const LengthUnit typedUnit = *rc::gen::elementOf(lengths);
    const double expected = (whole + decimals / 1000.0) * millimetresPer(typedUnit);
    const QString unit =
        QString::fromUtf8(symbolOf(typedUnit).data(), static_cast<qsizetype>(symbolOf(typedUnit).size()));
    for (const char* locale : locales) {
      const InLocale here(locale);
      for (const QChar sign : {QChar('.'), QChar(',')}) {
        const QString text =
            QString::number(whole) + sign + QString::number(decimals).rightJustified(3, '0') + " " + unit;
        const auto read = readQuantity(text, Quantity::length, units).value;
        RC_ASSERT(read.has_value());
        RC_ASSERT(near(*read, expected) || expected == 0);
      }
    }
  });
  for (const char* name : locales) {
    const InLocale here(name);
    const DisplayUnits microns{LengthUnit::micrometre, ForceUnit::gramForce};
    CHECK(*value("1,305", Quantity::length, microns) == Approx(0.001305));
    CHECK(*value("120.5", Quantity::force, microns) == Approx(120.5 * 0.00980665));
    CHECK(*value("4.5 mm", Quantity::length, microns) == Approx(4.5));
    CHECK(*value("1,250", Quantity::length) == Approx(1.25));
  }
}

TEST_CASE("What could be read in two ways is refused, and says so") {
  for (const char* text : {"1,250.5", "1.250,5", "1 250", "1'250", "1’250", "1.250.000", "1,2,3"}) {
    const QuantityReading reading = readQuantity(QString::fromUtf8(text), Quantity::length, {});
    INFO(text);
    CHECK_FALSE(reading.value);
    CHECK(reading.trouble == QuantityTrouble::groupSeparator);
    CHECK_FALSE(refusalOf(reading, Quantity::length, {}).isEmpty());
  }
  CHECK(readQuantity("50 + 5 gf", Quantity::force, {}).trouble == QuantityTrouble::mixedUnits);
  CHECK(*value("50 + 5 cN", Quantity::force) == Approx(0.55));
}

TEST_CASE("Sums, products and changes of what stands there") {
  CHECK(*value("50+5", Quantity::force) == Approx(0.55));
  CHECK(*value("2*0.3 mm", Quantity::length) == Approx(0.6));
  CHECK(*value("(1+2)/4 mm", Quantity::length) == Approx(0.75));
  CHECK(*value("1 in - 0,4mm", Quantity::length) == Approx(25));
  CHECK(*value("20 N/mm", Quantity::slope) == Approx(20));
  CHECK(*value("5 gf / 0.1 in", Quantity::slope) == Approx(5 * 0.00980665 / 2.54));
  CHECK(*value("2 cN/mm + 3", Quantity::slope) == Approx(0.05));
  CHECK(*value("0.002 N·s/mm", Quantity::damping) == Approx(0.002));
  CHECK(*value("0,2", Quantity::damping) == Approx(0.002));  // cN·s/mm are shown
  CHECK(*value("3/4 mm", Quantity::length) == Approx(0.75));
  CHECK(*value("+5", Quantity::force, {}, 0.5) == Approx(0.55));
  CHECK(*value("+5 gf", Quantity::force, {}, 0.5) == Approx(0.5 + 5 * 0.00980665));
  CHECK(*value("-=5", Quantity::force, {}, 0.5) == Approx(0.45));
  CHECK(*value("-5", Quantity::force, {}, 0.5) == Approx(-0.05));
  CHECK(*value("\u2212"
               "5",
               Quantity::force, {}, 0.5) == Approx(-0.05));
  CHECK(*value("-10 %", Quantity::force, {}, 0.5) == Approx(0.45));
  CHECK(*value("+10%", Quantity::force, {}, 0.5) == Approx(0.55));
  CHECK(*value("50 %", Quantity::force, {}, 0.5) == Approx(0.25));
  CHECK(*value("30 %", Quantity::share, {}, 0.5) == Approx(0.3));
  CHECK(*value("30", Quantity::share, {}, 0.5) == Approx(0.3));  // percent are shown
  CHECK(*value("+5", Quantity::share, {}, 0.5) == Approx(0.55));
  CHECK(*value("+10 %", Quantity::share, {}, 0.5) == Approx(0.55));
  CHECK(*value("+5", Quantity::force) == Approx(0.05));  // nothing to add to: the number
  CHECK(*value("300 dpi", Quantity::resolution) == 300);
}

TEST_CASE("What is no quantity of this kind is refused with its reason") {
  const auto trouble = [](const char* text, Quantity quantity) {
    const QuantityReading reading = readQuantity(QString::fromUtf8(text), quantity, {});
    CHECK_FALSE(reading.value);
    return reading.trouble;
  };
  using enum QuantityTrouble;
  CHECK(trouble("", Quantity::length) == empty);
  CHECK(trouble("  ", Quantity::length) == empty);
  CHECK(trouble("about two", Quantity::length) == unknownUnit);
  CHECK(trouble("mm", Quantity::length) == noNumber);
  CHECK(trouble("5 +", Quantity::length) == noNumber);
  CHECK(trouble("(5", Quantity::length) == noNumber);
  CHECK(trouble("5)", Quantity::length) == noNumber);
  CHECK(trouble("5 apples", Quantity::length) == unknownUnit);
  CHECK(trouble("5 Mn", Quantity::force) == unknownUnit);
  CHECK(trouble("5 gf", Quantity::length) == otherQuantity);
  CHECK(trouble("5 mm * 2 mm", Quantity::length) == otherQuantity);
  CHECK(trouble("5 mm", Quantity::number) == otherQuantity);
  CHECK(trouble("+10 %", Quantity::length) == nothingToChange);
  CHECK(trouble("1.5", Quantity::count) == notWhole);
  CHECK(trouble("1/0", Quantity::length) == notFinite);
  CHECK(trouble("1/0 mm", Quantity::slope) == notFinite);
  CHECK(trouble("1/(0/0)", Quantity::length) == notFinite);
  CHECK(trouble("1e400", Quantity::length) == notFinite);
  CHECK(
      refusalOf(readQuantity("1/0", Quantity::length, {}), Quantity::length, {}).contains("divides by zero"));
  CHECK(trouble("nan", Quantity::length) == unknownUnit);
  CHECK(trouble("inf", Quantity::length) == unknownUnit);
  CHECK(trouble(std::string(500, '(').c_str(), Quantity::length) == noNumber);
}

TEST_CASE("What was read off a page has the digits its error leaves, what was typed its own") {
  const ReadingError error{0.002, 0.003};
  DisplayUnits units{LengthUnit::millimetre, ForceUnit::centinewton};
  CHECK(readText(0.7997213456, Quantity::force, units, error) == "80.0");
  CHECK(readText(0.7997213456, Quantity::force, units, {}) == "79.972");
  CHECK(readText(0.7997213456, Quantity::force, units, {}, 4) == "79.97");
  CHECK(readText(0.56123, Quantity::force, units, error) == "56.123");
  CHECK(readText(1.2504567891, Quantity::length, units, error) == "1.250");
  CHECK(readText(1.2345678912, Quantity::slope, units, error) == "123");
  units.length = LengthUnit::micrometre;
  CHECK(readText(1.2504567891, Quantity::length, units, error) == "1250");
  // Zeros before the first digit are no digits: 4 mm are not 0.16 in.
  units.length = LengthUnit::inch;
  CHECK(readText(3.9998123456, Quantity::length, units, ReadingError{0.0005, 0.003}, 3) == "0.157");
  CHECK(readText(0.3000123456, Quantity::length, units, ReadingError{0.0005, 0.003}, 3) == "0.0118");
}

TEST_CASE("Any text is read or refused, never both, never without a word") {
  holdsAlways("random texts of what people type", [] {
    const std::string text = *rc::gen::container<std::string>(
        rc::gen::elementOf(std::string("0123456789.,+-*/()% mcNgfinµe'=x\"")));
    const QuantityReading reading = readQuantity(QString::fromStdString(text), Quantity::length, {}, 1.5);
    if (reading.value)
      RC_ASSERT(std::isfinite(*reading.value));
    else
      RC_ASSERT(!refusalOf(reading, Quantity::length, {}).isEmpty());
  });
}

TEST_CASE("what no button has is asked about, with the unit that was meant") {
  const DisplayUnits newtons{LengthUnit::millimetre, ForceUnit::newton};
  const auto doubt = [&](const char* text, Quantity quantity) {
    return doubtOf(text, *readQuantity(text, quantity, newtons).value, quantity, newtons).toStdString();
  };
  CHECK_THAT(doubt("2000", Quantity::force), Catch::Contains("2000 mN"));
  CHECK_THAT(doubt("60 lbf", Quantity::force), Catch::Contains("60 gf"));
  CHECK_THAT(doubt("40", Quantity::length), Catch::Contains("40 mm") && Catch::Contains("40 mil"));
  CHECK_THAT(doubt("-60", Quantity::force), Catch::Contains("-60 gf"));
  CHECK(doubt("20", Quantity::force).empty());
  CHECK(doubt("60 gf", Quantity::force).empty());
  CHECK(doubt("4", Quantity::length).empty());
  CHECK(doubt("1e6", Quantity::slope).empty());
  CHECK_THAT(doubt("3000", Quantity::share), Catch::Contains("3000 %"));
  CHECK_THAT(doubt("0.3", Quantity::share), Catch::Contains("0.3 %") && Catch::Contains("30 %"));
  CHECK(doubt("0.3 %", Quantity::share).empty());
  CHECK(doubt("30", Quantity::share).empty());
  CHECK(doubt("100", Quantity::share).empty());
}
