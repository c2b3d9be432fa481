// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/operation_menu.h"

#include <utility>

namespace detent::editor {
namespace {

constexpr int gapBeside_px = 8;

bool always(const OperationTarget&) { return true; }
bool hasTactilePoint(const OperationTarget& t) {
  return !t.values.press.tactile.empty() || (t.values.release && !t.values.release->tactile.empty());
}
bool pressHasTactilePoint(const OperationTarget& t) { return !t.values.press.tactile.empty(); }
bool hasRelease(const OperationTarget& t) { return t.graph().release().has_value(); }
bool hasOrigin(const OperationTarget& t) {
  return t.originOnDemand || (t.origin && !t.origin->strokes.press.points.empty());
}
bool hasOneState(const OperationTarget& t) { return t.button.states().size() == 1; }
bool hasTwoStates(const OperationTarget& t) { return t.button.states().size() > 1; }

}  // namespace

OperationMenu::OperationMenu(ButtonDocument& document, ViewSettings& settings, GraphCanvas& canvas,
                             ToolBox& tools, QWidget& window)
    : document_(document), settings_(settings), canvas_(canvas), tools_(tools), window_(window) {
  const auto key = [](int code) {
    return QKeySequence(QKeyCombination(Qt::CTRL | Qt::SHIFT, Qt::Key(code)));
  };
  add("operationAddJump", tr("Add &jump…"), tr("Add a tactile point with its valley by entering numbers"),
      key(Qt::Key_J), addJumpOperation, always);
  add("operationRemoveJump", tr("&Remove jump…"),
      tr("Replace a tactile point and its valley by a straight line"), {}, removeJumpOperation,
      hasTactilePoint);
  add("operationSnapRatio", tr("Snap r&atio…"), tr("Set how deep the valley lies below the peak force"),
      key(Qt::Key_R), snapRatioOperation, pressHasTactilePoint);
  add("operationMakeLinear", tr("Make &linear…"),
      tr("Replace the curve by a straight line up to the bottom-out"), key(Qt::Key_L), makeLinearOperation,
      always);
  addSeparator();
  add("operationMirror", tr("&Mirror press to release…"),
      tr("Create a release curve from the press, lower by a force"), key(Qt::Key_M), mirrorOperation, always);
  add("operationRemoveRelease", tr("Remove release &curve…"),
      tr("Remove the release curve; the release follows the press curve"), {}, removeReleaseOperation,
      hasRelease);
  add("operationScaleForce", tr("Scale &force…"), tr("Multiply all forces by one factor"), key(Qt::Key_F),
      scaleForceOperation, always);
  add("operationScaleTravel", tr("Scale &travel…"), tr("Multiply all displacements by one factor"),
      key(Qt::Key_T), scaleTravelOperation, always);
  add("operationRefit", tr("Ref&it curve…"),
      tr("Fit the curves to the traced points again, with another number of pieces"), key(Qt::Key_I),
      refitOperation, hasOrigin);
  addSeparator();
  add("operationContacts", tr("&Operating and reset point…"), tr("Set where the contact closes and opens"),
      key(Qt::Key_O), contactsOperation, always);
  add("operationDamping", tr("&Damping…"), tr("Switch damping for force feedback on or off"), key(Qt::Key_D),
      dampingOperation, always);
  addSeparator();
  add("operationTwoLevel", tr("T&wo-level button…"),
      tr("Replace the curves by ones with two tactile points, as on a camera's shutter button"), {},
      twoLevelOperation, always);
  add("operationSelfLocking", tr("&Self-locking button…"),
      tr("Replace the button by one with two states that alternate at each actuation"), {},
      selfLockingOperation, always);
  add("operationAddState", tr("Add stat&e…"), tr("Add a second state, as a copy of this one"), {},
      addStateOperation, hasOneState);
  add("operationRemoveState", tr("Remo&ve state…"), tr("Remove this state; only the other state remains"), {},
      removeStateOperation, hasTwoStates);
  updateActions();
  connect(&document_, &ButtonDocument::originChanged, this, [this] {
    if (std::exchange(refitWaits_, false) && hasOrigin(target())) open(refitOperation);
  });
}

void OperationMenu::add(const char* name, const QString& text, const QString& tip, const QKeySequence& key,
                        Operation (*make)(const OperationTarget&), bool (*offered)(const OperationTarget&)) {
  auto* action = new QAction(text, this);
  action->setObjectName(QString::fromLatin1(name));
  action->setToolTip(
      key.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, key.toString(QKeySequence::NativeText)));
  action->setShortcut(key);
  connect(action, &QAction::triggered, this, [this, make] { open(make); });
  actions_.push_back(action);
  offers_.emplace_back(action, offered);
}

void OperationMenu::addSeparator() {
  auto* separator = new QAction(this);
  separator->setSeparator(true);
  actions_.push_back(separator);
}

OperationTarget OperationMenu::target() const {
  return {document_.button(), document_.activeState(),  canvas_.values(),
          canvas_.selected(), document_.origin().get(), document_.originOnDemand()};
}

void OperationMenu::updateActions() {
  // The menu cannot be opened during a drag, so frames are not checked.
  if (document_.history().dragging()) return;
  const OperationTarget now = target();
  for (const auto& [action, offered] : offers_) action->setEnabled(offered(now));
}

void OperationMenu::open(Operation (*make)(const OperationTarget&)) {
  tools_.cancelDrag();
  if (document_.history().dragging()) return;  // another dialog or view holds the button
  refitWaits_ = make == refitOperation && document_.originOnDemand();
  if (refitWaits_) {
    emit said(tr("Reading the traced points from the page…"));
    return document_.wantOrigin();
  }
  dialog_ = new OperationDialog(document_, settings_, make(target()), &window_);
  // Keeps the previewed graph visible: beside it, or as far to its right as the screen allows (ScreenFit).
  dialog_->move(window_.mapToGlobal(QPoint(window_.width() + gapBeside_px, 0)));
  dialog_->open();
}

}  // namespace detent::editor
