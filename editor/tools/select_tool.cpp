// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/select_tool.h"

#include <cmath>
#include <QCoreApplication>

#include "editor/document/message_words.h"
#include "editor/tools/hit_test.h"
#include "editor/tools/mark_edits.h"

namespace detent::editor {
namespace {

// Less than this is a click with an unsteady hand.
constexpr double dragThreshold_px = 3;

QString tr(const char* text) { return QCoreApplication::translate("SelectTool", text); }

// What a press at a place takes: a mark, else the section under it.
std::optional<Mark> takenAt(const GraphCanvas& canvas, const PointerInput& input) {
  const std::vector<Mark> marks = marksAt(canvas, input.at_px);
  if (!marks.empty()) {
    // What is selected stays in hand where several lie over each other.
    for (const Mark& mark : marks)
      if (mark.id == canvas.selected()) return mark;
    return marks.front();
  }
  const auto hit = curveAt(canvas, input.at_px);
  if (!hit) return {};
  const auto section = sectionAt(canvas.values().of(hit->stroke), hit->at.displacement_mm);
  if (!section) return {};
  return Mark{{MarkKind::section, hit->stroke, *section}, hit->at};
}

bool isPoint(MarkKind kind) {
  return kind != MarkKind::section && kind != MarkKind::slopeBefore && kind != MarkKind::slopeAfter;
}

}  // namespace

QString SelectTool::hint() const {
  return tr(
      "Drag points, slope handles and sections. Shift keeps to one axis, Ctrl does not snap, Escape "
      "cancels.");
}

void SelectTool::leave() {
  holding_ = Holding::nothing;
  held_.reset();
  context_.canvas.setFeedback({});
  context_.canvas.unsetCursor();
}

void SelectTool::dragCancelled() {
  holding_ = Holding::nothing;
  held_.reset();
}

void SelectTool::hover(const PointerInput& input) {
  const auto mark = takenAt(context_.canvas, input);
  CanvasFeedback feedback;
  if (mark) feedback.hovered = mark->id;
  context_.canvas.setFeedback(feedback);
  if (mark)
    context_.canvas.setCursor(mark->id.kind == MarkKind::section ? Qt::SizeAllCursor : Qt::OpenHandCursor);
  else
    context_.canvas.unsetCursor();
}

bool SelectTool::pressed(const PointerInput& input) {
  if (input.button != Qt::LeftButton || context_.busy()) return false;
  pressed_px_ = last_px_ = input.at_px;
  pressedAt_ = input.at;
  travelled_ = false;
  held_ = takenAt(context_.canvas, input);
  wasSelected_ = held_ && context_.canvas.selected() == held_->id;
  holding_ = held_ ? Holding::mark : Holding::ground;
  if (held_) {
    context_.canvas.setSelected(held_->id);
    context_.say(describe(*held_, context_.settings.units()));
  }
  return true;
}

void SelectTool::beginDrag(const PointerInput&) {
  const Mark mark = *held_;
  const std::size_t state = context_.document.activeState();
  DragTask task;
  task.label = moveLabel(mark.id);
  task.from = mark.at;
  task.stroke = mark.id.stroke;
  task.snaps = isPoint(mark.id.kind);
  if (isPoint(mark.id.kind) && mark.id.kind != MarkKind::turn) task.mark = mark.id;
  task.edit = [mark, state](const Button& start, CurvePoint to) { return moveMark(start, state, mark, to); };
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
  if (holding_ == Holding::ground) {
    context_.canvas.panBy(input.at_px - last_px_);
  } else {
    if (!travelled_ && context_.busy()) return true;
    if (!travelled_) beginDrag(input);
    context_.drag.moveTo(input.at, input.modifiers);
  }
  travelled_ = true;
  last_px_ = input.at_px;
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

bool SelectTool::released(const PointerInput& input) {
  if (input.button != Qt::LeftButton || holding_ == Holding::nothing) return false;
  if (context_.drag.running())
    context_.drag.finish();
  else if (!travelled_ && holding_ == Holding::ground)
    context_.canvas.setSelected({});
  else if (!travelled_ && wasSelected_)
    takeBeneath(input);
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
      context_.say(sentenceOf(next.failure()));
    context_.canvas.setSelected(mark.id);
    return true;
  }
  const auto hit = curveAt(context_.canvas, input.at_px);
  if (!hit) return false;
  const auto next = addKnot(history.committed(), state, hit->stroke, hit->at.displacement_mm);
  if (!next) {
    context_.say(sentenceOf(next.failure()));
    return true;
  }
  history.apply(*next, tr("Add knot"));
  if (const auto knot = knotAt(context_.canvas.state().graph.curve(hit->stroke), hit->at.displacement_mm))
    context_.canvas.setSelected(MarkId{MarkKind::knot, hit->stroke, *knot});
  return true;
}

}  // namespace detent::editor
