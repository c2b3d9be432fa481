// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/feel/force_words.h"

#include <algorithm>
#include <cmath>
#include <QCoreApplication>
#include <QStringList>

#include "editor/document/message_words.h"
#include "editor/quantity/quantity.h"

namespace detent::editor {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("ForceWords", text); }

QString shown(double value, Quantity quantity, const DisplayUnits& units) {
  return quantityWithUnit(value, quantity, units, 3);
}

/// State and colon ("locked: ") for a self-locking button, otherwise empty.
QString stateBefore(const Button& button, std::size_t state) {
  if (!button.selfLocking() || state >= button.states().size()) return {};
  return tr("%1: ").arg(QString::fromStdString(button.states()[state].name));
}

/// "from 1.2 to 1.5 mm", or "at 4 mm" if both ends have the same text.
QString placeWords(double from_mm, double to_mm, const DisplayUnits& units) {
  const QString from = quantityText(from_mm, Quantity::length, units, 3);
  const QString to = quantityText(to_mm, Quantity::length, units, 3);
  return from == to ? tr("at %1").arg(shown(to_mm, Quantity::length, units))
                    : tr("from %1 to %2").arg(from, shown(to_mm, Quantity::length, units));
}

QString boundWords(playback::StabilityBound bound) {
  switch (bound) {
    case playback::StabilityBound::damping:
      return tr("(limited by the damping of the device)");
    case playback::StabilityBound::quantisation:
      return tr("(limited by the friction and the encoder steps of the device)");
    case playback::StabilityBound::device:
      break;
  }
  return tr("(limit of the device)");
}

}  // namespace

QString stretchWords(const playback::UnstableStretch& stretch, const Button& button,
                     const DisplayUnits& units) {
  const QString what =
      stretch.falling ? tr("the falling jump %1 has a slope of %2") : tr("the rise %1 has a slope of %2");
  return asSentence(stateBefore(button, stretch.state) +
                    what.arg(placeWords(stretch.from_mm, stretch.to_mm, units),
                             shown(stretch.worst.slope_N_per_mm, Quantity::slope, units)) +
                    tr("; the device can reproduce at most %1 without vibrating %2")
                        .arg(shown(stretch.worst.allowed_N_per_mm, Quantity::slope, units),
                             boundWords(stretch.worst.bound)));
}

QString marginWords(const playback::StabilityMargin& margin, const Button& button,
                    const DisplayUnits& units) {
  if (margin.stable())
    return tr("Stable: the device can reproduce every slope. Smallest margin: %1.")
        .arg(shown(margin.least.margin_N_per_mm(), Quantity::slope, units));
  const auto worst = std::min_element(
      margin.unstable.begin(), margin.unstable.end(),
      [](const auto& a, const auto& b) { return a.worst.margin_N_per_mm() < b.worst.margin_N_per_mm(); });
  const QString stretches =
      margin.unstable.size() == 1
          ? tr("At one place the button is too steep for the device, which would vibrate there.")
          : tr("At %1 places the button is too steep for the device, which would vibrate there. The worst:")
                .arg(margin.unstable.size());
  return stretches + " " + stretchWords(*worst, button, units);
}

QString remarkWords(const playback::ForceRemark& remark, const Button& button, const DisplayUnits& units) {
  const auto in = [&](double value, Quantity quantity) { return shown(value, quantity, units); };
  const QString at = in(remark.at_mm, Quantity::length);
  QString words;
  switch (remark.kind) {
    case playback::ForceRemarkKind::bottomOutSoftened:
      words = tr("the rise of %1 at %2 is reproduced as %3")
                  .arg(in(remark.value, Quantity::slope), at, in(remark.limit, Quantity::slope));
      break;
    case playback::ForceRemarkKind::fallSoftened:
      words = tr("the fall of %1 at %2 is reproduced as %3")
                  .arg(in(remark.value, Quantity::slope), at, in(remark.limit, Quantity::slope));
      break;
    case playback::ForceRemarkKind::forceClipped:
      words = tr("%1 exceeds the force of the device; %2 is reproduced")
                  .arg(in(remark.value, Quantity::force), in(remark.limit, Quantity::force));
      break;
    case playback::ForceRemarkKind::strokesCross:
      words = tr("at %2, the release lies up to %1 above the press and would add energy; there, the device "
                 "uses the release curve for both strokes")
                  .arg(in(remark.value, Quantity::force), at);
      break;
    case playback::ForceRemarkKind::dampingLimited:
      words = tr("the damping of %1 at %2 is reproduced as %3")
                  .arg(in(remark.value, Quantity::damping), at, in(remark.limit, Quantity::damping));
      break;
    case playback::ForceRemarkKind::speedsCross:
      words = tr("at %2, the release at one speed lies up to %1 above the press at another and would add "
                 "energy; there, the device uses this release curve for the press as well")
                  .arg(in(remark.value, Quantity::force), at);
      break;
    case playback::ForceRemarkKind::speedLimited:
      words = (remark.value > 0
                   ? tr("at %2, the force changes with speed like a damping of %1; the device reproduces %3")
                   : tr("at %2, the change of force with speed adds energy (%1); the device reproduces %3"))
                  .arg(in(std::abs(remark.value), Quantity::damping), at,
                       in(std::abs(remark.limit), Quantity::damping));
      break;
    case playback::ForceRemarkKind::wideReturn:
      words = tr("to change from press to release, this device would need %1 of travel; it has only %2, so "
                 "it may vibrate")
                  .arg(in(2 * remark.value, Quantity::length), in(2 * remark.limit, Quantity::length));
      break;
  }
  return asSentence(stateBefore(button, remark.state) + words);
}

QString changeWords(const std::vector<playback::StabilityChange>& changes, const Button& button,
                    const DisplayUnits& units) {
  QStringList lines;
  for (const playback::StabilityChange& change : changes) {
    QStringList parts;
    if (change.largestForceChange_N > 0)
      parts << tr("forces %2 changed by up to %1")
                   .arg(shown(change.largestForceChange_N, Quantity::force, units),
                        placeWords(change.changedFrom_mm, change.changedTo_mm, units));
    if (change.addedDamping_Ns_per_mm > 0)
      parts << tr("damping raised by up to %1")
                   .arg(shown(change.addedDamping_Ns_per_mm, Quantity::damping, units));
    lines << asSentence(stateBefore(button, change.state) + parts.join(tr("; ")));
  }
  return lines.join(' ');
}

}  // namespace detent::editor
