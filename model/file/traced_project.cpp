// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/file/traced_project.h"

#include <cstdio>
#include <string_view>

#include <nlohmann/json.hpp>

#include "model/file/json_text.h"
#include "model/file/plot_picture.h"
#include "model/number_table.h"
#include "model/sampling.h"

namespace detent {

namespace {

using Json = nlohmann::ordered_json;

/// A calibration point; WebPlotDigitizer keeps values as typed.
Json knownPoint(const PlotFrame& frame, double x, double y) {
  return {{"px", frame.xPx(x)},
          {"py", frame.yPx(y)},
          {"dx", shortestText(x)},
          {"dy", shortestText(y)},
          {"dz", nullptr}};
}

Json axesOf(const PlotFrame& frame, const std::string& name) {
  const double left = frame.x.first, right = frame.x.last(), low = frame.y.first, high = frame.y.last();
  return {{"name", name},
          {"type", "XYAxes"},
          {"isLogX", false},
          {"isLogY", false},
          {"noRotation", true},
          {"calibrationPoints", Json::array({knownPoint(frame, left, low), knownPoint(frame, right, low),
                                             knownPoint(frame, left, low), knownPoint(frame, left, high)})}};
}

Json setOf(const ForceGraph& graph, Stroke stroke, const PlotFrame& frame, const std::string& axes,
           const SvgPlotStyle& style) {
  Json data = Json::array();
  for (const CurvePoint& p : travelledSamples(graph, stroke)) {
    const double x = p.displacement_mm / millimetresPer(style.lengthUnit),
                 y = p.force_N / newtonsPer(style.forceUnit);
    data.push_back({{"x", frame.xPx(x)}, {"y", frame.yPx(y)}, {"value", {x, y}}});
  }
  const bool press = stroke == Stroke::press;
  return {{"name", press ? "press" : "release"},
          {"axesName", axes},
          {"metadataKeys", Json::array()},
          {"colorRGB", press ? Json{200, 0, 0, 255} : Json{0, 80, 200, 255}},
          {"data", std::move(data)},
          {"autoDetectionData", nullptr}};
}

// ---- TAR (ustar)

constexpr std::size_t block_bytes = 512;
constexpr const char* folder = "detent/";

/// Appends header and content in whole blocks; a name that ends in a slash is a folder.
void putEntry(std::string& archive, const std::string& name, const std::string& content) {
  std::string header(block_bytes, '\0');
  const auto put = [&](std::size_t at, std::string_view text) { header.replace(at, text.size(), text); };
  const bool isFolder = name.back() == '/';
  char size[12];
  std::snprintf(size, sizeof size, "%011zo", content.size());
  put(0, name);
  put(100, isFolder ? "0000755" : "0000644");
  put(108, "0000000");
  put(116, "0000000");
  put(124, std::string_view(size, 11));
  put(136, "00000000000");
  put(148, "        ");
  put(156, isFolder ? "5" : "0");
  put(257, std::string_view("ustar\00000", 8));
  unsigned sum = 0;
  for (const char c : header) sum += static_cast<unsigned char>(c);
  char check[8];
  std::snprintf(check, sizeof check, "%06o", sum);
  put(148, std::string_view(check, 7));
  archive += header + content;
  archive.append((block_bytes - content.size() % block_bytes) % block_bytes, '\0');
}

}  // namespace

std::string tracedProjectFrom(const ButtonState& state, const SvgPlotStyle& style) {
  const PlotFrame frame = frameOfPlot(state, style);
  const std::string axes =
      std::string(symbolOf(style.lengthUnit)) + ", " + std::string(symbolOf(style.forceUnit));
  Json sets = Json::array({setOf(state.graph, Stroke::press, frame, axes, style)});
  if (state.graph.release()) sets.push_back(setOf(state.graph, Stroke::release, frame, axes, style));
  const Json project = {{"version", {4, 2}},
                        {"axesColl", Json::array({axesOf(frame, axes)})},
                        {"datasetColl", std::move(sets)},
                        {"measurementColl", Json::array()}};
  return jsonText(project) + '\n';
}

std::string tracedArchiveFrom(const ButtonState& state, const SvgPlotStyle& style) {
  const std::string picture = "plot.png";
  const Json info = {{"version", {4, 0}}, {"json", "wpd.json"}, {"images", Json::array({picture})}};
  std::string archive;
  putEntry(archive, folder, {});
  putEntry(archive, std::string(folder) + "info.json", jsonText(info));
  putEntry(archive, std::string(folder) + "wpd.json", tracedProjectFrom(state, style));
  putEntry(archive, folder + picture, pngFrom(state, style));
  archive.append(2 * block_bytes, '\0');
  return archive;
}

}  // namespace detent
