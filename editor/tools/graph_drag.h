// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One drag over a document: previews while it moves, one step at its end, restored exactly if cancelled.

#include <functional>
#include <optional>
#include <QString>

#include "editor/canvas/graph_canvas.h"
#include "model/result.h"

namespace detent::editor {

/// The dragged item and its effect on the button.
struct DragTask {
  using Edit = std::function<Result<Button>(const Button& start, CurvePoint to)>;

  QString label;    ///< label of the undo step
  CurvePoint from;  ///< start position of the dragged item
  Stroke stroke = Stroke::press;
  std::optional<MarkId> mark;  ///< mark whose position is shown; nullopt: the pointer's
  bool snaps = true;
  /// The edit, computed from the button before the drag. If it fails, a point stops at the limit, other items
  /// keep their last shape.
  Edit edit;
};

/// GUI thread. `say` receives the sentence of a refusal, and an empty text when the refusal ends.
class GraphDrag {
 public:
  GraphDrag(ButtonDocument& document, GraphCanvas& canvas, std::function<void(const QString&)> say);

  bool running() const { return task_.has_value(); }
  /// The pointer keeps its distance from the dragged item.
  void begin(DragTask task, CurvePoint pointer);
  /// Snaps if the settings and the task allow it; Ctrl disables snapping.
  void moveTo(CurvePoint pointer, Qt::KeyboardModifiers modifiers = {});
  void finish();
  void cancel();

 private:
  void clear();
  void preview(const Button& next, CurvePoint to, CanvasFeedback& feedback);
  /// Result of the drag on the original button.
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
