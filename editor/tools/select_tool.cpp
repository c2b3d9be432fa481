// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/select_tool.h"

#include <algorithm>
#include <cmath>
#include <QCoreApplication>

#include "editor/document/message_words.h"
#include "editor/tools/hit_test.h"
#include "editor/tools/mark_edits.h"
#include "editor/tools/selection_edits.h"

namespace detent::editor {
namespace {

// A shorter movement counts as a click.
constexpr double dragThreshold_px = 3;

QString tr(const char* text, const char* note = nullptr, int n = -1) {
  return QCoreApplication::translate("detent::editor::SelectTool", text, note, n);
}

// The mark at a place, else the section under it.
std::optional<Mark> takenAt(const GraphCanvas& canvas, const PointerInput& input) {
  const std::vector<Mark> marks = marksAt(canvas, input.at_px);
  if (!marks.empty()) {
    // A selected mark stays selected if several overlap.
    for (const Mark& mark : marks)
      if (canvas.isSelected(mark.id)) return mark;
    return marks.front();
  }
  // A mark that another edit removed keeps its label until the next drawing.
  if (const auto flag = canvas.flagAt(input.at_px))
    if (const auto at = placeOf(*flag, canvas.state(), canvas.values())) return Mark{*flag, *at};
  const auto hit = curveAt(canvas, input.at_px);
  if (!hit) return {};
  const auto section = sectionAt(canvas.values().of(hit->stroke), hit->at.displacement_mm);
  if (!section) return {};
  return Mark{{MarkKind::section, hit->stroke, *section}, hit->at};
}

// Returns true if a drag is back at its start, so that a knot added on the way is dropped again.
bool isBack(CurvePoint from, CurvePoint to) {
  constexpr double rounding = 1e-12;  // mm, N
  return std::abs(to.displacement_mm - from.displacement_mm) <= rounding &&
         std::abs(to.force_N - from.force_N) <= rounding;
}

bool isPoint(MarkKind kind) { return kind != MarkKind::section && !isSlope(kind); }

}  // namespace

QString SelectTool::hint() const {
  return tr(
      "Drag points and slope handles. Drag the line to bend it between two points. Drag on empty space to "
      "select several. Shift: one axis, Ctrl: no snapping, Escape: cancel.");
}

void SelectTool::leave() {
  holding_ = Holding::nothing;
  held_.reset();
  context_.canvas.setFeedback({});
  context_.canvas.unsetCursor();
}

void SelectTool::dragCancelled() {
  context_.canvas.setFeedback({});
  holding_ = Holding::nothing;
  held_.reset();
}

void SelectTool::hover(const PointerInput& input) {
  const auto mark = takenAt(context_.canvas, input);
  CanvasFeedback feedback;
  if (mark) feedback.hovered = mark->id;
  context_.canvas.setFeedback(feedback);
  const auto cursorOf = [](MarkKind kind) {
    if (isContact(kind)) return Qt::SizeHorCursor;
    return kind == MarkKind::section ? Qt::SizeVerCursor : Qt::OpenHandCursor;
  };
  if (mark)
    context_.canvas.setCursor(cursorOf(mark->id.kind));
  else
    context_.canvas.unsetCursor();
}

bool SelectTool::pressed(const PointerInput& input) {
  if (input.button != Qt::LeftButton || context_.busy()) return false;
  pressed_px_ = input.at_px;
  pressedAt_ = input.at;
  travelled_ = false;
  held_ = takenAt(context_.canvas, input);
  wasSelected_ = held_ && context_.canvas.isSelected(held_->id);
  adding_ = input.modifiers & Qt::ShiftModifier;
  selectedBefore_ = adding_ ? context_.canvas.selection() : std::vector<MarkId>{};
  pressedOn_ = MarkedState{context_.canvas.state(), context_.canvas.values()};
  holding_ = held_ ? Holding::mark : Holding::emptySpace;
  if (!held_) return true;
  if (adding_) {
    toggleHeld();
  } else {
    // One of several selected marks stays selected, so that the drag moves all.
    if (!wasSelected_) context_.canvas.setSelected(held_->id);
    context_.say(describe(*held_, context_.settings.units()));
  }
  return true;
}

// Shift removes selected marks and adds others.
void SelectTool::toggleHeld() {
  GraphCanvas& canvas = context_.canvas;
  const auto points = [&](MarkId mark) { return pointsOf(mark, canvas.state(), canvas.values()); };
  std::vector<MarkId> now;
  const auto add = [&](MarkId mark) {
    if (std::find(now.begin(), now.end(), mark) == now.end()) now.push_back(mark);
  };
  for (const MarkId& mark : canvas.selection())
    for (const MarkId& point : points(mark)) add(point);
  const std::vector<MarkId> held = points(held_->id);
  if (held.empty())
    return context_.say(tr("There is no curve point here. Add one (K) to select it with others."));
  const bool allThere = std::all_of(
      held.begin(), held.end(), [&](MarkId m) { return std::find(now.begin(), now.end(), m) != now.end(); });
  if (allThere && !now.empty()) {
    std::erase_if(now, [&](MarkId m) { return std::find(held.begin(), held.end(), m) != held.end(); });
  } else {
    for (const MarkId& mark : held) add(mark);
  }
  canvas.setSelection(now);
  if (const auto at = placeOf(held.back(), canvas.state(), canvas.values())) held_ = Mark{held.back(), *at};
  context_.say(tr("%n points selected", nullptr, static_cast<int>(now.size())));
}

void SelectTool::bandTo(const PointerInput& input) {
  GraphCanvas& canvas = context_.canvas;
  const QRectF band = QRectF(pressed_px_, input.at_px).normalized();
  const PlotMapping map = canvas.mapping();
  std::vector<MarkId> now;
  const MarkedState shown{canvas.state(), canvas.values()};  // keys may have changed the selection meanwhile
  for (const MarkId& mark : selectedBefore_)
    if (const auto same = sameMark(mark, *pressedOn_, shown)) now.push_back(*same);
  for (const MarkId& mark : allPoints(canvas.state())) {
    const auto at = placeOf(mark, canvas.state(), canvas.values());
    if (!at || !band.contains(map.toPixel(at->displacement_mm, at->force_N))) continue;
    if (std::find(now.begin(), now.end(), mark) == now.end()) now.push_back(mark);
  }
  CanvasFeedback feedback;
  feedback.band_px = band;
  canvas.setFeedback(feedback);
  canvas.setSelection(now);
  context_.say(tr("%n points selected", nullptr, static_cast<int>(now.size())));
}

// Moves all selected points with the dragged one.
void SelectTool::beginGroupDrag() {
  const Mark mark = *held_;
  const std::vector<MarkId> marks = context_.canvas.selection();
  const std::size_t state = context_.document.activeState();
  DragTask task;
  task.label = tr("Move %n points", nullptr, static_cast<int>(marks.size()));
  task.from = mark.at;
  task.stroke = mark.id.stroke;
  task.mark = mark.id;
  task.edit = [mark, marks, state](const Button& start, CurvePoint to) {
    return moveSelection(start, state, marks, to.displacement_mm - mark.at.displacement_mm,
                         to.force_N - mark.at.force_N);
  };
  context_.drag.begin(std::move(task), pressedAt_);
}

void SelectTool::beginDrag(const PointerInput&) {
  if (context_.canvas.selection().size() > 1) return beginGroupDrag();
  const Mark mark = *held_;
  const std::size_t state = context_.document.activeState();
  DragTask task;
  task.label = moveLabel(mark.id);
  task.from = mark.at;
  task.stroke = mark.id.stroke;
  task.snaps = isPoint(mark.id.kind);
  if (isPoint(mark.id.kind) && mark.id.kind != MarkKind::turn) task.mark = mark.id;
  task.edit = [mark, state](const Button& start, CurvePoint to) {
    return isBack(mark.at, to) ? Result<Button>(start) : moveMark(start, state, mark, to);
  };
  context_.drag.begin(std::move(task), pressedAt_);
}

bool SelectTool::moved(const PointerInput& input) {
  if (holding_ == Holding::nothing) {
    hover(input);
    return true;
  }
  if (!travelled_ &&
      std::hypot(input.at_px.x() - pressed_px_.x(), input.at_px.y() - pressed_px_.y()) < dragThreshold_px)
    return true;
  if (holding_ == Holding::emptySpace) {
    bandTo(input);
  } else {
    if (!travelled_ && context_.busy()) return true;
    if (!travelled_) beginDrag(input);
    context_.drag.moveTo(input.at, input.modifiers);
  }
  travelled_ = true;
  return true;
}

// The next mark within reach after the selected one; the section last.
void SelectTool::takeBeneath(const PointerInput& input) {
  std::vector<Mark> marks = marksAt(context_.canvas, input.at_px);
  if (const auto hit = curveAt(context_.canvas, input.at_px)) {
    if (const auto section = sectionAt(context_.canvas.values().of(hit->stroke), hit->at.displacement_mm))
      marks.push_back({{MarkKind::section, hit->stroke, *section}, hit->at});
  }
  for (std::size_t i = 0; i < marks.size(); ++i) {
    if (!(marks[i].id == held_->id)) continue;
    context_.canvas.setSelected(marks[(i + 1) % marks.size()].id);
    return;
  }
}

void saySelected(const ToolContext& context) {
  const GraphCanvas& canvas = context.canvas;
  const auto mark = canvas.selected();
  if (!mark || canvas.feedback().refused) return;
  if (const auto at = placeOf(*mark, canvas.state(), canvas.values()))
    context.say(describe({*mark, *at}, context.settings.units()));
}

bool SelectTool::released(const PointerInput& input) {
  if (input.button != Qt::LeftButton || holding_ == Holding::nothing) return false;
  if (context_.drag.running()) {
    context_.drag.finish();
    saySelected(context_);
  } else if (!travelled_ && holding_ == Holding::emptySpace && !adding_) {
    context_.canvas.setSelected({});
  } else if (!travelled_ && wasSelected_ && !adding_ && context_.canvas.selection().size() > 1) {
    context_.canvas.setSelected(held_->id);
  } else if (!travelled_ && wasSelected_ && !adding_) {
    takeBeneath(input);
  }
  holding_ = Holding::nothing;
  held_.reset();
  hover(input);
  return true;
}

bool SelectTool::doubleClicked(const PointerInput& input) {
  if (context_.busy()) return false;
  const std::size_t state = context_.document.activeState();
  EditHistory& history = context_.document.history();
  for (const Mark& mark : marksAt(context_.canvas, input.at_px)) {
    if (mark.id.kind != MarkKind::knot) continue;
    const auto next = toggleCorner(history.committed(), state, mark.id);
    if (next)
      history.apply(*next, tr("Corner or smooth: %1").arg(nameOf(mark.id)));
    else
      context_.say(sentenceOf(next.failure(), context_.settings.units()));
    context_.canvas.setSelected(mark.id);
    return true;
  }
  if (const auto flag = context_.canvas.flagAt(input.at_px)) {
    context_.canvas.setSelected(*flag);
    context_.askValues(FirstValue::force);
    return true;
  }
  const auto hit = curveAt(context_.canvas, input.at_px);
  if (!hit) return false;
  const auto next = addKnot(history.committed(), state, hit->stroke, hit->at.displacement_mm);
  if (!next) {
    context_.say(sentenceOf(next.failure(), context_.settings.units()));
    return true;
  }
  history.apply(*next, tr("Add curve point"));
  if (const auto knot = knotAt(context_.canvas.state().graph.curve(hit->stroke), hit->at.displacement_mm))
    context_.canvas.setSelected(MarkId{MarkKind::knot, hit->stroke, *knot});
  return true;
}

}  // namespace detent::editor
