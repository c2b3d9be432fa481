// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One drag over a document: previews while it moves, one step at its end, exactly as before if cancelled.

#include <functional>
#include <optional>
#include <QString>

#include "editor/canvas/graph_canvas.h"
#include "model/result.h"

namespace detent::editor {

/// What is dragged and how it changes the button.
struct DragTask {
  using Edit = std::function<Result<Button>(const Button& start, CurvePoint to)>;

  QString label;    ///< of the undo step
  CurvePoint from;  ///< where the dragged thing stands
  Stroke stroke = Stroke::press;
  std::optional<MarkId> mark;  ///< whose place is shown while it moves; none: the wanted place
  bool snaps = true;
  /// From the button before the drag. Where it fails, a point stops at the limit, other things keep their last shape.
  Edit edit;
};

/// GUI thread. `say` gets the sentence of a refusal, and an empty one when it is over.
class GraphDrag {
 public:
  GraphDrag(ButtonDocument& document, GraphCanvas& canvas, std::function<void(const QString&)> say);

  bool running() const { return task_.has_value(); }
  /// `pointer` keeps its distance from the dragged thing.
  void begin(DragTask task, CurvePoint pointer);
  /// Snaps if the settings and the task want it; Ctrl lets go.
  void moveTo(CurvePoint pointer, Qt::KeyboardModifiers modifiers = {});
  void finish();
  void cancel();

 private:
  void clear();
  void preview(const Button& next, CurvePoint to, CanvasFeedback& feedback);
  /// What the drag makes of the button it began with.
  Result<Button> edited(CurvePoint to) const;
  CurvePoint farthest(CurvePoint from, CurvePoint to) const;
  void stopAtLimit(CurvePoint wanted, const Failure& why, CanvasFeedback& feedback);
  CurvePoint wantedPlace(CurvePoint pointer, Qt::KeyboardModifiers modifiers, CanvasFeedback& feedback) const;

  ButtonDocument& document_;
  GraphCanvas& canvas_;
  std::function<void(const QString&)> say_;
  std::optional<DragTask> task_;
  CurvePoint grabOffset_;
  bool refused_ = false;
};

}  // namespace detent::editor
