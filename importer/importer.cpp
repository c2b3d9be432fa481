// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/importer.h"

#include <algorithm>
#include <cstdio>

#include "importer/axes/read_text.h"

namespace detent::importer {
namespace {

std::string formatted(const char* format, double a, double b) {
  char text[96];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

/// The most prominent tactile point and all that rival it: a turn of noise is not taken for the point.
std::string tactileText(const StrokeReport& stroke) {
  constexpr double rival = 0.5;  // share of the largest prominence
  double most_N = 0;
  for (const FittedTactilePoint& each : stroke.fit.tactilePoints)
    most_N = std::max(most_N, each.point.prominence_N);
  std::string text;
  for (const auto& [p, sigma_mm, sigma_N] : stroke.fit.tactilePoints)
    if (p.prominence_N >= rival * most_N)
      text += formatted(text.empty() ? "tactile point %.3f mm %.3f N" : " or %.3f mm %.3f N",
                        p.displacement_mm, p.force_N);
  return text.empty() ? "no tactile point" : text;
}

}  // namespace

std::string ImportReport::brief() const {
  std::string text = "page " + std::to_string(page) + ", graph " + std::to_string(graph) + ": press " +
                     std::to_string(press.fit.pieces) + " pieces, " + tactileText(press);
  if (release)
    text += "; release " + std::to_string(release->fit.pieces) + " pieces, " + tactileText(*release);
  const double travel_mm = button.states().front().graph.travel_mm();
  return text + formatted("; travel %.3f mm; confidence %.2f", travel_mm, confidence);
}

void loadTextEngine() { static_cast<void>(TextReader::available()); }

namespace {

bool isGiven(const ImportHints& hints, RemedyKind kind) {
  const AxisHints& axes = hints.axes;
  switch (kind) {
    case RemedyKind::giveFrame:
      return !hints.frame.empty();
    case RemedyKind::giveXAxis:
      return axes.xMin && axes.xMax;
    case RemedyKind::giveYAxis:
      return axes.yMin && axes.yMax;
    case RemedyKind::giveXUnit:
      return axes.xUnit.has_value();
    case RemedyKind::giveYUnit:
      return axes.yUnit.has_value();
    case RemedyKind::pickPress:
      return hints.trace.pressColor || !hints.drawn.press.empty();
    case RemedyKind::pickRelease:
    case RemedyKind::noRelease:
      return hints.trace.releaseColor || !hints.drawn.release.empty() || hints.strokes.noRelease;
    case RemedyKind::setResolution:
      return hints.dpi.has_value();
    case RemedyKind::drawPress:
      return !hints.drawn.press.empty();
    case RemedyKind::drawRelease:
      return !hints.drawn.release.empty();
    case RemedyKind::chooseSwitch:
      return !hints.strokes.curve.empty();
    default:
      return false;  // all other remedies can be applied more than once, such as masks
  }
}

}  // namespace

bool strokeIsGiven(const ImportHints& hints, Stroke stroke) {
  return isGiven(hints, stroke == Stroke::press ? RemedyKind::pickPress : RemedyKind::pickRelease);
}

Remedies leftToTry(const Remedies& remedies, const ImportHints& hints) {
  Remedies left = remedies.without([&](RemedyKind kind) { return isGiven(hints, kind); });
  if (!left.empty() || remedies.empty()) return left;
  const bool ofAxes = std::ranges::all_of(remedies, [](const Remedy& remedy) {
    return remedy.kind == RemedyKind::giveXAxis || remedy.kind == RemedyKind::giveYAxis ||
           remedy.kind == RemedyKind::giveXUnit || remedy.kind == RemedyKind::giveYUnit;
  });
  if (!ofAxes && hints.drawn.press.empty()) return RemedyKind::drawPress;
  return Remedy{RemedyKind::acceptAsIs, "where the overlay shows that it is right"};
}

}  // namespace detent::importer
