// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Centre of a tab: the force graph with its tools, the displacement-force view, damping if the button has it,
// and the bar with the shown state.

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
class ToolBox;
enum class FirstValue;

/// GUI thread. `document` and `settings` must outlive it.
class GraphWorkspace : public QWidget {
  Q_OBJECT

 public:
  GraphWorkspace(ButtonDocument& document, ViewSettings& settings, QWidget* parent = nullptr);
  ~GraphWorkspace() override;

  /// Checkable, exclusive: select, add knot, add jump, pan.
  QList<QAction*> toolActions() const { return toolActions_; }
  /// Groups of the edit actions, all with shortcuts and tool tips.
  enum EditGroup {
    clipboard,    ///< cut, copy
    selection,    ///< delete, select all
    arrangement,  ///< corner or smooth, align, distribute
    operations    ///< includes separators
  };
  static constexpr int editGroups = operations + 1;
  QList<QAction*> editActions(EditGroup group) const { return editActions_[group]; }
  QList<QAction*> editActions() const;
  /// Fit, zoom, second view, damping, residuals, magnifier, handles, snapping. Includes separators.
  QList<QAction*> viewActions() const { return viewActions_; }

  /// Copies the selection as text (knot_text.h); without one, requests the whole button.
  void copySelected();
  /// Inserts the stretch in one step; reports the reason if the graph refuses it.
  void paste(const GraphStretch& stretch);

  /// Shows the finger of the feel panel; nullopt: hidden.
  void showFinger(std::optional<FingerPosition> finger);

  /// The force graph as shown, without handles, for copy and export.
  QImage renderImage(QSize size_px, double devicePixelRatio) const;

  GraphCanvas& canvas() { return *canvas_; }
  ToolBox& tools() { return *tools_; }

 signals:
  /// Position of the pointer in mm and N; nullopt when it left the plot.
  void cursorMoved(std::optional<detent::CurvePoint> at);
  /// Refusals and hints for the status bar; empty clears it.
  void statusMessage(const QString& text);
  /// The user wants to type numbers of the selected point.
  void valuesRequested(detent::editor::FirstValue first);
  /// Copy was requested without a selection.
  void buttonCopyRequested();

 private:
  QWidget* makeBar();
  void makeToolActions();
  void makeEditActions();
  QAction* addEditAction(EditGroup group, const char* name, const QString& text, const QString& tip,
                         const QKeySequence& key, const std::function<void()>& act);
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
  std::unique_ptr<OperationMenu> operations_;
  QWidget* bar_ = nullptr;
  QComboBox* states_ = nullptr;
  QLabel* statesLabel_ = nullptr;
  QComboBox* speeds_ = nullptr;
  QLabel* speedsLabel_ = nullptr;
  QLabel* underlayLabel_ = nullptr;
  QSlider* underlay_ = nullptr;
  QList<QAction*> toolActions_, viewActions_;
  std::array<QList<QAction*>, editGroups> editActions_;
  QList<QAction*> severalActions_;  ///< require several selected points
  QAction *cutAction_ = nullptr, *deleteAction_ = nullptr, *cornerAction_ = nullptr, *dampingShown_ = nullptr,
          *residualsShown_ = nullptr, *snapGrid_ = nullptr, *snapTraced_ = nullptr, *snapOther_ = nullptr;
};

}  // namespace detent::editor
