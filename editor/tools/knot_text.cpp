// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/knot_text.h"

#include <algorithm>
#include <cmath>
#include <QStringList>

#include "editor/tools/mark_edits.h"

namespace detent::editor {
namespace {

constexpr qsizetype mostLines = 100'000;  // limit of knots of a curve
constexpr int exactDigits = 17;

QString header() {
  return QStringLiteral("stroke,displacement_mm,force_N,slope_before_N_per_mm,slope_after_N_per_mm");
}
QString nameOf(Stroke stroke) {
  return stroke == Stroke::press ? QStringLiteral("press") : QStringLiteral("release");
}

std::vector<Knot> knotsBetween(const std::vector<MarkId>& marks, Stroke stroke, const StrokeCurve& curve) {
  std::size_t first = curve.knots().size(), last = 0;
  for (const MarkId& mark : marks) {
    if (mark.kind != MarkKind::knot || mark.stroke != stroke) continue;
    first = std::min(first, mark.index);
    last = std::max(last, mark.index);
  }
  if (first >= curve.knots().size() || last >= curve.knots().size()) return {};
  const auto begin = curve.knots().begin();
  return {begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last) + 1};
}

std::vector<Knot> knotsOfSection(MarkId mark, const ButtonState& state, const GraphValues& values) {
  const auto& sections = values.of(mark.stroke).sections;
  if (mark.index >= sections.size()) return {};
  const auto [from, to] = std::minmax(sections[mark.index].from_mm, sections[mark.index].to_mm);
  const auto stretch = stretchOf(state.graph.curve(mark.stroke), from, to);
  return stretch ? *stretch : std::vector<Knot>{};
}

void addLines(const std::vector<Knot>& knots, Stroke stroke, QStringList& lines) {
  const auto number = [](double value) { return QString::number(value, 'g', exactDigits); };
  for (const Knot& k : knots)
    lines << QStringList{nameOf(stroke), number(k.displacement_mm), number(k.force_N),
                         number(k.slopeBefore_N_per_mm), number(k.slopeAfter_N_per_mm)}
                 .join(',');
}

std::optional<Knot> knotFrom(const QStringList& fields) {
  double values[4];
  for (int i = 0; i < 4; ++i) {
    bool isNumber = false;
    values[i] = fields[i + 1].toDouble(&isNumber);
    if (!isNumber || !std::isfinite(values[i])) return {};
  }
  return Knot{values[0], values[1], values[2], values[3]};
}

}  // namespace

GraphStretch stretchOfMarks(const std::vector<MarkId>& marks, const ButtonState& state,
                            const GraphValues& values) {
  GraphStretch stretch;
  if (marks.size() == 1 && marks[0].kind == MarkKind::section) {
    (marks[0].stroke == Stroke::press ? stretch.press : stretch.release) =
        knotsOfSection(marks[0], state, values);
    return stretch;
  }
  stretch.press = knotsBetween(marks, Stroke::press, state.graph.press());
  if (state.graph.release()) stretch.release = knotsBetween(marks, Stroke::release, *state.graph.release());
  return stretch;
}

QString textOf(const GraphStretch& stretch) {
  QStringList lines{header()};
  addLines(stretch.press, Stroke::press, lines);
  addLines(stretch.release, Stroke::release, lines);
  return lines.join('\n') + '\n';
}

std::optional<GraphStretch> stretchFrom(const QString& text) {
  const QStringList lines = text.trimmed().split('\n');
  if (lines.size() < 2 || lines.size() > mostLines || lines[0].trimmed() != header()) return {};
  GraphStretch stretch;
  for (const QString& line : lines.mid(1)) {
    const QStringList fields = line.trimmed().split(',');
    if (fields.size() != 5) return {};
    const bool press = fields[0] == nameOf(Stroke::press);
    if (!press && fields[0] != nameOf(Stroke::release)) return {};
    const auto knot = knotFrom(fields);
    if (!knot) return {};
    (press ? stretch.press : stretch.release).push_back(*knot);
  }
  return stretch;
}

Result<Button> pasteStretch(const Button& button, std::size_t state, const GraphStretch& stretch) {
  return editGraph(button, state, [&](const ForceGraph& graph) -> Result<ForceGraph> {
    StrokeCurve press = graph.press();
    std::optional<StrokeCurve> release = graph.release();
    if (!stretch.press.empty()) {
      auto put = putStretch(press, stretch.press);
      if (!put) return put.failure();
      press = *std::move(put);
    }
    if (!stretch.release.empty()) {
      if (!release)
        return Failure{FailureCode::wrongUsage, "force graph", "",
                       Message("the graph has no release curve to paste into"),
                       Message("Create a release first: Edit > Curve > Mirror press to release")};
      auto put = putStretch(*release, stretch.release);
      if (!put) return put.failure();
      release = *std::move(put);
    }
    return ForceGraph::fromCurves(std::move(press), std::move(release));
  });
}

}  // namespace detent::editor
