// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/adding_tools.h"

#include <cmath>
#include <QCoreApplication>

#include "editor/document/message_words.h"
#include "editor/tools/hit_test.h"
#include "editor/tools/mark_edits.h"

namespace detent::editor {
namespace {

constexpr double addingReach_px = 24;  // a wide reach, because a curve is the target, not a point
constexpr double leastDrag_px = 6;     // a shorter drag counts as a click
// Size of a jump that a click adds: an eighth of the travel wide, a fifth of its tactile force deep.
constexpr double usualWidthOfTravel = 0.125, usualDropOfForce = 0.2;

QString tr(const char* text) { return QCoreApplication::translate("detent::editor::AddKnotTool", text); }

bool missed(ToolContext& context, const QString& what) {
  context.say(what);
  return true;
}

NewJump usualJump(const StrokeCurve& curve, CurvePoint at) {
  return {at.displacement_mm, usualWidthOfTravel * curve.travel_mm(),
          std::max(usualDropOfForce * std::abs(at.force_N), 1e-3)};
}

// The pointer pulls the turn of the jump, half its width away.
NewJump jumpTowards(CurvePoint at, CurvePoint turn) {
  return {at.displacement_mm, 2 * std::abs(turn.displacement_mm - at.displacement_mm),
          std::abs(turn.force_N - at.force_N)};
}

/// Shows where a press would add something, and shapes it during the drag.
class AddingTool : public Tool {
 public:
  using Tool::Tool;
  void leave() override { context_.canvas.setFeedback({}); }
  bool moved(const PointerInput& input) override {
    if (context_.drag.running()) {
      context_.drag.moveTo(input.at, input.modifiers);
      return true;
    }
    CanvasFeedback feedback;
    if (const auto hit = curveAt(context_.canvas, input.at_px, addingReach_px))
      feedback.proposal = Proposal{hit->at, hit->stroke, {}};
    context_.canvas.setFeedback(feedback);
    return true;
  }
  bool released(const PointerInput& input) override {
    if (input.button != Qt::LeftButton || !context_.drag.running()) return false;
    context_.drag.finish();
    return true;
  }
  Qt::CursorShape cursor() const override { return Qt::CrossCursor; }
};

class AddKnotTool : public AddingTool {
 public:
  using AddingTool::AddingTool;
  QString hint() const override {
    return tr("Click a curve to add a curve point. Keep the button down to move the new point.");
  }
  bool pressed(const PointerInput& input) override {
    if (input.button != Qt::LeftButton || context_.busy()) return false;
    const auto hit = curveAt(context_.canvas, input.at_px, addingReach_px);
    if (!hit) return missed(context_, tr("There is no curve here. Click nearer to one."));
    const std::size_t state = context_.document.activeState();
    const auto added =
        addKnot(context_.document.history().committed(), state, hit->stroke, hit->at.displacement_mm);
    if (!added) return missed(context_, sentenceOf(added.failure()));
    const auto knot = knotAt(added->states()[state].graph.curve(hit->stroke), hit->at.displacement_mm);
    if (!knot) return false;
    const MarkId id{MarkKind::knot, hit->stroke, *knot};
    DragTask task;
    task.label = tr("Add curve point");
    task.from = hit->at;
    task.stroke = hit->stroke;
    task.mark = id;
    task.edit = [state, id, from = hit->at, base = *added](const Button&, CurvePoint to) {
      return to == from ? Result<Button>(base) : moveMark(base, state, {id, from}, to);
    };
    context_.drag.begin(std::move(task), input.at);
    // Snapping waits for the first move, because a click does not change the shape.
    context_.drag.moveTo(input.at, Qt::ControlModifier);
    context_.canvas.setSelected(id);
    return true;
  }
};

class AddJumpTool : public AddingTool {
 public:
  using AddingTool::AddingTool;
  QString hint() const override {
    return tr(
        "Hold the mouse button where the jump begins, on a rising part of a curve. Then drag the valley into "
        "place.");
  }
  bool pressed(const PointerInput& input) override {
    if (input.button != Qt::LeftButton || context_.busy()) return false;
    const auto hit = curveAt(context_.canvas, input.at_px, addingReach_px);
    if (!hit) return missed(context_, tr("There is no curve here. Start nearer to one."));
    const std::size_t state = context_.document.activeState();
    DragTask task;
    task.label = tr("Add jump");
    task.from = hit->at;
    task.stroke = hit->stroke;
    task.edit = [state, stroke = hit->stroke, at = hit->at](const Button& start, CurvePoint to) {
      const NewJump jump =
          to == at ? usualJump(start.states()[state].graph.curve(stroke), at) : jumpTowards(at, to);
      return addJumpAt(start, state, stroke, jump);
    };
    context_.drag.begin(std::move(task), input.at);
    context_.drag.moveTo(input.at, Qt::ControlModifier);
    return true;
  }
};

class PanTool : public Tool {
 public:
  using Tool::Tool;
  QString hint() const override { return tr("Drag to move the view; the wheel zooms at the pointer."); }
  void leave() override { last_px_.reset(); }
  bool pressed(const PointerInput& input) override {
    if (input.button != Qt::LeftButton) return false;
    last_px_ = input.at_px;
    context_.canvas.setCursor(Qt::ClosedHandCursor);
    return true;
  }
  bool moved(const PointerInput& input) override {
    if (!last_px_) return false;
    context_.canvas.panBy(input.at_px - *last_px_);
    last_px_ = input.at_px;
    return true;
  }
  bool released(const PointerInput& input) override {
    if (input.button != Qt::LeftButton || !last_px_) return false;
    last_px_.reset();
    context_.canvas.setCursor(Qt::OpenHandCursor);
    return true;
  }
  Qt::CursorShape cursor() const override { return Qt::OpenHandCursor; }

 private:
  std::optional<QPointF> last_px_;
};

class MeasureTool : public Tool {
 public:
  using Tool::Tool;
  QString hint() const override {
    return tr("Drag from one place to another, or click both, to measure between them. Ctrl: no snapping.");
  }
  void leave() override {
    from_.reset();
    context_.canvas.setFeedback({});
  }
  bool pressed(const PointerInput& input) override {
    if (input.button != Qt::LeftButton) return false;
    if (moved(input)) {  // the second of two clicks
      from_.reset();
      return true;
    }
    leave();
    from_ = placeAt(input);
    from_px_ = input.at_px;
    context_.canvas.setFeedback(measuredTo(*from_));
    return true;
  }
  bool moved(const PointerInput& input) override {
    if (!context_.canvas.feedback().measured) from_.reset();  // an edit has ended the measurement
    if (!from_) return false;
    context_.canvas.setFeedback(measuredTo(placeAt(input)));
    return true;
  }
  // A click leaves the first place open until the second one.
  bool released(const PointerInput& input) override {
    if (input.button != Qt::LeftButton || !from_) return false;
    if ((input.at_px - from_px_).manhattanLength() >= leastDrag_px) from_.reset();
    return true;
  }
  Qt::CursorShape cursor() const override { return Qt::CrossCursor; }

 private:
  CurvePoint placeAt(const PointerInput& input) const {
    if (input.modifiers & Qt::ControlModifier) return input.at;
    for (const Mark& mark : marksAt(context_.canvas, input.at_px))
      if (!isSlope(mark.id.kind)) return mark.at;  // the end of a slope handle lies beside the curve
    const auto hit = curveAt(context_.canvas, input.at_px);
    return hit ? hit->at : input.at;
  }
  CanvasFeedback measuredTo(CurvePoint to) const {
    CanvasFeedback feedback;
    feedback.measured = Measurement{*from_, to};
    return feedback;
  }

  std::optional<CurvePoint> from_;
  QPointF from_px_;
};

class ZoomTool : public Tool {
 public:
  using Tool::Tool;
  QString hint() const override {
    return tr("Drag a rectangle to zoom in; click zooms in, Shift+click zooms out, F fits.");
  }
  void leave() override {
    from_px_.reset();
    context_.canvas.setFeedback({});
  }
  bool pressed(const PointerInput& input) override {
    if (input.button != Qt::LeftButton) return false;
    from_px_ = input.at_px;
    return true;
  }
  bool moved(const PointerInput& input) override {
    if (!from_px_) return false;
    CanvasFeedback feedback;
    feedback.band_px = QRectF(*from_px_, input.at_px).normalized();
    context_.canvas.setFeedback(feedback);
    return true;
  }
  bool released(const PointerInput& input) override {
    if (input.button != Qt::LeftButton || !from_px_) return false;
    const QRectF part_px = QRectF(*from_px_, input.at_px).normalized();
    leave();
    if (part_px.width() >= leastDrag_px && part_px.height() >= leastDrag_px) {
      context_.canvas.zoomTo(part_px);
    } else {
      const double factor = input.modifiers & Qt::ShiftModifier ? 0.5 : 2;
      context_.canvas.zoomAt(input.at_px, factor, factor);
    }
    return true;
  }
  Qt::CursorShape cursor() const override { return Qt::CrossCursor; }

 private:
  std::optional<QPointF> from_px_;
};

}  // namespace

std::unique_ptr<Tool> addKnotTool(ToolContext& context) { return std::make_unique<AddKnotTool>(context); }
std::unique_ptr<Tool> addJumpTool(ToolContext& context) { return std::make_unique<AddJumpTool>(context); }
std::unique_ptr<Tool> panTool(ToolContext& context) { return std::make_unique<PanTool>(context); }
std::unique_ptr<Tool> measureTool(ToolContext& context) { return std::make_unique<MeasureTool>(context); }
std::unique_ptr<Tool> zoomTool(ToolContext& context) { return std::make_unique<ZoomTool>(context); }

}  // namespace detent::editor
