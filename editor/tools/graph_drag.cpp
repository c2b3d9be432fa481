// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/graph_drag.h"

#include <algorithm>
#include <cmath>
#include <QCoreApplication>

#include "editor/document/message_words.h"
#include "editor/tools/snapping.h"
#include "model/check.h"

namespace detent::editor {
namespace {

constexpr int limitSteps = 14;  // halvings of the way: a 16,000th of it is less than a pixel
constexpr double clearance_px =
    4;  // distance kept from the limit, px, so that a flank does not become a step, nor a point a corner

QString dragHint(const DragTask& task) {
  return task.snaps
             ? QCoreApplication::translate("GraphDrag", "Shift: one axis, Ctrl: no snapping, Esc: cancel")
             : QCoreApplication::translate("GraphDrag", "Shift: one axis, Esc: cancel");
}

}  // namespace

GraphDrag::GraphDrag(ButtonDocument& document, GraphCanvas& canvas, std::function<void(const QString&)> say)
    : document_(document), canvas_(canvas), say_(std::move(say)) {}

void GraphDrag::begin(DragTask task, CurvePoint pointer) {
  DETENT_CHECK(!running(), "one drag at a time");
  grabOffset_ = {pointer.displacement_mm - task.from.displacement_mm, pointer.force_N - task.from.force_N};
  document_.history().beginDrag(task.label);
  task_ = std::move(task);
  CanvasFeedback feedback;
  feedback.dragged = feedback.draggedFrom = task_->from;
  canvas_.setFeedback(feedback);
  say_(dragHint(*task_));
}

CurvePoint GraphDrag::wantedPlace(CurvePoint pointer, Qt::KeyboardModifiers modifiers,
                                  CanvasFeedback& feedback) const {
  CurvePoint wanted{pointer.displacement_mm - grabOffset_.displacement_mm,
                    pointer.force_N - grabOffset_.force_N};
  if (modifiers & Qt::ShiftModifier) {  // moves only along one axis, that of the longer distance
    const PlotMapping map = canvas_.mapping();
    const double dx = std::abs(wanted.displacement_mm - task_->from.displacement_mm) * map.pxPerX;
    const double dy = std::abs(wanted.force_N - task_->from.force_N) * map.pxPerY;
    if (dx >= dy)
      wanted.force_N = task_->from.force_N;
    else
      wanted.displacement_mm = task_->from.displacement_mm;
  }
  if (!task_->snaps || modifiers & Qt::ControlModifier) return wanted;
  const ForceGraph& start = document_.history().committed().states()[document_.activeState()].graph;
  SnapSources sources{canvas_.tracedPoints(task_->stroke), nullptr};
  if (start.release())
    sources.otherStroke = &start.curve(task_->stroke == Stroke::press ? Stroke::release : Stroke::press);
  feedback.snap = snapOf(wanted, canvas_.mapping(), canvas_.settings().snap(), sources);
  return feedback.snap ? feedback.snap->at : wanted;
}

void GraphDrag::moveTo(CurvePoint pointer, Qt::KeyboardModifiers modifiers) {
  DETENT_CHECK(running(), "only a running drag moves");
  CanvasFeedback feedback;
  feedback.dragged = canvas_.feedback().dragged;
  feedback.draggedFrom = task_->from;
  const CurvePoint to = wantedPlace(pointer, modifiers, feedback);
  const Result<Button> next = edited(to);
  if (next) {
    preview(*next, to, feedback);
    if (refused_) say_(dragHint(*task_));
  } else if (task_->snaps) {
    stopAtLimit(to, next.failure(), feedback);
  } else {  // the limit of a handle or a segment is vertical, so the last shape stays
    feedback.refused = RefusedMove{to, sentenceOf(next.failure(), canvas_.settings().units())};
    say_(feedback.refused->why);
  }
  refused_ = !next;
  canvas_.setFeedback(feedback);
}

void GraphDrag::preview(const Button& next, CurvePoint to, CanvasFeedback& feedback) {
  document_.history().preview(next);
  const auto place =
      task_->mark ? placeOf(*task_->mark, canvas_.state(), canvas_.values()) : std::optional<CurvePoint>(to);
  feedback.dragged = place.value_or(to);
}

Result<Button> GraphDrag::edited(CurvePoint to) const {
  const EditHistory& history = document_.history();
  auto next = task_->edit(history.committed(), to);
  return next ? history.ruled(*next) : next;
}

// The farthest allowed point on the line from `from` to `to`, a little before the limit; `from` if no other
// point is allowed.
CurvePoint GraphDrag::farthest(CurvePoint from, CurvePoint to) const {
  const auto at = [&](double share) {
    return CurvePoint{from.displacement_mm + share * (to.displacement_mm - from.displacement_mm),
                      from.force_N + share * (to.force_N - from.force_N)};
  };
  if (edited(to)) return to;
  double allowed = 0, refused = 1;
  for (int i = 0; i < limitSteps; ++i) {
    const double middle = 0.5 * (allowed + refused);
    (edited(at(middle)) ? allowed : refused) = middle;
  }
  // a contact moves without changing the curve
  if (task_->mark && isContact(task_->mark->kind)) return at(allowed);
  const PlotMapping map = canvas_.mapping();
  const double way_px = std::hypot((to.displacement_mm - from.displacement_mm) * map.pxPerX,
                                   (to.force_N - from.force_N) * map.pxPerY);
  return at(std::max(0.0, allowed - clearance_px / std::max(way_px, clearance_px)));
}

// Tries the straight line from the start of the drag to the pointer, then each axis, so that the result
// depends only on the pointer's position.
void GraphDrag::stopAtLimit(CurvePoint wanted, const Failure& why, CanvasFeedback& feedback) {
  CurvePoint limit = farthest(task_->from, wanted);
  limit = farthest(limit, {wanted.displacement_mm, limit.force_N});
  limit = farthest(limit, {limit.displacement_mm, wanted.force_N});
  feedback.snap.reset();
  const QString reason = sentenceOf(why, canvas_.settings().units());
  feedback.refused = RefusedMove{wanted, QCoreApplication::translate("GraphDrag", "The move stops at %1. %2")
                                             .arg(placeText(limit, canvas_.settings().units()), reason)};
  if (const auto stopped = edited(limit)) preview(*stopped, limit, feedback);
  say_(feedback.refused->why);
}

void GraphDrag::clear() {
  task_.reset();
  say_({});
  refused_ = false;
  canvas_.setFeedback({});
}

void GraphDrag::finish() {
  DETENT_CHECK(running(), "only a running drag finishes");
  clear();
  document_.history().finishDrag();
}

void GraphDrag::cancel() {
  DETENT_CHECK(running(), "only a running drag is cancelled");
  clear();
  document_.history().cancelDrag();
}

}  // namespace detent::editor
