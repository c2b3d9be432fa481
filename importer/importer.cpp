// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/importer.h"

#include <cstdio>

#include "importer/axes/read_text.h"

namespace detent::importer {
namespace {

std::string formatted(const char* format, double a, double b) {
  char text[96];
  std::snprintf(text, sizeof text, format, a, b);
  return text;
}

std::string tactileText(const StrokeReport& stroke) {
  if (stroke.fit.tactilePoints.empty()) return "no tactile point";
  const TactilePoint& p = stroke.fit.tactilePoints.front().point;
  return formatted("tactile point %.3f mm %.3f N", p.displacement_mm, p.force_N);
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

}  // namespace detent::importer
