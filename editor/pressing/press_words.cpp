// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/pressing/press_words.h"

#include <algorithm>
#include <cmath>
#include <QCoreApplication>

#include "editor/document/number_text.h"

namespace detent::editor {

namespace {

using playback::Band;
using playback::Claim;
using playback::NoForecast;
using playback::PressFigure;

constexpr double perSecond_ms = 1000;

QString tr(const char* text) { return QCoreApplication::translate("PressForecast", text); }

PressTerm ofThousand(const QString& name, const QString& definition) {
  return {name, tr("per 1,000"), definition, 1};
}

PressTerm inMilliseconds(const QString& name, const QString& definition) {
  return {name, QStringLiteral("ms"), definition, perSecond_ms};
}

// So that the median has two digits.
int decimalsFor(double median) {
  constexpr int mostDecimals = 4;
  if (!(median > 0)) return 0;
  return std::clamp(1 - static_cast<int>(std::floor(std::log10(median))), 0, mostDecimals);
}

}  // namespace

PressTerm termOf(PressFigure figure, const DisplayUnits& units) {
  switch (figure) {
    case PressFigure::peakForce:
      return {tr("Peak force of the fingertip"), units.forceSymbol(),
              tr("The most force of the fingertip in one press, bottoming out included"), units.forceFrom(1)};
    case PressFigure::impulse:
      return {tr("Impulse"), QStringLiteral("mN s"),
              tr("Force of the fingertip summed over the time of a press"), 1000};
    case PressFigure::activation:
      return inMilliseconds(tr("Touch to activation"), tr("From touching the cap until the contact closes"));
    case PressFigure::activationSpread:
      return inMilliseconds(tr("Its spread"),
                            tr("Standard deviation of the time to activation of one finger"));
    case PressFigure::misses:
      return ofThousand(tr("Misses"), tr("Presses that do not close the contact"));
    case PressFigure::doubles:
      return ofThousand(tr("Doubles"), tr("Presses that close the contact twice"));
    case PressFigure::accidental:
      return ofThousand(tr("Accidental activations"), tr("Times that a resting finger closes the contact"));
    case PressFigure::highestRate:
      return {tr("Highest steady rate"), tr("presses/s"),
              tr("Most presses per second with at most 5 % misses and 5 % doubles"), 1};
    case PressFigure::timePerPress:
      return inMilliseconds(tr("Time per correct press"), tr("With the time that misses and doubles cost"));
    case PressFigure::timedMisses:
      return ofThousand(tr("Misses of a window of 100 ms"),
                        tr("Presses in time with a cue half a second ahead that come too early or too late"));
    case PressFigure::held:
      return inMilliseconds(tr("Contact closed"), tr("How long one press keeps the contact closed"));
    case PressFigure::rapidHeld:
      return inMilliseconds(tr("Contact closed, rapid trigger"),
                            tr("The same where the contact opens 0.2 mm above the deepest place"));
    case PressFigure::rapidDoubles:
      return ofThousand(tr("Doubles, rapid trigger"),
                        tr("The same where the contact opens 0.2 mm above the deepest place"));
  }
  return {};
}

QString bandWords(const playback::PressForecast& forecast, PressFigure figure, const DisplayUnits& units) {
  const std::vector<double>& ofFingers = forecast[figure];
  if (ofFingers.empty()) return tr("no forecast");
  const PressTerm term = termOf(figure, units);
  const Band band = playback::bandOf(ofFingers);
  const int decimals = decimalsFor(band.median * term.factor);
  const auto text = [&](double value) { return fixedText(value * term.factor, decimals); };
  return tr("%1 (%2 to %3)").arg(text(band.median), text(band.low), text(band.high));
}

QString reasonWords(NoForecast reason) {
  switch (reason) {
    case NoForecast::none:
      return {};
    case NoForecast::noOperatingPoint:
      return tr("The button has no operating point. Set one, or say below where it would act.");
    case NoForecast::operatingPointOutside:
      return tr("The operating point is not within the travel. Enter one within it.");
    case NoForecast::tooLight:
      return tr("Its force stays below 0.02 N: the finger's own weight is all there is.");
    case NoForecast::tooHeavy:
      return tr("30 N of muscle do not close its contact for every finger.");
    case NoForecast::noRelease:
      return tr("It has no release curve. Draw one.");
    case NoForecast::selfLocking:
      return tr("It locks: one cycle takes two presses, and only the first is forecast.");
  }
  return {};
}

QString differenceWords(const playback::PressDifference& difference) {
  const QString ratio = fixedText(difference.ratio.median, 2);
  switch (difference.claim) {
    case Claim::notForecast:
      return tr("no forecast");
    case Claim::noDifference:
      return tr("no difference forecast");
    case Claim::higher:
      return tr("higher, × %1").arg(ratio);
    case Claim::lower:
      return tr("lower, × %1").arg(ratio);
    case Claim::notDecided:
      return tr("not decided");
  }
  return {};
}

}  // namespace detent::editor
