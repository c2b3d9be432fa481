// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The middle of a tab: the force graph with its tools, the displacement-force view, damping where a button
// has it, and the bar that says which state is shown.

#include <functional>
#include <memory>
#include <optional>
#include <QAction>
#include <QImage>
#include <QList>
#include <QWidget>

#include "editor/document/button_document.h"
#include "editor/document/finger_position.h"
#include "editor/document/view_settings.h"
#include "editor/tools/knot_text.h"

class QComboBox;
class QLabel;
class QSlider;

namespace detent::editor {

class DampingView;
class DisplacementForceView;
class GraphCanvas;
class OperationDialog;
class OperationMenu;
class PointField;
class ToolBox;

/// GUI thread. `document` and `settings` must outlive it.
class GraphWorkspace : public QWidget {
  Q_OBJECT

 public:
  GraphWorkspace(ButtonDocument& document, ViewSettings& settings, QWidget* parent = nullptr);
  ~GraphWorkspace() override;

  /// Checkable, exclusive: select, add knot, add jump, pan.
  QList<QAction*> toolActions() const { return toolActions_; }
  /// Delete, corner or smooth, and the operations, with shortcuts and tool tips. Separators among them.
  QList<QAction*> editActions() const { return editActions_; }
  /// Fit, zoom, second view, damping, residuals, magnifier, handles, snapping. Separators among them.
  QList<QAction*> viewActions() const { return viewActions_; }

  /// What is selected, as text on the clipboard (knot_text.h); where nothing is, asks for the whole button.
  void copySelected();
  /// One step; says why not where the graph cannot take it.
  void paste(const GraphStretch& stretch);

  /// Where a finger of the feel panel is; nullopt: nowhere.
  void showFinger(std::optional<FingerPosition> finger);

  /// The force graph as it is shown, without handles, for copy and export.
  QImage renderImage(QSize size_px, double devicePixelRatio) const;

  GraphCanvas& canvas() { return *canvas_; }
  ToolBox& tools() { return *tools_; }

 signals:
  /// mm and N; nullopt where the pointer left.
  void cursorMoved(std::optional<detent::CurvePoint> at);
  /// Refusals and hints for the status bar; empty: nothing to say any more.
  void statusMessage(const QString& text);
  /// Copy was asked for with nothing selected.
  void buttonCopyAsked();

 private:
  QWidget* makeBar();
  void makeToolActions();
  void makeEditActions();
  void makeSelectionActions();
  QAction* addEditAction(const char* name, const QString& text, const QString& tip, const QKeySequence& key,
                         const std::function<void()>& act);
  void makeViewActions();
  QAction* addViewAction(const QString& name, const QString& text, const QString& tip,
                         const QKeySequence& key = {});
  QAction* addViewSwitch(const QString& name, const QString& text, const QString& tip, bool on);
  void addSeparator(QList<QAction*>& actions);
  void addSnapActions();
  void followDocument();
  void followSettings();
  void followSpeeds();
  bool barHasChoices() const;
  void showContextMenu(QPoint global_px);

  ButtonDocument& document_;
  ViewSettings& settings_;
  GraphCanvas* canvas_;
  DisplacementForceView* reverse_;
  DampingView* damping_;
  std::unique_ptr<ToolBox> tools_;
  PointField* point_;
  std::unique_ptr<OperationMenu> operations_;
  QWidget* bar_ = nullptr;
  QComboBox* states_ = nullptr;
  QLabel* statesLabel_ = nullptr;
  QComboBox* speeds_ = nullptr;
  QLabel* speedsLabel_ = nullptr;
  QLabel* underlayLabel_ = nullptr;
  QSlider* underlay_ = nullptr;
  QList<QAction*> toolActions_, editActions_, viewActions_;
  QList<QAction*> severalActions_;  ///< need more than one selected point
  QAction *cutAction_ = nullptr, *deleteAction_ = nullptr, *cornerAction_ = nullptr, *dampingShown_ = nullptr,
          *residualsShown_ = nullptr, *snapGrid_ = nullptr, *snapTraced_ = nullptr, *snapOther_ = nullptr;
};

}  // namespace detent::editor
