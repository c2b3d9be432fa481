// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/import_draft.h"

#include <cmath>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace detent::editor {
namespace {

constexpr int draftVersion = 1;

QJsonArray arrayOf(const std::vector<importer::Point>& points) {
  QJsonArray array;
  for (const importer::Point& p : points) array << p.x << p.y;
  return array;
}

QJsonObject axisOf(const AxisCorrection& axis) {
  QJsonObject object;
  if (axis.min) object["min"] = *axis.min;
  if (axis.max) object["max"] = *axis.max;
  QJsonArray ticks;
  for (const AxisTick& tick : axis.ticks) ticks << QJsonArray{tick.at.x, tick.at.y, tick.value};
  if (!ticks.isEmpty()) object["ticks"] = ticks;
  return object;
}

QJsonArray colorOf(const importer::Rgb& color) { return {color.r, color.g, color.b}; }

QString unitName(std::string_view symbol) {
  return QString::fromUtf8(symbol.data(), static_cast<qsizetype>(symbol.size()));
}

QJsonArray marksOf(const std::vector<MarkCorrection>& marks) {
  QJsonArray array;
  for (const MarkCorrection& mark : marks) {
    QJsonObject object{{"kind", static_cast<int>(mark.kind)}, {"release", mark.stroke == Stroke::release}};
    if (mark.from) object["from"] = arrayOf({*mark.from});
    if (mark.to) object["to"] = arrayOf({*mark.to});
    array << object;
  }
  return array;
}

QJsonObject correctionsOf(const Corrections& c) {
  QJsonObject object;
  if (c.frame) object["frame"] = arrayOf({c.frame->begin(), c.frame->end()});
  object["x"] = axisOf(c.x);
  object["y"] = axisOf(c.y);
  if (c.xUnit) object["xUnit"] = unitName(symbolOf(*c.xUnit));
  if (c.yUnit) object["yUnit"] = unitName(symbolOf(*c.yUnit));
  if (c.pressColor) object["pressColor"] = colorOf(*c.pressColor);
  if (c.releaseColor) object["releaseColor"] = colorOf(*c.releaseColor);
  object["drawnPress"] = arrayOf(c.drawn.press);
  object["drawnRelease"] = arrayOf(c.drawn.release);
  QJsonArray masks;
  for (const importer::Box& box : c.masks) masks << QJsonArray{box.x0, box.y0, box.x1, box.y1};
  object["masks"] = masks;
  object["marks"] = marksOf(c.marks);
  object["swapStrokes"] = c.swapStrokes;
  if (c.noRelease) object["noRelease"] = true;
  if (c.xIsOther) object["xIsOther"] = true;
  if (c.yIsOther) object["yIsOther"] = true;
  if (!c.curve.empty()) object["curve"] = QString::fromStdString(c.curve);
  if (c.dpi) object["dpi"] = *c.dpi;
  return object;
}

/// Reads members and remembers any fault, so that a text is used completely or not at all.
class Reader {
 public:
  bool ok = true;

  std::vector<double> numbers(const QJsonValue& value) {
    std::vector<double> read;
    if (!value.isArray()) return fail(), read;
    for (const auto& each : value.toArray()) {
      if (!each.isDouble() || !std::isfinite(each.toDouble())) return fail(), read;
      read.push_back(each.toDouble());
    }
    return read;
  }
  std::vector<double> numbers(const QJsonValue& value, std::size_t count) {
    auto read = numbers(value);
    if (read.size() != count) fail(), read.assign(count, 0);
    return read;
  }
  std::vector<importer::Point> points(const QJsonValue& value) {
    const auto read = numbers(value);
    if (read.size() % 2 != 0) fail();
    std::vector<importer::Point> points;
    for (std::size_t i = 0; i + 1 < read.size(); i += 2) points.push_back({read[i], read[i + 1]});
    return points;
  }
  std::optional<double> number(const QJsonObject& object, const char* key) {
    const QJsonValue value = object[QLatin1String(key)];
    if (value.isUndefined()) return {};
    if (!value.isDouble()) fail();
    return value.toDouble();
  }
  AxisCorrection axis(const QJsonValue& value) {
    AxisCorrection axis;
    if (!value.isObject()) return fail(), axis;
    const QJsonObject object = value.toObject();
    axis.min = number(object, "min");
    axis.max = number(object, "max");
    for (const auto& tick : object["ticks"].toArray()) {
      const auto n = numbers(tick, 3);
      axis.ticks.push_back({{n[0], n[1]}, n[2]});
    }
    return axis;
  }
  std::optional<importer::Rgb> color(const QJsonValue& value) {
    if (value.isUndefined()) return {};
    const auto n = numbers(value, 3);
    for (const double part : n)
      if (part < 0 || part > 255) fail();
    return importer::Rgb{static_cast<std::uint8_t>(n[0]), static_cast<std::uint8_t>(n[1]),
                         static_cast<std::uint8_t>(n[2])};
  }
  std::optional<importer::Point> place(const QJsonObject& object, const char* key) {
    if (!object.contains(QLatin1String(key))) return {};
    const auto n = numbers(object[QLatin1String(key)], 2);
    return importer::Point{n[0], n[1]};
  }
  std::vector<MarkCorrection> marks(const QJsonArray& array) {
    std::vector<MarkCorrection> read;
    for (const auto& each : array) {
      const QJsonObject object = each.toObject();
      const int kind = object["kind"].toInt(-1);
      if (kind < 0 || kind > static_cast<int>(MarkCorrection::Kind::reset)) return fail(), read;
      read.push_back({static_cast<MarkCorrection::Kind>(kind),
                      object["release"].toBool() ? Stroke::release : Stroke::press, place(object, "from"),
                      place(object, "to")});
    }
    return read;
  }
  Corrections corrections(const QJsonObject& object) {
    Corrections c;
    if (object.contains("frame")) {
      const auto corners = points(object["frame"]);
      if (corners.size() == 4)
        c.frame = FrameCorners{corners[0], corners[1], corners[2], corners[3]};
      else
        fail();
    }
    c.x = axis(object["x"]);
    c.y = axis(object["y"]);
    if (object.contains("xUnit") && !(c.xUnit = lengthUnitFrom(object["xUnit"].toString().toStdString())))
      fail();
    if (object.contains("yUnit") && !(c.yUnit = forceUnitFrom(object["yUnit"].toString().toStdString())))
      fail();
    c.pressColor = color(object["pressColor"]);
    c.releaseColor = color(object["releaseColor"]);
    c.drawn = {points(object["drawnPress"]), points(object["drawnRelease"])};
    for (const auto& mask : object["masks"].toArray()) {
      const auto n = numbers(mask, 4);
      c.masks.push_back({n[0], n[1], n[2], n[3]});
    }
    c.marks = marks(object["marks"].toArray());
    c.swapStrokes = object["swapStrokes"].toBool();
    c.noRelease = object["noRelease"].toBool();
    c.xIsOther = object["xIsOther"].toBool(), c.yIsOther = object["yIsOther"].toBool();
    c.curve = object["curve"].toString().toStdString();
    c.dpi = number(object, "dpi");
    return c;
  }
  GraphId id(const QJsonValue& value) {
    const auto n = numbers(value, 2);
    return {static_cast<int>(n[0]), static_cast<int>(n[1])};
  }
  void fail() { ok = false; }
};

}  // namespace

QByteArray textOf(const ImportDraft& draft) {
  QJsonObject object{{"format", "detent-import-draft"},
                     {"version", draftVersion},
                     {"path", draft.path},
                     {"picture", draft.picture},
                     {"quality", static_cast<int>(draft.quality)}};
  if (draft.current) object["current"] = QJsonArray{draft.current->page, draft.current->graph};
  QJsonArray graphs;
  for (const DraftGraph& graph : draft.graphs)
    graphs << QJsonObject{{"id", QJsonArray{graph.id.page, graph.id.graph}},
                          {"framedByHand", graph.framedByHand},
                          {"corrections", correctionsOf(graph.corrections)}};
  object["graphs"] = graphs;
  return QJsonDocument(object).toJson(QJsonDocument::Compact);
}

std::optional<ImportDraft> draftFrom(const QByteArray& text) {
  const QJsonObject object = QJsonDocument::fromJson(text).object();
  if (object["format"] != "detent-import-draft" || object["version"].toInt() != draftVersion) return {};
  Reader read;
  ImportDraft draft;
  draft.path = object["path"].toString();
  draft.picture = object["picture"].toString();
  const int quality = object["quality"].toInt(-1);
  if (quality < 0 || quality > static_cast<int>(importer::Quality::precise)) return {};
  draft.quality = static_cast<importer::Quality>(quality);
  if (object.contains("current")) draft.current = read.id(object["current"]);
  for (const auto& each : object["graphs"].toArray()) {
    const QJsonObject graph = each.toObject();
    draft.graphs.push_back({read.id(graph["id"]), read.corrections(graph["corrections"].toObject()),
                            graph["framedByHand"].toBool()});
  }
  if (!read.ok || (draft.path.isEmpty() && draft.picture.isEmpty())) return {};
  return draft;
}

}  // namespace detent::editor
