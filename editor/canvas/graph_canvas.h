// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The force graph of a document's active state, over its datasheet page.

#include <memory>
#include <optional>

#include "editor/canvas/canvas_events.h"
#include "editor/canvas/canvas_feedback.h"
#include "editor/canvas/graph_painting.h"
#include "editor/canvas/mark_identity.h"
#include "editor/canvas/unit_plot.h"
#include "editor/document/button_document.h"

namespace detent::editor {

class PageUnderlay;
class TracedPoints;

/// Draws the document; passes mouse and keys to the owner of the tools. GUI thread.
class GraphCanvas : public UnitPlot {
  Q_OBJECT

 public:
  GraphCanvas(ButtonDocument& document, ViewSettings& settings, QWidget* parent = nullptr);

  /// Receives the canvas events; not owned. Null: the canvas can only be viewed, zoomed and panned.
  void setEvents(CanvasEvents* events) { events_ = events; }

  const ButtonState& state() const;
  /// Values of the active state; computed once per change.
  const GraphValues& values() const;
  /// Traced points in mm and N, in the order travelled; empty without an origin.
  const std::vector<CurvePoint>& tracedPoints(Stroke stroke) const;
  bool hasUnderlay() const;

  const CanvasFeedback& feedback() const { return feedback_; }
  void setFeedback(const CanvasFeedback& feedback);
  /// The mark selected last; it keeps its identity through edits of other marks (mark_identity.h).
  std::optional<MarkId> selected() const;
  /// All selected marks, the last selected at the end; no duplicates.
  const std::vector<MarkId>& selection() const { return selection_; }
  /// Selects only this mark, or none.
  void setSelected(const std::optional<MarkId>& selected);
  void setSelection(std::vector<MarkId> marks);
  bool isSelected(MarkId mark) const;
  /// The mark whose label lies there.
  std::optional<MarkId> flagAt(QPointF at_px) const;
  void showFinger(std::optional<FingerPosition> finger);
  /// Possible new active state, drawn dashed; nullopt: none. Never in exported pictures.
  void showPreview(std::optional<ButtonState> preview);
  /// Curves of another button, drawn behind the own ones; nullopt: none. Never in exported pictures.
  void showReference(std::optional<Reference> reference);
  const std::optional<Reference>& reference() const { return reference_; }
  /// Spread of the units whose mean the button was when this was set, per state: a band behind the curves.
  void showSpread(std::vector<StateSpread> states);
  void setMagnifierShown(bool shown);
  /// Shows knots and handles; without them the picture resembles a datasheet.
  void setHandlesShown(bool shown);

  /// Draws the graph as vectors into any device (SVG, printer); `size` in its units. renderTo and the next
  /// function draw on a second, hidden canvas.
  void renderTo(QPaintDevice& device, QSize size, const QPalette& palette) const;
  QImage renderImage(QSize size_px, double devicePixelRatio) const;

 signals:
  void cursorMoved(std::optional<CurvePoint> at);
  void selectionChanged();

 protected:
  void drawContent(QPainter& painter, const PlotMapping& map) const override;
  QRectF contentRange() const override;
  void colorsChanged() override;
  bool event(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  std::unique_ptr<GraphCanvas> forPicture(const QPalette& palette) const;
  GraphScene scene() const;
  PointerInput inputOf(const QMouseEvent* event) const;
  void takeOrigin();
  void takeSettings();
  void graphChanged();
  void stateChanged();
  void followSelection();
  void rememberSelection();
  void showSelection();
  void drawMagnifier(QPainter& painter, const PlotMapping& map) const;

  ButtonDocument& document_;
  CanvasEvents* events_ = nullptr;
  PageUnderlay* underlay_;  // owned by QCustomPlot
  TracedPoints* traced_;    // owned by QCustomPlot
  mutable std::optional<GraphValues> values_;
  CanvasFeedback feedback_;
  mutable std::vector<Flag> flags_;  // as they were drawn last
  std::vector<MarkId> selection_;
  // State on which the selection was made; during a drag the selection is followed from there, not from frame
  // to frame.
  std::optional<MarkedState> selectedOn_;
  std::vector<MarkId> selectionThere_;
  std::size_t selectedState_ = 0;
  std::optional<FingerPosition> finger_;
  std::optional<ButtonState> preview_;
  std::optional<Reference> reference_;
  std::vector<StateSpread> spread_;  // empty: no band
  bool magnifierShown_ = true, handlesShown_ = true;
};

}  // namespace detent::editor
