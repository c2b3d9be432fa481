// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/check_words.h"

#include <cmath>
#include <QCoreApplication>

#include "editor/document/state_name.h"
#include "editor/quantity/quantity.h"

namespace detent::editor {
namespace {

struct Checks {
  Q_DECLARE_TR_FUNCTIONS(Checks)
};

constexpr int digits = 4;

/// Wording of the values of one warning.
class Words {
 public:
  Words(const Warning& warning, const DisplayUnits& units) : warning_(warning), units_(units) {}
  QString place() const { return length(warning_.spot.at_mm.value_or(0)); }
  QString against() const { return length(warning_.against); }
  QString value() const {
    if (warning_.unit == "N") return quantityWithUnit(warning_.value, Quantity::force, units_, digits);
    return warning_.unit == "mm" ? length(warning_.value) : numberText(warning_.value, digits);
  }
  QString stroke() const {
    return warning_.spot.stroke == Stroke::release ? Checks::tr("release") : Checks::tr("press");
  }

 private:
  QString length(double mm) const { return quantityWithUnit(mm, Quantity::length, units_, digits); }
  const Warning& warning_;
  const DisplayUnits& units_;
};

QString sentenceOf(const Warning& warning, const Words& words) {
  switch (warning.rule) {
    case Rule::releaseAbovePress:
      return Checks::tr("The release lies %1 above the press at %2. Are press and release swapped?")
          .arg(words.value(), words.place());
    case Rule::strokesDoNotMeet:
      return Checks::tr("The release begins at %1, but the press ends at %3 (%2 apart).")
          .arg(words.place(), words.value(), words.against());
    case Rule::noRelease:
      return Checks::tr("There is no release curve; the press curve is used instead.");
    case Rule::negativeForce:
      return Checks::tr("The %1 force falls to %2 at %3; a negative force would pull the finger down.")
          .arg(words.stroke(), words.value(), words.place());
    case Rule::fallsAtStart:
      return Checks::tr("The press begins with a falling force; the button has no stable rest position.");
    case Rule::hiddenTactilePoint:
      return Checks::
          tr("The tactile point of the %1 at %2 lies inside an earlier jump, so the finger never feels it.")
              .arg(words.stroke(), words.place());
    case Rule::resetBeyondOperating:
      return Checks::tr("The reset point at %1 lies deeper than the operating point at %2.")
          .arg(words.place(), words.against());
    case Rule::statesDoNotMeet:
      return Checks::tr("The release ends at %1, but the next state starts at %3 (%2 apart).")
          .arg(words.place(), words.value(), words.against());
    case Rule::dampingOutsideTravel:
      return Checks::tr("A damping point lies at %1, but the travel ends at %2.")
          .arg(words.place(), words.against());
    case Rule::manyKnots:
      return Checks::tr(
                 "The %1 curve has %2 points, too many to edit by hand. Refit the curve with fewer pieces.")
          .arg(words.stroke(), words.value());
    case Rule::lowConfidence:
      return Checks::tr("The confidence of the import is only %1 %. Compare the curves with the page.")
          .arg(std::lround(100 * warning.value));
    case Rule::speedsGiveEnergy:
      return Checks::tr(
                 "At %4, the release at %1 mm/s lies %2 above the press at %3 mm/s: the button would return "
                 "more energy than it took up.")
          .arg(numberText(warning.spot.speed_mm_per_s.value_or(0), digits), words.value(),
               numberText(warning.against, digits), words.place());
  }
  return {};
}

QString nameOf(importer::SpecQuantity quantity) {
  switch (quantity) {
    case importer::SpecQuantity::totalTravel:
      return Checks::tr("Total travel");
    case importer::SpecQuantity::preTravel:
      return Checks::tr("Pre-travel");
    case importer::SpecQuantity::operatingForce:
      return Checks::tr("Operating force");
    case importer::SpecQuantity::tactileForce:
      return Checks::tr("Peak force");
    case importer::SpecQuantity::endForce:
      return Checks::tr("Force at the end");
  }
  return {};
}

}  // namespace

QString wordsOf(const Warning& warning, const Button& button, const DisplayUnits& units) {
  QString sentence = sentenceOf(warning, Words(warning, units));
  const auto state = warning.spot.state;
  if (!state || button.states().size() < 2) return sentence;
  return Checks::tr("State %1: %2").arg(nameOfState(button, *state), sentence);
}

QString wordsOf(const importer::SpecCheck& check, const DisplayUnits& units) {
  const Quantity quantity = check.spec.isForce() ? Quantity::force : Quantity::length;
  const auto text = [&](double value) { return quantityWithUnit(value, quantity, units, digits); };
  QString printed = text(check.spec.nominal);
  if (check.spec.smallest && check.spec.largest)
    printed += Checks::tr(" (%1 to %2)").arg(text(*check.spec.smallest), text(*check.spec.largest));
  return Checks::tr("%1: the datasheet states %2, the graph has %3.")
      .arg(nameOf(check.spec.quantity), printed, text(check.read));
}

}  // namespace detent::editor
