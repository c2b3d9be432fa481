// SPDX-License-Identifier: GPL-3.0-or-later
// Ten thousand seeded random actions with mouse, keys, menus, dialogs and undo. After each the button is
// valid; at the end undoing all gives the first button exactly, redoing all the last.
//
// A tenth as many corrections of an import are made, undone and given out at random, mostly while their
// answers are still awaited: at the end undoing all gives the first result exactly.
//
// DETENT_MONKEY_ACTIONS and DETENT_MONKEY_SEED change how many and which (defaults: 10000, 5).
#include <algorithm>
#include <QApplication>
#include <QClipboard>
#include <QDialog>
#include <QFile>
#include <QKeyEvent>
#include <QTemporaryDir>
#include <QWheelEvent>
#include <random>

#include "editor/importing/import_state.h"
#include "editor/panels/operation_dialog.h"
#include "editor/panels/values_model.h"
#include "editor/panels/values_panel.h"
#include "editor/tools/damping_view.h"
#include "editor/tools/knot_text.h"
#include "model/edits.h"
#include "tests/editor/window_tests.h"
#include "tests/editor/workspace_rig.h"
#include "tests/samples/two_switches.h"

using namespace detent;
using namespace detent::editor;
using namespace detent::editor::tests;

namespace {

// Rebuilds everything from its parts, so that each rule is checked.
void verifyValid(const Button& button) {
  std::vector<ButtonState> states;
  for (const ButtonState& state : button.states()) {
    const auto press = StrokeCurve::fromKnots(state.graph.press().knots());
    if (!press) qFatal("%s", press.failure().sentence().c_str());
    std::optional<StrokeCurve> release;
    if (state.graph.release()) {
      const auto rebuilt = StrokeCurve::fromKnots(state.graph.release()->knots());
      if (!rebuilt) qFatal("%s", rebuilt.failure().sentence().c_str());
      release = *rebuilt;
    }
    const auto graph = ForceGraph::fromCurves(*press, release);
    if (!graph) qFatal("%s", graph.failure().sentence().c_str());
    states.push_back(state);
    states.back().graph = *graph;
  }
  const auto rebuilt = Button::fromStates(button.name(), states, button.provenance());
  if (!rebuilt) qFatal("%s", rebuilt.failure().sentence().c_str());
  if (!(*rebuilt == button)) qFatal("a button is what its parts say");
}

class Monkey {
 public:
  Monkey(WorkspaceRig& rig, ValuesPanel& values, unsigned seed) : rig_(rig), values_(values), random_(seed) {}

  void act() {
    if (auto* dialog = rig_.workspace.findChild<OperationDialog*>()) return useDialog(*dialog);
    struct Choice {
      int weight;
      void (Monkey::*action)();
    };
    static constexpr Choice choices[] = {{16, &Monkey::moveMouse},
                                         {18, &Monkey::pressOrRelease},
                                         {26, &Monkey::dragSomething},
                                         {12, &Monkey::pressKey},
                                         {6, &Monkey::undoOrRedo},
                                         {3, &Monkey::triggerTool},
                                         {4, &Monkey::triggerEdit},
                                         {2, &Monkey::wheel},
                                         {4, &Monkey::typeValue},
                                         {2, &Monkey::switchState},
                                         {2, &Monkey::doubleClick},
                                         {2, &Monkey::useDamping},
                                         {4, &Monkey::selectSeveral},
                                         {4, &Monkey::paste},
                                         {1, &Monkey::changeSnap},
                                         {1, &Monkey::fit},
                                         {1, &Monkey::tidy}};
    int total = 0;
    for (const Choice& choice : choices) total += choice.weight;
    int drawn = upTo(total);
    for (const Choice& choice : choices) {
      drawn -= choice.weight;
      if (drawn < 0) return (this->*choice.action)();
    }
  }

  void letGo() {
    if (rig_.down & Qt::LeftButton) rig_.release(at_);
    if (auto* damping = rig_.workspace.findChild<DampingView*>())
      rig_.send(*damping, QEvent::MouseButtonRelease, {}, Qt::LeftButton);
    if (auto* dialog = rig_.workspace.findChild<OperationDialog*>()) dialog->reject();
    collectDialogs();
  }

 private:
  int upTo(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  double share() { return double(random_()) / double(random_.max()); }
  Qt::KeyboardModifiers anyModifiers() {
    static constexpr Qt::KeyboardModifier all[] = {Qt::NoModifier, Qt::NoModifier, Qt::ShiftModifier,
                                                   Qt::AltModifier, Qt::ControlModifier};
    return all[upTo(5)];
  }
  static void collectDialogs() { QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); }

  QPointF anyPlace() {
    const auto marks = pointMarks(rig_.canvas().state(), rig_.canvas().values());
    if (!marks.empty() && upTo(3) > 0) {
      const Mark& mark = marks[static_cast<std::size_t>(upTo(static_cast<int>(marks.size())))];
      const QPointF at = rig_.pixel(mark.at.displacement_mm, mark.at.force_N);
      if (rig_.canvas().rect().contains(at.toPoint())) return at + QPointF(upTo(7) - 3, upTo(7) - 3);
    }
    return {share() * rig_.canvas().width(), share() * rig_.canvas().height()};
  }

  void moveMouse() {
    at_ = upTo(4) == 0 ? anyPlace() : at_ + QPointF(upTo(61) - 30, upTo(61) - 30);
    rig_.mouse(QEvent::MouseMove, at_, Qt::NoButton, anyModifiers());
  }
  void pressOrRelease() {
    if (rig_.down & Qt::LeftButton) return rig_.release(at_);
    at_ = anyPlace();
    rig_.press(at_, anyModifiers());
  }
  void dragSomething() {
    if (rig_.down) return;
    at_ = anyPlace();
    const QPointF to = at_ + QPointF(upTo(161) - 80, upTo(161) - 80);
    rig_.drag(at_, to, anyModifiers());
    at_ = to;
  }
  void doubleClick() {
    if (rig_.down) return;
    at_ = anyPlace();
    rig_.mouse(QEvent::MouseButtonDblClick, at_, Qt::LeftButton);
    rig_.release(at_);
  }
  void pressKey() {
    static constexpr Qt::Key keys[] = {
        Qt::Key_Left,   Qt::Key_Right, Qt::Key_Up,     Qt::Key_Down, Qt::Key_Tab, Qt::Key_Backtab, Qt::Key_C,
        Qt::Key_Delete, Qt::Key_S,     Qt::Key_Escape, Qt::Key_Tab,  Qt::Key_Up,  Qt::Key_Left};
    const Qt::Key key = keys[upTo(13)];
    const Qt::KeyboardModifiers modifiers = key == Qt::Key_Tab ? Qt::NoModifier : anyModifiers();
    QKeyEvent press(QEvent::KeyPress, key, modifiers);
    QCoreApplication::sendEvent(&rig_.canvas(), &press);
  }
  void undoOrRedo() {
    QUndoStack& stack = rig_.document.history().stack();
    if (upTo(3) > 0)
      stack.undo();
    else
      stack.redo();
  }
  void triggerTool() {
    const auto actions = rig_.workspace.toolActions();
    actions[upTo(3) == 0 ? 0 : upTo(static_cast<int>(actions.size()))]->trigger();
  }
  void triggerEdit() {
    const auto actions = rig_.workspace.editActions();
    actions[upTo(static_cast<int>(actions.size()))]->trigger();
  }
  // As a rubber band or Shift and clicks leave them: any marks, in any order.
  void selectSeveral() {
    if (rig_.document.history().dragging()) return;
    std::vector<MarkId> several;
    for (const Mark& mark : pointMarks(rig_.canvas().state(), rig_.canvas().values()))
      if (upTo(3) == 0) several.push_back(mark.id);
    std::shuffle(several.begin(), several.end(), random_);
    rig_.canvas().setSelection(several);
  }
  // Pastes an earlier copy, often; sometimes the clipboard of another program.
  void paste() {
    static const QString texts[] = {"", "words", textOf({{{1, 0.4, 0, 0}, {1.2, 0.5, 0, 0}}, {}}),
                                    textOf({{{-7, 0.4, 0, 0}}, {{90, 0.5, 0, 0}}}),
                                    textOf({{}, {{2, 1e300, 0, 0}, {2, -1e300, 0, 0}}})};
    const QString text = upTo(3) > 0 ? QApplication::clipboard()->text() : texts[upTo(5)];
    if (const auto stretch = stretchFrom(text)) rig_.workspace.paste(*stretch);
  }
  void useDialog(OperationDialog& dialog) {
    const std::size_t fields = dialog.values().size();
    if (fields > 0 && upTo(3) > 0) {
      const auto field = static_cast<std::size_t>(upTo(static_cast<int>(fields)));
      dialog.setValue(field, upTo(2) == 0 ? upTo(3) : 4 * share());
      return;
    }
    if (upTo(2) == 0)
      dialog.accept();
    else
      dialog.reject();
    collectDialogs();
  }
  void wheel() {
    const QPointF at = anyPlace();
    QWheelEvent event(at, rig_.canvas().mapToGlobal(at), {}, {0, upTo(2) == 0 ? 120 : -120}, Qt::NoButton,
                      anyModifiers(), Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&rig_.canvas(), &event);
  }
  void typeValue() {
    ValuesModel& model = values_.model();
    const QModelIndex cell = model.index(upTo(model.rowCount()), upTo(ValuesModel::columns));
    static const QString texts[] = {"1.3",   "0",   "-2",    "55 cN", "nonsense",
                                    "1e300", "2,5", "60 gf", "nan",   ""};
    model.setData(cell, upTo(2) == 0 ? texts[upTo(10)] : QString::number(80 * share()), Qt::EditRole);
  }
  void switchState() {
    rig_.document.setActiveState(
        static_cast<std::size_t>(upTo(static_cast<int>(rig_.button().states().size()))));
  }
  void useDamping() {
    auto* view = rig_.workspace.findChild<DampingView*>();
    if (!view || !view->isVisible() || rig_.down) return;
    const QPointF from(share() * view->width(), share() * view->height());
    if (upTo(4) == 0) {
      rig_.send(*view, QEvent::MouseButtonDblClick, from, Qt::LeftButton);
      rig_.send(*view, QEvent::MouseButtonRelease, from, Qt::LeftButton);
      return;
    }
    QKeyEvent tab(QEvent::KeyPress, Qt::Key_Tab, Qt::NoModifier);
    QCoreApplication::sendEvent(view, &tab);
    QKeyEvent key(QEvent::KeyPress, upTo(2) == 0 ? Qt::Key_Up : Qt::Key_Delete, Qt::NoModifier);
    QCoreApplication::sendEvent(view, &key);
    rig_.send(*view, QEvent::MouseButtonPress, from, Qt::LeftButton);
    rig_.send(*view, QEvent::MouseMove, from + QPointF(upTo(41) - 20, upTo(41) - 20), Qt::LeftButton);
    rig_.send(*view, QEvent::MouseButtonRelease, from, Qt::LeftButton);
  }
  void changeSnap() {
    SnapSettings snap;
    snap.toGrid = upTo(2) == 0;
    snap.toOtherStroke = upTo(2) == 0;
    rig_.settings.setSnap(snap);
  }
  void fit() { rig_.workspace.canvas().fit(); }
  // Keeps the curves from growing beyond the work of a hand.
  void tidy() {
    if (rig_.document.history().dragging() || rig_.press().knots().size() < 40) return;
    if (const auto linear = editGraph(
            rig_.document.history().committed(), rig_.document.activeState(), [](const ForceGraph& g) {
              return editStroke(g, Stroke::press, [](const StrokeCurve& c) { return makeLinear(c); });
            }))
      rig_.document.history().apply(*linear, "Make linear");
  }

  WorkspaceRig& rig_;
  ValuesPanel& values_;
  std::mt19937 random_;
  QPointF at_{100, 100};
};

/// Corrects, undoes, chooses, stops and imports without waiting for answers.
class ImportMonkey {
 public:
  static constexpr const char* switches[] = {"Brown", "Red", "3"};  // the last is nobody's

  ImportMonkey(ImportState& state, unsigned seed) : state_(state), random_(seed) {}

  void act() {
    switch (upTo(12)) {
      case 0:
      case 1:
      case 2:
        return state_.undo();
      case 3:
        return state_.redo();
      case 4:
        return upTo(4) == 0 ? state_.cancel() : state_.selectGraph(state_.current()->id);
      case 5:
        return state_.setConfirmed(upTo(2) == 0);
      case 6:
        return tick();
      case 7:
        if (upTo(8) == 0) state_.acceptAll();
        return;
      default:
        return state_.correct("Monkey", [this](Corrections& c) { change(c); });
    }
  }

 private:
  int upTo(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  double share() { return double(random_()) / double(random_.max()); }
  importer::Point anyPoint() { return {800 * share(), 470 * share()}; }
  importer::Rgb anyColor() {
    const auto part = [this] { return static_cast<std::uint8_t>(upTo(256)); };
    return {part(), part(), part()};
  }

  void tick() { state_.setCurveTicked(switches[upTo(3)], upTo(2) == 0); }
  void change(Corrections& c) {
    const char* const curves[] = {"Brown", "Red", "1", "2", "7", "nobody's", ""};
    switch (upTo(9)) {
      case 0:
        c.frame = FrameCorners{anyPoint(), anyPoint(), anyPoint(), anyPoint()};
        break;
      case 1:
        c.x.min = 4 * share() - 1, c.x.max = 10 * share() - 2;
        break;
      case 2:
        c.y.ticks.push_back({anyPoint(), 2 * share()});
        break;
      case 3:
        c.xUnit = LengthUnit::inch, c.yUnit = ForceUnit::gramForce;
        break;
      case 4:
        (upTo(2) == 0 ? c.pressColor : c.releaseColor) = anyColor();
        break;
      case 5:
        c.masks.push_back({100, 40, 100 + 480 * share(), 40 + 360 * share()});
        break;
      case 6:
        c.swapStrokes = !c.swapStrokes;
        break;
      case 7:
        (upTo(2) == 0 ? c.drawn.press : c.drawn.release) = {anyPoint(), anyPoint(), anyPoint()};
        break;
      default:
        c.curve = curves[upTo(7)];
    }
  }

  ImportState& state_;
  std::mt19937 random_;
};

int numberFrom(const char* variable, int otherwise) {
  bool ok = false;
  const int number = qEnvironmentVariableIntValue(variable, &ok);
  return ok ? number : otherwise;
}

}  // namespace

class MonkeyTest : public QObject {
  Q_OBJECT

 private slots:
  void randomActionsKeepTheGraphValid();
  void randomCorrectionsOfAnImportAreUndone();
};

void MonkeyTest::randomActionsKeepTheGraphValid() {
  const int actions = numberFrom("DETENT_MONKEY_ACTIONS", 10000);
  const Button first = require(setDamping(require(tactileButton()), 0, {{0, 0.002}, {2, 0.004}, {4, 0.003}}));
  WorkspaceRig rig(first, {520, 420});
  ValuesPanel values(rig.document, rig.settings);
  values.show();
  Monkey monkey(rig, values, static_cast<unsigned>(numberFrom("DETENT_MONKEY_SEED", 5)));
  int changes = 0;
  Button last = rig.button();
  for (int i = 0; i < actions; ++i) {
    monkey.act();
    if (!(rig.button() == last)) {
      verifyValid(rig.button());
      last = rig.button();
      ++changes;
    }
    if (i % 20 == 0) QCoreApplication::processEvents();  // paints
  }
  monkey.letGo();
  QVERIFY(!rig.document.history().dragging());
  const Button end = rig.button();
  QUndoStack& stack = rig.document.history().stack();
  const int endIndex = stack.index();
  qInfo("%d actions, %d changes seen, %d steps", actions, changes, stack.count());
  QVERIFY2(changes > actions / 20, "the monkey did something");
  stack.setIndex(0);
  QVERIFY(rig.button() == first);
  stack.setIndex(stack.count());
  const Button newest = rig.button();
  stack.setIndex(0);
  QVERIFY(rig.button() == first);
  stack.setIndex(stack.count());
  QVERIFY(rig.button() == newest);
  stack.setIndex(endIndex);
  QVERIFY(rig.button() == end);
}

void MonkeyTest::randomCorrectionsOfAnImportAreUndone() {
  const int actions = numberFrom("DETENT_MONKEY_ACTIONS", 10000) / 10;
  const QTemporaryDir folder;
  QFile sheet(folder.filePath("two.svg"));
  QVERIFY(sheet.open(QIODevice::WriteOnly) && sheet.write(detent::tests::twoSwitchesSvg().c_str()) > 0);
  sheet.close();
  ImportState state;
  int imported = 0;
  QObject::connect(&state, &ImportState::accepted, &state, [&](const auto& report) {
    verifyValid(report->button);
    ++imported;
  });
  constexpr int patience_ms = 120000;  // sanitizers on a busy machine
  const auto settled = [&] {
    return QTest::qWaitFor([&] { return state.current() && !state.working() && state.current()->last; },
                           patience_ms);
  };
  state.openFile(sheet.fileName());
  QVERIFY(settled());
  const auto afterUndoingAll = [&]() -> std::optional<Button> {
    state.cancel();
    while (state.current()->history.canUndo()) state.undo();
    state.correct("Choose switch", [](Corrections& c) { c.curve = "Brown"; });
    if (!settled() || !state.current()->last->report) return {};
    return state.current()->last->report->button;
  };
  const auto first = afterUndoingAll();
  QVERIFY(first.has_value());

  ImportMonkey monkey(state, static_cast<unsigned>(numberFrom("DETENT_MONKEY_SEED", 5)));
  for (int i = 1; i <= actions; ++i) {
    monkey.act();
    if (i % 7 == 0) QTest::qWait(1);
    if (i % 100 != 0) continue;
    QVERIFY(afterUndoingAll() == first);
    state.acceptAll();  // imports the ticked graphs; the monkey goes on meanwhile
  }
  QVERIFY(afterUndoingAll() == first);
  // Whatever came of the imports on the way (on a slow machine nothing): one that nobody disturbs gives its
  // button.
  const int before = imported;
  for (const char* name : ImportMonkey::switches) state.setCurveTicked(name, false);
  state.setConfirmed(true);
  state.acceptAll();
  QVERIFY(QTest::qWaitFor([&] { return imported > before; }, patience_ms));
  qInfo("%d corrections, %d buttons imported", actions, imported);
}

DETENT_WINDOW_TEST(MonkeyTest)
#include "monkey_test.moc"
