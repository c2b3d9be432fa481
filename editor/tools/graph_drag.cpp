// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/graph_drag.h"

#include <QCoreApplication>

#include "editor/tools/snapping.h"
#include "model/check.h"

namespace detent::editor {
namespace {

constexpr int limitSteps = 14;  // halvings: a 16,000th of the way, less than a pixel

}  // namespace

GraphDrag::GraphDrag(ButtonDocument& document, GraphCanvas& canvas, std::function<void(const QString&)> say)
    : document_(document), canvas_(canvas), say_(std::move(say)) {}

void GraphDrag::begin(DragTask task, CurvePoint pointer) {
  DETENT_CHECK(!running(), "one drag at a time");
  grabOffset_ = {pointer.displacement_mm - task.from.displacement_mm, pointer.force_N - task.from.force_N};
  document_.history().beginDrag(task.label);
  task_ = std::move(task);
  CanvasFeedback feedback;
  feedback.dragged = task_->from;
  canvas_.setFeedback(feedback);
}

CurvePoint GraphDrag::wantedPlace(CurvePoint pointer, Qt::KeyboardModifiers modifiers,
                                  CanvasFeedback& feedback) const {
  CurvePoint wanted{pointer.displacement_mm - grabOffset_.displacement_mm,
                    pointer.force_N - grabOffset_.force_N};
  if (modifiers & Qt::ShiftModifier) {  // along the axis of the longer way
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
  const CurvePoint to = wantedPlace(pointer, modifiers, feedback);
  const Result<Button> next = task_->edit(document_.history().committed(), to);
  if (next) {
    preview(*next, to, feedback);
    if (refused_) say_({});
  } else if (task_->snaps) {
    stopAtLimit(to, next.failure(), feedback);
  } else {  // a handle's limit is a wall, a section's has no one place: the last shape stays
    feedback.refused = RefusedMove{to, QString::fromStdString(next.failure().sentence())};
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

// The farthest allowed place on the way from one to another, itself allowed or `from`.
CurvePoint GraphDrag::farthest(CurvePoint from, CurvePoint to) const {
  const auto at = [&](double share) {
    return CurvePoint{from.displacement_mm + share * (to.displacement_mm - from.displacement_mm),
                      from.force_N + share * (to.force_N - from.force_N)};
  };
  const Button& start = document_.history().committed();
  if (task_->edit(start, to)) return to;
  double allowed = 0, refused = 1;
  for (int i = 0; i < limitSteps; ++i) {
    const double middle = 0.5 * (allowed + refused);
    (task_->edit(start, at(middle)) ? allowed : refused) = middle;
  }
  return at(allowed);
}

// From where the drag began straight to the pointer, then along each axis: where it stops depends on the
// pointer alone, not on the way it took.
void GraphDrag::stopAtLimit(CurvePoint wanted, const Failure& why, CanvasFeedback& feedback) {
  CurvePoint limit = farthest(task_->from, wanted);
  limit = farthest(limit, {wanted.displacement_mm, limit.force_N});
  limit = farthest(limit, {limit.displacement_mm, wanted.force_N});
  feedback.snap.reset();
  const QString reason = QString::fromStdString(why.sentence());
  feedback.refused = RefusedMove{wanted, QCoreApplication::translate("GraphDrag", "Stops at %1. %2")
                                             .arg(placeText(limit, canvas_.settings().units()), reason)};
  if (const auto stopped = task_->edit(document_.history().committed(), limit))
    preview(*stopped, limit, feedback);
  say_(feedback.refused->why);
}

void GraphDrag::clear() {
  task_.reset();
  if (refused_) say_({});
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
