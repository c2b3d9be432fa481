// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/graph_workspace.h"

#include <algorithm>
#include <QActionGroup>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QSlider>
#include <QSplitter>
#include <QVBoxLayout>

#include "editor/canvas/displacement_force_view.h"
#include "editor/canvas/graph_canvas.h"
#include "editor/document/described.h"
#include "editor/document/message_words.h"
#include "editor/document/state_name.h"
#include "editor/panels/grid_dialog.h"
#include "editor/panels/operation_menu.h"
#include "editor/tools/damping_view.h"
#include "editor/tools/mark_edits.h"
#include "editor/tools/tool_box.h"
#include "model/speed_family.h"

namespace detent::editor {
namespace {

bool isOfTheWindow(const QKeySequence& keys) {
  if (keys.isEmpty() || !(keys[0].keyboardModifiers() & (Qt::ControlModifier | Qt::AltModifier)))
    return false;
  for (const auto own : {QKeySequence::Cut, QKeySequence::Copy, QKeySequence::SelectAll})
    if (keys == QKeySequence(own)) return false;
  return true;
}

}  // namespace

GraphWorkspace::GraphWorkspace(ButtonDocument& document, ViewSettings& settings, QWidget* parent)
    : QWidget(parent),
      document_(document),
      settings_(settings),
      canvas_(new GraphCanvas(document, settings)),
      reverse_(new DisplacementForceView(document, settings, *canvas_)),
      damping_(new DampingView(document, settings)),
      tools_(std::make_unique<ToolBox>(document, settings, *canvas_)),
      operations_(std::make_unique<OperationMenu>(document, settings, *canvas_, *tools_, *this)) {
  auto* left = new QSplitter(Qt::Vertical);
  left->addWidget(canvas_);
  left->addWidget(damping_);
  left->setStretchFactor(0, 3);
  left->setStretchFactor(1, 1);
  left->setChildrenCollapsible(false);
  left->setSizes({740, 260});
  auto* whole = new QSplitter(Qt::Horizontal);
  whole->addWidget(left);
  whole->addWidget(reverse_);
  whole->setStretchFactor(0, 5);
  whole->setStretchFactor(1, 2);
  whole->setChildrenCollapsible(false);
  whole->setSizes({640, 360});
  reverse_->hide();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(makeBar());
  layout->addWidget(whole, 1);
  setFocusProxy(canvas_);

  makeToolActions();
  makeEditActions();
  makeViewActions();
  // Single keys, and keys that lists and text fields use themselves, work while the focus is in the
  // workspace; all others anywhere in the window.
  for (const auto& actions : {toolActions_, editActions(), viewActions_})
    for (QAction* action : actions) {
      action->setShortcutContext(isOfTheWindow(action->shortcut()) ? Qt::WindowShortcut
                                                                   : Qt::WidgetWithChildrenShortcut);
      addAction(action);
    }

  connect(canvas_, &GraphCanvas::cursorMoved, this, &GraphWorkspace::cursorMoved);
  connect(canvas_, &GraphCanvas::selectionChanged, this, &GraphWorkspace::followDocument);
  connect(tools_.get(), &ToolBox::said, this, &GraphWorkspace::statusMessage);
  connect(tools_.get(), &ToolBox::valuesRequested, this, &GraphWorkspace::valuesRequested);
  connect(tools_.get(), &ToolBox::contextMenuRequested, this, &GraphWorkspace::showContextMenu);
  connect(damping_, &DampingView::said, this, &GraphWorkspace::statusMessage);
  connect(operations_.get(), &OperationMenu::said, this, &GraphWorkspace::statusMessage);
  connect(&document_, &ButtonDocument::changed, this, &GraphWorkspace::followDocument);
  connect(&document_, &ButtonDocument::activeStateChanged, this, &GraphWorkspace::followDocument);
  connect(&document_, &ButtonDocument::originChanged, this, [this] {
    followDocument();
    followSettings();
  });
  connect(&settings_, &ViewSettings::changed, this, &GraphWorkspace::followSettings);
  followDocument();
  followSettings();
}

// Cancels an unfinished edit, because the document outlives the workspace.
GraphWorkspace::~GraphWorkspace() {
  document_.disconnect(this);
  operations_->closeDialog();
  tools_->cancelDrag();
  damping_->cancelDrag();
}

// State and underlay; hidden without several states and a page.
QWidget* GraphWorkspace::makeBar() {
  bar_ = new QWidget;
  auto* row = new QHBoxLayout(bar_);
  row->setContentsMargins(10, 4, 14, 4);
  statesLabel_ = new QLabel(tr("&State"));
  states_ = described(new QComboBox, "stateSwitcher",
                      tr("State that you edit; the other state is drawn pale behind it."),
                      tr("State of the button"));
  statesLabel_->setBuddy(states_);
  speedsLabel_ = new QLabel(tr("Sp&eed"));
  speeds_ = described(new QComboBox, "speedSwitcher",
                      tr("Speed of the graph that you edit. This graph is also used where the speed of a "
                         "press is not known. Graphs of other speeds are drawn thin."),
                      tr("Speed of the graph"));
  speedsLabel_->setBuddy(speeds_);
  underlayLabel_ = new QLabel(tr("&Page"));
  underlay_ = described(new QSlider(Qt::Horizontal), "underlayOpacity",
                        tr("How strongly the datasheet page shows under the curves, in %"),
                        tr("Opacity of the datasheet page"));
  underlay_->setRange(0, 100);
  underlay_->setMaximumWidth(160);
  underlayLabel_->setBuddy(underlay_);
  row->addWidget(statesLabel_);
  row->addWidget(states_);
  row->addWidget(speedsLabel_);
  row->addWidget(speeds_);
  row->addStretch(1);
  row->addWidget(underlayLabel_);
  row->addWidget(underlay_);
  connect(states_, &QComboBox::activated, this, [this](int index) {
    if (index >= 0 && static_cast<std::size_t>(index) < document_.button().states().size())
      document_.setActiveState(static_cast<std::size_t>(index));
  });
  connect(speeds_, &QComboBox::activated, this, [this](int index) {
    const std::vector<double> speeds = speedsOf(document_.button());
    if (index < 0 || static_cast<std::size_t>(index) >= speeds.size() || document_.history().dragging())
      return;
    document_.history().replace(broughtForward(document_.button(), static_cast<std::size_t>(index)),
                                tr("Graph of %1").arg(speedText(speeds[static_cast<std::size_t>(index)])));
  });
  connect(underlay_, &QSlider::valueChanged, this,
          [this](int percent) { settings_.setUnderlayOpacity(percent / 100.0); });
  return bar_;
}

void GraphWorkspace::makeToolActions() {
  struct Entry {
    ToolKind kind;
    const char* name;
    QString text, tip;
    QKeySequence key;
  };
  const Entry entries[] = {
      {ToolKind::select, "toolSelect", tr("&Select and move"),
       tr("Drag tactile points, curve points, slope handles and sections"), QKeySequence(Qt::Key_V)},
      {ToolKind::addKnot, "toolAddKnot", tr("Add &curve point"), tr("Click a curve to add a curve point"),
       QKeySequence(Qt::Key_K)},
      {ToolKind::addJump, "toolAddJump", tr("Add &jump"),
       tr("Hold the mouse button where the jump begins, then drag the valley into place"),
       QKeySequence(Qt::Key_J)},
      {ToolKind::pan, "toolPan", tr("&Pan"),
       tr("Drag the view; the middle mouse button does the same in every tool"), QKeySequence(Qt::Key_H)},
      {ToolKind::zoom, "toolZoom", tr("&Zoom to a rectangle"),
       tr("Drag a rectangle to zoom in; a click zooms in"), QKeySequence(Qt::Key_Z)},
      {ToolKind::measure, "toolMeasure", tr("&Measure"),
       tr("Drag from one place to another to measure travel, force and slope between them"),
       QKeySequence(Qt::Key_M)},
  };
  auto* group = new QActionGroup(this);
  for (const Entry& entry : entries) {
    auto* action = new QAction(entry.text, group);
    action->setObjectName(QString::fromLatin1(entry.name));
    action->setToolTip(
        QStringLiteral("%1 (%2)").arg(entry.tip, entry.key.toString(QKeySequence::NativeText)));
    action->setShortcut(entry.key);
    action->setCheckable(true);
    action->setChecked(entry.kind == tools_->tool());
    action->setData(static_cast<int>(entry.kind));
    connect(action, &QAction::triggered, this, [this, kind = entry.kind] { tools_->setTool(kind); });
    toolActions_.push_back(action);
  }
  connect(tools_.get(), &ToolBox::toolChanged, this, [this](ToolKind kind) {
    for (QAction* action : toolActions_)
      if (action->data().toInt() == static_cast<int>(kind)) action->setChecked(true);
  });
}

void GraphWorkspace::makeEditActions() {
  Keyboard& hands = tools_->keyboard();
  cutAction_ = addEditAction(clipboard, "editCut", tr("Cu&t"),
                             tr("Copies the selected points as text and removes them"), QKeySequence::Cut,
                             [this, &hands] {
                               copySelected();
                               hands.removeSelected();
                             });
  addEditAction(clipboard, "editCopy", tr("&Copy"),
                tr("Copies the selected part of the curve as text, or the whole button"), QKeySequence::Copy,
                [this] { copySelected(); });
  deleteAction_ = addEditAction(selection, "editDelete", tr("&Delete"),
                                tr("Removes the selected curve point, jump, operating or reset point"),
                                QKeySequence::Delete, [&hands] { hands.removeSelected(); });
  addEditAction(selection, "editSelectAll", tr("Select &all"),
                tr("Selects all curve points, operating and reset point"), QKeySequence::SelectAll,
                [&hands] { hands.selectAll(); });
  cornerAction_ = addEditAction(arrangement, "editCorner", tr("&Corner or smooth"),
                                tr("Turns the selected curve point into a corner, or makes it smooth"),
                                Qt::Key_C, [&hands] { hands.toggleSelectedCorner(); });
  severalActions_ = {
      addEditAction(arrangement, "editAlignForce", tr("Align to the same &force"),
                    tr("Moves the selected points to the force of the last one"), QKeySequence("Alt+Shift+F"),
                    [&hands] { hands.align(GraphDirection::force); }),
      addEditAction(arrangement, "editAlignDisplacement", tr("Align to the same &displacement"),
                    tr("Moves the selected points to the displacement of the last one"),
                    QKeySequence("Alt+Shift+D"), [&hands] { hands.align(GraphDirection::displacement); }),
      addEditAction(arrangement, "editDistributeDisplacement", tr("Distribute over d&isplacement"),
                    tr("Spaces the selected points of a stroke evenly over the travel"),
                    QKeySequence("Alt+Shift+X"),
                    [&hands] { hands.distribute(GraphDirection::displacement); }),
      addEditAction(arrangement, "editDistributeForce", tr("Distribute over f&orce"),
                    tr("Spaces the selected points of a stroke evenly over the force"),
                    QKeySequence("Alt+Shift+Y"), [&hands] { hands.distribute(GraphDirection::force); })};
  editActions_[operations] = operations_->actions();
}

QAction* GraphWorkspace::addEditAction(EditGroup group, const char* name, const QString& text,
                                       const QString& tip, const QKeySequence& key,
                                       const std::function<void()>& act) {
  auto* action = new QAction(text, this);
  action->setObjectName(QString::fromLatin1(name));
  action->setToolTip(QStringLiteral("%1 (%2)").arg(tip, key.toString(QKeySequence::NativeText)));
  action->setShortcut(key);
  connect(action, &QAction::triggered, this, act);
  editActions_[group].push_back(action);
  return action;
}

QList<QAction*> GraphWorkspace::editActions() const {
  QList<QAction*> all;
  for (const QList<QAction*>& group : editActions_) all += group;
  return all;
}

void GraphWorkspace::copySelected() {
  const GraphStretch stretch = stretchOfMarks(canvas_->selection(), canvas_->state(), canvas_->values());
  if (!stretch.empty()) {
    QGuiApplication::clipboard()->setText(textOf(stretch));
    emit statusMessage(tr("Copied the selected part of the curve"));
    return;
  }
  emit buttonCopyRequested();
}

void GraphWorkspace::paste(const GraphStretch& stretch) {
  tools_->cancelDrag();
  if (document_.history().dragging()) return;  // a dialog holds the button
  const std::size_t state = document_.activeState();
  const auto next = pasteStretch(document_.history().committed(), state, stretch);
  if (!next) return emit statusMessage(sentenceOf(next.failure(), settings_.units()));
  document_.history().apply(*next, tr("Paste part of a curve"));
  std::vector<MarkId> pasted;
  for (const Stroke stroke : {Stroke::press, Stroke::release})
    for (const Knot& knot : stroke == Stroke::press ? stretch.press : stretch.release)
      if (const auto index = knotAt(document_.graph().curve(stroke), knot.displacement_mm))
        pasted.push_back({MarkKind::knot, stroke, *index});
  canvas_->setSelection(std::move(pasted));
}

QAction* GraphWorkspace::addViewAction(const QString& name, const QString& text, const QString& tip,
                                       const QKeySequence& key) {
  auto* action = described(new QAction(text, this), name, tip);
  action->setShortcut(key);
  viewActions_.push_back(action);
  return action;
}

QAction* GraphWorkspace::addViewSwitch(const QString& name, const QString& text, const QString& tip,
                                       bool on) {
  QAction* action = addViewAction(name, text, tip);
  action->setCheckable(true);
  action->setChecked(on);
  return action;
}

void GraphWorkspace::addSeparator(QList<QAction*>& actions) {
  auto* separator = new QAction(this);
  separator->setSeparator(true);
  actions.push_back(separator);
}

void GraphWorkspace::makeViewActions() {
  const auto zoom = [this](double factor) {
    canvas_->zoomAt(canvas_->mapping().clip_px.center(), factor, factor);
  };
  connect(addViewAction("viewFit", tr("&Fit"), tr("Shows the whole graph"), Qt::Key_F), &QAction::triggered,
          this, [this] {
            canvas_->fit();
            reverse_->fit();
            damping_->fit();
          });
  connect(addViewAction(
              "viewZoomIn", tr("Zoom &in"),
              tr("The mouse wheel zooms at the pointer; with Alt only displacement, with Ctrl only force"),
              QKeySequence::ZoomIn),
          &QAction::triggered, this, [zoom] { zoom(1.25); });
  connect(addViewAction("viewZoomOut", tr("Zoom &out"), tr("Shows a larger part of the graph"),
                        QKeySequence::ZoomOut),
          &QAction::triggered, this, [zoom] { zoom(0.8); });
  addSeparator(viewActions_);
  connect(addViewSwitch("viewDisplacementForce", tr("Displacement over &force"),
                        tr("Displacement plotted over force; jumps appear as vertical lines"), false),
          &QAction::toggled, this, [this](bool on) {
            reverse_->setVisible(on);
            if (on) reverse_->fit();
          });
  dampingShown_ = addViewSwitch("viewDamping", tr("&Damping"),
                                tr("Damping over displacement, if the button has damping"), true);
  connect(dampingShown_, &QAction::toggled, this, &GraphWorkspace::followDocument);
  residualsShown_ =
      addViewSwitch("viewResiduals", tr("&Traced points and deviations"),
                    tr("The traced points and how far the curve deviates from them, enlarged ten times"),
                    settings_.residualsShown());
  connect(residualsShown_, &QAction::toggled, &settings_, &ViewSettings::setResidualsShown);
  connect(addViewSwitch("viewMagnifier", tr("&Magnifier"),
                        tr("Magnifies the graph five times while you drag"), true),
          &QAction::toggled, canvas_, &GraphCanvas::setMagnifierShown);
  connect(addViewSwitch("viewHandles", tr("C&urve points"),
                        tr("Show curve points, valleys and peaks on the curves"), true),
          &QAction::toggled, canvas_, &GraphCanvas::setHandlesShown);
  addSeparator(viewActions_);
  addSnapActions();
}

void GraphWorkspace::addSnapActions() {
  const auto connectSnap = [this](QAction* action, bool SnapSettings::*which) {
    connect(action, &QAction::toggled, this, [this, which](bool on) {
      SnapSettings snap = settings_.snap();
      snap.*which = on;
      settings_.setSnap(snap);
    });
  };
  snapGrid_ = addViewSwitch("snapGrid", tr("Snap to &grid"), tr("Snap dragged points to the grid"), false);
  snapTraced_ = addViewSwitch("snapTraced", tr("Snap to tr&aced points"),
                              tr("Dragged points snap to the points traced on the page"), false);
  snapOther_ = addViewSwitch("snapOther", tr("Snap to the other &stroke"),
                             tr("Snap press points to the release curve, and vice versa"), false);
  connect(addViewAction("snapGridSteps", tr("Grid ste&ps…"), tr("Spacing of the snap grid"),
                        QKeySequence("Alt+G")),
          &QAction::triggered, this, [this] {
            auto* dialog = new GridDialog(settings_, this);
            dialog->setAttribute(Qt::WA_DeleteOnClose);
            dialog->show();
          });
  connectSnap(snapGrid_, &SnapSettings::toGrid);
  connectSnap(snapTraced_, &SnapSettings::toTracedPoints);
  connectSnap(snapOther_, &SnapSettings::toOtherStroke);
}

void GraphWorkspace::followDocument() {
  const auto& states = document_.button().states();
  const QSignalBlocker quiet(states_);
  QStringList names;
  for (std::size_t i = 0; i < states.size(); ++i) names << nameOfState(document_.button(), i);
  QStringList shown;
  for (int i = 0; i < states_->count(); ++i) shown << states_->itemText(i);
  if (shown != names) {
    states_->clear();
    states_->addItems(names);
  }
  states_->setCurrentIndex(static_cast<int>(document_.activeState()));
  statesLabel_->setVisible(states.size() > 1);
  states_->setVisible(states.size() > 1);
  followSpeeds();
  bar_->setVisible(barHasChoices() || canvas_->hasUnderlay());
  damping_->setVisible(dampingShown_->isChecked() && !states[document_.activeState()].damping.empty());
  dampingShown_->setEnabled(!states[document_.activeState()].damping.empty());
  const std::size_t selected = canvas_->selection().size();
  cutAction_->setEnabled(selected > 0);
  for (QAction* several : severalActions_) several->setEnabled(selected > 1);
  deleteAction_->setEnabled(selected > 0);
  cornerAction_->setEnabled(tools_->keyboard().selectedKnot().has_value());
  operations_->updateActions();
}

bool GraphWorkspace::barHasChoices() const {
  return document_.button().states().size() > 1 || !speedsOf(document_.button()).empty();
}

void GraphWorkspace::followSpeeds() {
  const std::vector<double> speeds = speedsOf(document_.button());
  const QSignalBlocker quiet(speeds_);
  speeds_->clear();
  for (const double speed : speeds) speeds_->addItem(speedText(speed));
  if (!speeds.empty())
    speeds_->setCurrentIndex(static_cast<int>(
        std::ranges::find(speeds, *document_.button().states().front().speed_mm_per_s) - speeds.begin()));
  speedsLabel_->setVisible(!speeds.empty());
  speeds_->setVisible(!speeds.empty());
}

void GraphWorkspace::followSettings() {
  const bool page = canvas_->hasUnderlay();
  underlayLabel_->setVisible(page);
  underlay_->setVisible(page);
  bar_->setVisible(page || barHasChoices());
  // Traced points that are only read on request can be switched on too, which reads them.
  const bool traced = !canvas_->tracedPoints(Stroke::press).empty() || document_.originOnDemand();
  residualsShown_->setEnabled(traced);
  snapTraced_->setEnabled(traced);
  const QSignalBlocker quiet(underlay_);
  underlay_->setValue(qRound(100 * settings_.underlayOpacity()));
  residualsShown_->setChecked(settings_.residualsShown());
  snapGrid_->setChecked(settings_.snap().toGrid);
  snapTraced_->setChecked(settings_.snap().toTracedPoints);
  snapOther_->setChecked(settings_.snap().toOtherStroke);
}

void GraphWorkspace::showContextMenu(QPoint global_px) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addActions({deleteAction_, cornerAction_});
  menu->addSeparator();
  menu->addActions(operations_->actions());
  menu->addSeparator();
  menu->addActions(viewActions_.mid(0, 1));
  menu->popup(global_px);
}

void GraphWorkspace::showFinger(std::optional<FingerPosition> finger) {
  canvas_->showFinger(finger);
  reverse_->showFinger(finger);
}

QImage GraphWorkspace::renderImage(QSize size_px, double devicePixelRatio) const {
  return canvas_->renderImage(size_px, devicePixelRatio);
}

}  // namespace detent::editor
