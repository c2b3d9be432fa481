// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/keyboard.h"

#include <algorithm>
#include <QCoreApplication>

#include "editor/document/message_words.h"
#include "editor/tools/mark_edits.h"

namespace detent::editor {
namespace {

QString tr(const char* text, const char* note = nullptr, int n = -1) {
  return QCoreApplication::translate("detent::editor::Keyboard", text, note, n);
}

// With more points, Tab skips plain knots.
constexpr std::size_t mostWalked = 150;

bool isArrow(int key) {
  return key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
}

bool asksValues(int key) { return key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_F2; }

}  // namespace

bool Keyboard::wants(int key, Qt::KeyboardModifiers modifiers) const {
  if (key == Qt::Key_Escape) return context_.drag.running() || context_.canvas.selected().has_value();
  if (!context_.canvas.selected()) return false;
  if (isArrow(key)) return !(modifiers & Qt::ControlModifier);
  const bool plain = (modifiers & ~Qt::KeypadModifier) == Qt::NoModifier;
  return plain && (key == Qt::Key_Delete || key == Qt::Key_Backspace || key == Qt::Key_Insert ||
                   key == Qt::Key_C || key == Qt::Key_S || key == Qt::Key_P || asksValues(key));
}

bool Keyboard::pressed(int key, Qt::KeyboardModifiers modifiers) {
  if (context_.busy()) return isArrow(key) || key == Qt::Key_Tab || key == Qt::Key_Backtab;
  if (key == Qt::Key_Tab && modifiers == Qt::NoModifier) return selectBy(1);
  if (key == Qt::Key_Backtab) return selectBy(-1);
  if (!wants(key, modifiers)) return false;
  if (isArrow(key)) return nudge(key, modifiers);
  if (key == Qt::Key_Escape) context_.canvas.setSelected({});
  if (key == Qt::Key_Delete || key == Qt::Key_Backspace) removeSelected();
  if (key == Qt::Key_Insert) addKnotBeyond();
  if (key == Qt::Key_C) toggleSelectedCorner();
  if (key == Qt::Key_P) togglePin();
  if (asksValues(key)) context_.askValues(key == Qt::Key_F2 ? FirstValue::force : FirstValue::displacement);
  if (key == Qt::Key_S) return nextSlopeHandle();
  return true;
}

bool Keyboard::selectBy(int by) {
  std::vector<Mark> marks = pointMarks(context_.canvas.state(), context_.canvas.values());
  if (marks.size() > mostWalked)
    std::erase_if(marks, [](const Mark& m) { return m.id.kind == MarkKind::knot; });
  const int count = static_cast<int>(marks.size());
  int next = by > 0 ? 0 : count - 1;
  for (int i = 0; i < count; ++i)
    if (marks[static_cast<std::size_t>(i)].id == context_.canvas.selected()) next = i + by;
  if (next < 0 || next >= count) {
    context_.canvas.setSelected({});
    return false;  // the focus moves on
  }
  const Mark& mark = marks[static_cast<std::size_t>(next)];
  context_.canvas.setSelected(mark.id);
  context_.say(describe(mark, context_.settings.units()));
  return true;
}

void Keyboard::apply(const Result<Button>& next, const QString& label, const QString& mergeKey) {
  const Result<Button> kept = next ? context_.document.history().ruled(*next) : next;
  if (!kept) {
    const QString why = sentenceOf(kept.failure(), context_.settings.units());
    CanvasFeedback feedback;
    const auto last = context_.canvas.selected();
    const auto at = last ? placeOf(*last, context_.canvas.state(), context_.canvas.values()) : std::nullopt;
    if (at) feedback.refused = RefusedMove{*at, why};
    context_.canvas.setFeedback(feedback);
    context_.say(why);
    return;
  }
  context_.canvas.setFeedback({});
  context_.document.history().apply(*kept, label, mergeKey);
}

bool Keyboard::nudge(int key, Qt::KeyboardModifiers modifiers) {
  const MarkId id = *context_.canvas.selected();
  const auto at = placeOf(id, context_.canvas.state(), context_.canvas.values());
  if (!at) return false;
  const double times = modifiers & Qt::ShiftModifier ? 10 : modifiers & Qt::AltModifier ? 0.1 : 1;
  const double right = key == Qt::Key_Right ? times : key == Qt::Key_Left ? -times : 0;
  const double up = key == Qt::Key_Up ? times : key == Qt::Key_Down ? -times : 0;
  const std::size_t state = context_.document.activeState();
  const Button& button = context_.document.history().committed();
  const QString mergeKey = QStringLiteral("nudge/%1/%2/%3/%4")
                               .arg(state)
                               .arg(static_cast<int>(id.kind))
                               .arg(static_cast<int>(id.stroke))
                               .arg(id.index);
  if (context_.canvas.selection().size() > 1) return nudgeAll(right, up);
  if (isSlope(id.kind)) {
    const Knot& knot = context_.canvas.state().graph.curve(id.stroke).knots()[id.index];
    const double slope =
        id.kind == MarkKind::slopeBefore ? knot.slopeBefore_N_per_mm : knot.slopeAfter_N_per_mm;
    apply(setMarkSlope(button, state, id, slope + (right + up) * nudgeSlope_N_per_mm), moveLabel(id),
          mergeKey);
    return true;
  }
  const CurvePoint to{at->displacement_mm + right * nudge_mm, at->force_N + up * nudge_N};
  apply(moveMark(button, state, {id, *at}, to), moveLabel(id), mergeKey);
  return true;
}

bool Keyboard::nudgeAll(double right, double up) {
  const std::vector<MarkId> marks = context_.canvas.selection();
  QString key = QStringLiteral("nudge/%1").arg(context_.document.activeState());
  for (const MarkId& mark : marks)
    key += QStringLiteral("/%1.%2.%3")
               .arg(static_cast<int>(mark.kind))
               .arg(static_cast<int>(mark.stroke))
               .arg(mark.index);
  apply(moveSelection(context_.document.history().committed(), context_.document.activeState(), marks,
                      right * nudge_mm, up * nudge_N),
        tr("Move %n points", nullptr, static_cast<int>(marks.size())), key);
  return true;
}

void Keyboard::selectAll() {
  if (context_.busy()) return;
  const std::vector<MarkId> all = allPoints(context_.canvas.state());
  context_.canvas.setSelection(all);
  context_.say(tr("%n points selected", nullptr, static_cast<int>(all.size())));
}

void Keyboard::align(GraphDirection direction) {
  if (context_.busy()) return;
  apply(alignSelection(context_.document.history().committed(), context_.document.activeState(),
                       context_.canvas.selection(), direction),
        direction == GraphDirection::force ? tr("Align to the same force")
                                           : tr("Align to the same displacement"));
}

void Keyboard::distribute(GraphDirection direction) {
  if (context_.busy()) return;
  apply(
      distributeSelection(context_.document.history().committed(), context_.document.activeState(),
                          context_.canvas.selection(), direction),
      direction == GraphDirection::force ? tr("Distribute over force") : tr("Distribute over displacement"));
}

std::optional<MarkId> Keyboard::selectedKnot() const {
  auto selected = context_.canvas.selected();
  if (!selected) return {};
  if (selected->kind == MarkKind::knot) return selected;
  if (isSlope(selected->kind)) return MarkId{MarkKind::knot, selected->stroke, selected->index};
  if (selected->kind != MarkKind::tactilePoint && selected->kind != MarkKind::turn) return {};
  const auto at = placeOf(*selected, context_.canvas.state(), context_.canvas.values());
  if (!at) return {};
  const auto knot = knotAt(context_.canvas.state().graph.curve(selected->stroke), at->displacement_mm);
  if (!knot) return {};
  return MarkId{MarkKind::knot, selected->stroke, *knot};
}

void Keyboard::removeSelected() {
  auto selected = context_.canvas.selected();
  if (!selected || context_.busy()) return;
  if (const auto& all = context_.canvas.selection(); all.size() > 1)
    return apply(
        removeSelection(context_.document.history().committed(), context_.document.activeState(), all),
        tr("Remove %n points", nullptr, static_cast<int>(all.size())));
  if (selected->kind == MarkKind::turn || isSlope(selected->kind)) selected = selectedKnot();
  if (!selected) {
    context_.say(
        tr("There is no curve point at this valley or peak. Select a curve point or a tactile point."));
    return;
  }
  apply(removeMark(context_.document.history().committed(), context_.document.activeState(), *selected),
        removeLabel(*selected));
}

void Keyboard::toggleSelectedCorner() {
  if (context_.busy()) return;
  const auto knot = selectedKnot();
  if (!knot) {
    context_.say(tr("Select a curve point to make it a corner or smooth."));
    return;
  }
  apply(toggleCorner(context_.document.history().committed(), context_.document.activeState(), *knot),
        tr("Corner or smooth: %1").arg(nameOf(*knot)));
}

void Keyboard::togglePin() {
  const auto selected = context_.canvas.selected();
  if (!selected || context_.busy()) return;
  const auto at = placeOf(*selected, context_.canvas.state(), context_.canvas.values());
  if (!at) return;
  const PinnedPoint pin{context_.document.activeState(), selected->stroke, at->displacement_mm};
  Annotations next = context_.document.annotations();
  const bool pinned = std::erase(next.links.pinned, pin) > 0;
  if (!pinned) next.links.pinned.push_back(pin);
  context_.document.annotate(std::move(next), pinned ? tr("Unlock a point") : tr("Lock a point"));
  context_.say(pinned ? tr("Unlocked: the point can be moved again.")
                      : tr("Locked: no edit moves this point until you press P on it again."));
}

void Keyboard::addKnotBeyond() {
  const MarkId id = *context_.canvas.selected();
  const auto at = placeOf(id, context_.canvas.state(), context_.canvas.values());
  if (!at) return;
  const StrokeCurve& curve = context_.canvas.state().graph.curve(id.stroke);
  double next_mm = curve.end_mm();
  for (const Knot& k : curve.knots())
    if (k.displacement_mm > at->displacement_mm) next_mm = std::min(next_mm, k.displacement_mm);
  const double middle_mm = at->displacement_mm + 0.5 * (next_mm - at->displacement_mm);
  apply(
      addKnot(context_.document.history().committed(), context_.document.activeState(), id.stroke, middle_mm),
      tr("Add curve point"));
  if (const auto knot = knotAt(context_.canvas.state().graph.curve(id.stroke), middle_mm))
    context_.canvas.setSelected(MarkId{MarkKind::knot, id.stroke, *knot});
}

bool Keyboard::nextSlopeHandle() {
  const auto knot = selectedKnot();
  if (!knot) return true;
  const SlopeHandles handles = slopeHandlesOf(context_.canvas.state().graph.curve(knot->stroke), knot->index,
                                              context_.canvas.mapping());
  const MarkKind now = context_.canvas.selected()->kind;
  MarkKind next = MarkKind::knot;
  if (now != MarkKind::slopeBefore && now != MarkKind::slopeAfter && handles.before_px)
    next = MarkKind::slopeBefore;
  else if (now != MarkKind::slopeAfter && handles.after_px)
    next = MarkKind::slopeAfter;
  const MarkId id{next, knot->stroke, knot->index};
  context_.canvas.setSelected(id);
  context_.say(nameOf(id));
  return true;
}

}  // namespace detent::editor
