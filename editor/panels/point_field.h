// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Numeric fields beside a selected point.

#include <optional>
#include <QFrame>
#include <QLabel>

#include "editor/canvas/graph_marks.h"
#include "editor/document/button_document.h"
#include "editor/document/view_settings.h"
#include "editor/quantity/quantity_field.h"
#include "editor/tools/tool.h"

namespace detent::editor {

/// Name of a field; dragging it changes the value. GUI thread.
class ScrubLabel : public QLabel {
  Q_OBJECT

 public:
  explicit ScrubLabel(const QString& text, QuantityField& field);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  QuantityField& field_;
  int taken_px_ = 0;  ///< pointer distance already converted to steps
};

/// Displacement, force and slope of the selected point over the canvas. Typed or dragged values show at once;
/// Enter, or a click elsewhere, makes one step, Escape restores. Holds the button while open. GUI thread.
class PointField : public QFrame {
  Q_OBJECT

 public:
  /// All three must outlive it; it lies on the canvas.
  PointField(ButtonDocument& document, ViewSettings& settings, GraphCanvas& canvas);
  ~PointField() override;

  /// Opens for the selected mark; returns false if it has no numbers, or another edit holds the button.
  bool open(FirstValue first);
  bool isOpen() const { return mark_.has_value(); }

 signals:
  void said(const QString& text);

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  struct Row {
    ScrubLabel* label = nullptr;
    QuantityField* field = nullptr;
    bool changed = false;
  };
  Row makeRow(const char* name, const QString& text, Quantity quantity);
  void show(Row& row, std::optional<double> value);
  void fill(const Mark& mark);
  void place(CurvePoint at);
  Result<Button> edited() const;
  void preview();
  bool odd();
  void finish();
  void cancel();
  void close();

  ButtonDocument& document_;
  ViewSettings& settings_;
  GraphCanvas& canvas_;
  Row displacement_, force_, slopeBefore_, slopeAfter_;
  QLabel* trouble_;
  std::optional<Mark> mark_;    ///< the edited mark and its position when this was opened
  std::optional<MarkId> knot_;  ///< its knot, if there is one
  QString questionText_;        ///< unusual number that was questioned
};

}  // namespace detent::editor
