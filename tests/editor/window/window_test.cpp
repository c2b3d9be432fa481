// SPDX-License-Identifier: GPL-3.0-or-later
// The window as a whole: actions, files, tabs, recovery, appearance, units.

#include <QAbstractButton>
#include <QAccessible>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QCloseEvent>
#include <QComboBox>
#include <QDateTime>
#include <QDockWidget>
#include <QFile>
#include <QFileInfo>
#include <QHeaderView>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMimeData>
#include <QPointer>
#include <QPushButton>
#include <QRadioButton>
#include <QScopeGuard>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QStyleOptionComboBox>
#include <QStyleOptionSlider>
#include <QTableView>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolBar>
#include <QTranslator>
#include <QTreeWidget>
#include <QUrl>
#include <QVBoxLayout>
#include <QWidgetAction>
#include <random>

#include <qcustomplot.h>

#include "editor/canvas/graph_canvas.h"
#include "editor/document/graph_colors.h"
#include "editor/document/kept_page.h"
#include "editor/document/message_words.h"
#include "editor/document/names_in_sight.h"
#include "editor/feel/feel_setup.h"
#include "editor/feel/force_setup.h"
#include "editor/files/document_files.h"
#include "editor/importing/import_dialog.h"
#include "editor/importing/import_state.h"
#include "editor/importing/page_view.h"
#include "editor/importing/placed_page.h"
#include "editor/library/average_dialog.h"
#include "editor/library/compare_panel.h"
#include "editor/library/morph_dialog.h"
#include "editor/panels/checks_panel.h"
#include "editor/panels/key_figures_model.h"
#include "editor/panels/key_figures_panel.h"
#include "editor/panels/operation_dialog.h"
#include "editor/panels/values_model.h"
#include "editor/panels/values_panel.h"
#include "editor/window/appearance.h"
#include "editor/window/arguments.h"
#include "editor/window/main_window.h"
#include "editor/window/stored_view.h"
#include "editor/window/translation.h"
#include "model/edits.h"
#include "model/file/button_file.h"
#include "model/file/graph_program.h"
#include "model/file/traced_project.h"
#include "model/metrics.h"
#include "playback/force_feedback.h"
#include "playback/study.h"
#include "tests/editor/geometry/geometry_report.h"
#include "tests/editor/window/scripted_prompts.h"
#include "tests/editor/window_tests.h"

using namespace detent;
using namespace detent::editor;
using detent::editor::tests::ScriptedPrompts;

namespace {

QString sample(const char* name) { return QStringLiteral(DETENT_SOURCE_DIR "/samples/") + name; }

/// Choices that are ours to word; names of devices and files may be of any length.
void collectCutChoices(const QComboBox& box, QStringList& cut) {
  if (!box.isVisible() || box.isEditable() ||
      box.sizeAdjustPolicy() == QComboBox::AdjustToMinimumContentsLengthWithIcon)
    return;
  QStyleOptionComboBox option;
  option.initFrom(&box);
  const int room_px =
      box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box).width();
  for (int i = 0; i < box.count(); ++i)
    if (box.fontMetrics().horizontalAdvance(box.itemText(i)) > room_px)
      cut << QString("%1: \"%2\" has %3").arg(box.objectName(), box.itemText(i)).arg(room_px);
}

/// Headings of tables, and columns that lie beyond the right edge.
void collectCutHeadings(const QHeaderView& header, QStringList& cut) {
  if (!header.isVisible() || header.orientation() != Qt::Horizontal) return;
  const QString table = header.parentWidget()->objectName();
  // shortened headings have the whole text as a tool tip
  const bool shortens = dynamic_cast<const ShorteningHeader*>(&header);
  for (int i = 0; i < header.count() && !shortens; ++i)
    if (header.sectionSizeHint(i) > header.sectionSize(i) + 1 && !header.isSectionHidden(i))
      cut << QString("%1: heading \"%2\"")
                 .arg(table, header.model()->headerData(i, Qt::Horizontal).toString());
  if (header.length() > header.viewport()->width())
    cut << QString("%1: %2 px of columns in %3")
               .arg(table)
               .arg(header.length())
               .arg(header.viewport()->width());
}

/// Texts of buttons, labels, boxes and tables of this window that are wider than their room.
QStringList cutTexts(const QWidget& window) {
  QStringList cut;
  const auto collectIfCut = [&cut](const QWidget& widget, const QString& text) {
    if (widget.isVisible() && !text.isEmpty() && widget.sizeHint().width() > widget.width() + 1)
      cut << QString("%1: \"%2\" needs %3, has %4")
                 .arg(widget.objectName(), text)
                 .arg(widget.sizeHint().width())
                 .arg(widget.width());
  };
  for (const auto* button : window.findChildren<QAbstractButton*>())
    if (button->sizePolicy().horizontalPolicy() != QSizePolicy::Ignored)
      collectIfCut(*button, button->text());
  for (const auto* label : window.findChildren<QLabel*>())
    if (!label->wordWrap() && label->sizePolicy().horizontalPolicy() != QSizePolicy::Ignored)
      collectIfCut(*label, label->text());
  for (const auto* box : window.findChildren<QComboBox*>()) collectCutChoices(*box, cut);
  for (const auto* header : window.findChildren<QHeaderView*>()) collectCutHeadings(*header, cut);
  return cut;
}

/// A window with a settings file and a recovery folder of its own.
struct Rig {
  explicit Rig(const QString& folder, std::function<QPalette()> desktop = &currentDesktopPalette)
      : settings(folder + "/settings.ini", QSettings::IniFormat), recovery(folder + "/recovery") {
    restoreView(view, settings);
    window =
        std::make_unique<MainWindow>(WindowContext{view, settings, prompts, recovery, std::move(desktop)});
    window->show();
  }
  ButtonDocument& document() { return window->tabs().current()->document(); }
  void scale(double factor) {
    document().history().apply(*scaleForce(document().button(), factor), "Scale force");
  }
  QAction* action(const QString& name) const {
    for (QAction* action : window->allActions())
      if (action->objectName() == name) return action;
    return nullptr;
  }
  QStringList notices() const {
    QStringList all = window->notices().texts();
    if (DocumentTab* tab = window->tabs().current()) all << tab->notices().texts();
    return all;
  }
  void press(const QString& button) {
    for (auto* found : window->findChildren<QPushButton*>(button))
      if (found->isVisible()) return found->click();
    QFAIL(qPrintable("no button " + button));
  }

  QSettings settings;
  ViewSettings view;
  ScriptedPrompts prompts;
  RecoveryStore recovery;
  std::unique_ptr<MainWindow> window;
};

/// Written to the folder that DETENT_PICTURES names, if it does.
void savePicture(QWidget& widget, const QString& name) {
  if (const QString folder = qEnvironmentVariable("DETENT_PICTURES"); !folder.isEmpty())
    widget.grab().save(folder + '/' + name + ".png");
}

double luminance(const QColor& color) {
  const auto linear = [](double c) { return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}

double contrast(const QColor& a, const QColor& b) {
  const double x = luminance(a), y = luminance(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

/// Text of a widget with a background of its own.
QString textSeen(const QWidget& widget) {
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) return label->text();
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) return button->text();
  if (const auto* box = qobject_cast<const QComboBox*>(&widget)) return box->currentText();
  if (const auto* edit = qobject_cast<const QLineEdit*>(&widget)) return edit->displayText();
  return {};
}

/// Visible windows besides the main window. Guarded pointers, because closing one may close others.
QList<QPointer<QWidget>> windowsBeside(const Rig& rig) {
  QList<QPointer<QWidget>> windows;
  for (QWidget* window : QApplication::topLevelWidgets())
    if (window != rig.window.get() && window->isVisible() && window->windowType() != Qt::ToolTip)
      windows.append(window);
  return windows;
}

/// The highest contrast that a pixel has to the colour there is most of.
double contrastIn(const QImage& picture) {
  QHash<QRgb, int> counts;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) ++counts[picture.pixel(x, y)];
  const auto most = std::max_element(counts.begin(), counts.end());
  double best = 0;
  for (auto color = counts.begin(); color != counts.end(); ++color)
    best = std::max(best, contrast(QColor(color.key()), QColor(most.key())));
  return best;
}

/// The highest contrast to the background on the way into a control, from its left edge at half height.
double outlineContrast(const QImage& picture, const QRect& control, const QColor& background) {
  double best = 0;
  for (int x = control.left(); x < control.center().x(); ++x)
    best = std::max(best, contrast(picture.pixelColor(x, control.center().y()), background));
  return best;
}

/// Collects texts that are cut off: in the visible part of a window, and in the whole page of a scroll area.
void collectCutTexts(QWidget& window, const QString& where) {
  QTest::qWait(50);
  const QImage seen = window.grab().toImage();
  if (const QString folder = qEnvironmentVariable("DETENT_PICTURES"); !folder.isEmpty())
    seen.save(QString("%1/texts-%2.png").arg(folder, QString(where).replace(' ', '-')));
  for (const auto* widget : window.findChildren<QWidget*>()) {
    const QRect place(widget->mapTo(&window, QPoint()), widget->size());
    if (widget->window() != window.window() || !widget->isVisibleTo(&window) || !widget->isEnabled() ||
        textSeen(*widget).trimmed().isEmpty() || !seen.rect().contains(place))
      continue;
    if (window.isWindow() && widget->visibleRegion().boundingRect() != widget->rect()) continue;
    const double found = contrastIn(seen.copy(place));
    if (found < 4.5)
      qWarning("%s: %s \"%s\" has %.2f", qPrintable(where), qPrintable(widget->objectName()),
               qPrintable(textSeen(*widget)), found);
    QVERIFY(found >= 4.5);
  }
}

}  // namespace

class WindowTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { folder_ = std::make_unique<QTemporaryDir>(); }

  void argumentsAreFilesAndThreeOptions() {
    const Arguments plain = argumentsFrom({"a.button.json", "--", "--b.png"});
    QCOMPARE(plain.files, QStringList({"a.button.json", "--b.png"}));
    QVERIFY(plain.wrongUsage.isEmpty());
    QVERIFY(argumentsFrom({"--help"}).help);
    QVERIFY(argumentsFrom({"--version"}).version);
    QVERIFY(argumentsFrom({"-h"}).help);
    for (const char* wrong : {"--nonsense", "-n", "--nonsense=3", "-platforms"})
      QVERIFY2(argumentsFrom({wrong}).wrongUsage.contains(wrong), wrong);
    QVERIFY(helpText().contains("Exit codes"));
    const Arguments ofQt = argumentsFrom({"-platform", "offscreen", "--style=fusion", "-reverse", "b.png"});
    QVERIFY(ofQt.wrongUsage.isEmpty());
    QCOMPARE(ofQt.files, QStringList("b.png"));
  }

  void textsAreTranslatedWhereThereIsATranslation() {
    QVERIFY(!installTranslation(*qApp, QLocale("nl"), DETENT_TRANSLATIONS));
    QVERIFY(installTranslation(*qApp, QLocale("fr_FR"), DETENT_TRANSLATIONS));
    {
      Rig rig(folder_->path());
      QVERIFY(rig.action("save")->toolTip().startsWith(QString::fromUtf8("Enregistrer")));
      QCOMPARE(QCoreApplication::translate("Operations", "Scale force"), QString("Changer la force"));
    }
    qDeleteAll(qApp->findChildren<QTranslator*>());
    Rig rig(folder_->path());
    QVERIFY(rig.action("save")->toolTip().startsWith("Save"));
  }

  // German texts are a third longer than English ones.
  void germanTextsAreNotCut() {
    QVERIFY(installTranslation(*qApp, QLocale("de_DE"), DETENT_TRANSLATIONS));
    const auto german = qScopeGuard([] { qDeleteAll(qApp->findChildren<QTranslator*>()); });
    Rig rig(folder_->path());
    QCOMPARE(rig.action("save")->text(), QString("&Speichern"));
    rig.window->resize(1280, 820);
    rig.window->files().open({sample("buttons/latch.button.json"), sample("buttons/B.button.json")});
    rig.action("checksDockToggle")->trigger();
    rig.action("feel")->trigger();
    QTest::qWait(100);
    rig.window->findChild<QToolButton*>("setupToggle")->click();
    QTest::qWait(50);
    QStringList cut = cutTexts(*rig.window);
    rig.action("edit")->trigger();
    QTest::qWait(50);
    cut << cutTexts(*rig.window);
    rig.action("valuesDockToggle")->trigger();
    rig.window->resizeDocks({rig.window->findChild<QDockWidget*>("valuesDock")}, {480}, Qt::Horizontal);
    rig.view.setUnits({LengthUnit::micrometre, ForceUnit::centinewton});
    QTest::qWait(50);
    cut << cutTexts(*rig.window);
    for (const char* name : {"operationScaleForce", "operationDamping", "operationTwoLevel", "snapGridSteps",
                             "forecasts", "study", "preferences", "glossary", "guide", "importMany"}) {
      rig.action(name)->trigger();
      QTest::qWait(50);
      for (const QPointer<QWidget>& window : windowsBeside(rig))
        if (window) cut << cutTexts(*window), window->close();
    }
    rig.action("compare")->trigger();
    rig.window->files().open({sample("plots/two-level-legend.png")});
    auto* import = rig.window->findChild<ImportDialog*>();
    auto* accept = import->findChild<QPushButton*>("import");
    QTRY_VERIFY_WITH_TIMEOUT(accept->isEnabled(), 60000);
    QTest::qWait(100);
    cut << cutTexts(*import) << cutTexts(*rig.window->findChild<ComparePanel*>());
    savePicture(*rig.window, "german-window");
    savePicture(*import, "german-import");
    savePicture(*rig.window->findChild<ComparePanel*>(), "german-compare");
    import->close();
    QVERIFY2(cut.isEmpty(), qPrintable(cut.join('\n')));
  }

  void theEditMenuHasTheUsualOrder() {
    Rig rig(folder_->path());
    const auto* menu = rig.window->findChild<QMenu*>("editMenu");
    rig.window->files().open({sample("buttons/B.button.json")});
    QStringList names;
    for (const QAction* action : menu->actions())
      if (action->isVisible() && !action->isSeparator())
        names << (action->menu() ? action->menu()->objectName() : action->objectName());
    const QStringList usual{"undo",      "redo",       "editCut",       "editCopy",    "paste",
                            "duplicate", "editDelete", "editSelectAll", "arrangeMenu", "curveMenu",
                            "copyMenu",  "rename",     "preferences"};
    QCOMPARE(names, usual);
    for (const char* part : {"arrangeMenu", "curveMenu", "copyMenu"})
      QVERIFY2(!rig.window->findChild<QMenu*>(part)->actions().isEmpty(), part);
  }

  void everyActionIsComplete() {
    Rig rig(folder_->path());
    rig.window->files().open({sample("buttons/B.button.json")});
    QVERIFY(rig.window->allActions().size() > 40);
    QSet<QString> names;
    for (const QAction* action : rig.window->allActions()) {
      if (action->isSeparator()) continue;
      const QByteArray name = action->objectName().toUtf8();
      QVERIFY2(!name.isEmpty(), qPrintable(action->text()));
      QVERIFY2(!names.contains(action->objectName()), name);
      names << action->objectName();
      QVERIFY2(!action->text().isEmpty(), name);
      QVERIFY2(!action->toolTip().isEmpty() && action->toolTip() != action->text(), name);
    }
  }

  void everyToolHasItsIcon() {
    Rig rig(folder_->path());
    rig.window->files().open({sample("buttons/B.button.json")});
    // The views of the centre have their names in place of icons.
    const QStringList named{"edit", "compare", "feel"};
    for (QAction* tool : rig.window->findChild<QToolBar*>("toolBar")->actions()) {
      if (tool->isSeparator() || qobject_cast<QWidgetAction*>(tool)) continue;
      QVERIFY2(named.contains(tool->objectName()) == tool->icon().isNull(), qPrintable(tool->objectName()));
    }
    ImportDialog import(rig.view);
    for (const QAction* tool : import.findChild<QToolBar*>()->actions())
      QVERIFY2(tool->isSeparator() || !tool->icon().isNull(), qPrintable(tool->text()));
  }

  void noShortcutMeansTwoThings() {
    Rig rig(folder_->path());
    rig.window->files().open({sample("buttons/latch.button.json"), sample("buttons/B.button.json")});
    QHash<QString, QString> taken;
    for (const QAction* action : rig.window->allActions())
      for (const QKeySequence& key : action->shortcuts()) {
        const QString keys = key.toString();
        QVERIFY2(!taken.contains(keys),
                 qPrintable(keys + ": " + taken.value(keys) + " and " + action->objectName()));
        taken.insert(keys, action->objectName());
      }
    rig.scale(1.5);
    QVERIFY(rig.action("undo")->text().contains("Scale"));  // in the menu, not in the list of keys
    for (const ShortcutRow& row : rig.window->shortcuts()) {
      QVERIFY2(!row.name.contains("Undo:") && !row.name.contains(u'…'), qPrintable(row.name));
      QVERIFY(!row.name.isEmpty() && !row.keys.isEmpty() && !row.group.isEmpty());
      QVERIFY2(!row.name.contains('&'), qPrintable(row.name));
    }
  }

  void everyWidgetToWorkWithHasAName() {
    Rig rig(folder_->path());
    rig.window->files().open({sample("buttons/latch.button.json")});
    for (const auto* dock : rig.window->findChildren<QDockWidget*>()) const_cast<QDockWidget*>(dock)->show();
    QCoreApplication::processEvents();
    for (QWidget* widget : rig.window->findChildren<QWidget*>()) {
      if (!widget->isVisible() || widget->focusPolicy() == Qt::NoFocus ||
          widget->objectName().startsWith("qt_"))
        continue;
      const bool ownWords = qobject_cast<QAbstractButton*>(widget) || qobject_cast<QDockWidget*>(widget);
      if (ownWords || qobject_cast<QTabWidget*>(widget) ||
          widget->parentWidget()->inherits("QAbstractItemView") ||
          widget->parentWidget()->inherits("QAbstractSpinBox") ||
          widget->parentWidget()->inherits("QComboBox"))
        continue;
      const QAccessibleInterface* reader = QAccessible::queryAccessibleInterface(widget);
      QVERIFY2(reader && !reader->text(QAccessible::Name).isEmpty(),
               qPrintable(QString(widget->metaObject()->className()) + " " + widget->objectName() + " in " +
                          widget->parentWidget()->objectName()));
    }
  }

  void opensSavesAndMarks() {
    Rig rig(folder_->path());
    QVERIFY(!rig.action("save")->isEnabled());
    rig.window->files().open({sample("buttons/B.button.json")});
    QCOMPARE(rig.window->windowTitle(), QString("B[*] \u2013 Detent"));
    rig.scale(1.5);
    QVERIFY(rig.window->isWindowModified());
    rig.prompts.saveAnswers = {at("mine")};
    rig.action("saveAs")->trigger();
    QVERIFY(!rig.window->isWindowModified());
    QVERIFY(QFile::exists(at("mine.button.json")));
    QCOMPARE(rig.window->files().recent().paths().first(), at("mine.button.json"));
    rig.scale(1.5);
    rig.action("save")->trigger();
    QVERIFY((*openDocument(at("mine.button.json")))->button() == rig.document().button());
    QCOMPARE(rig.prompts.unexpected, 0);
  }

  void aFileIsOpenOnce() {
    Rig rig(folder_->path());
    rig.window->files().open(
        {sample("buttons/B.button.json"), sample("buttons/C.button.json"), sample("buttons/B.button.json")});
    QCOMPARE(rig.window->tabs().all().size(), std::size_t{2});
    QCOMPARE(rig.document().title(), QString("B"));
    rig.prompts.saveAnswers = {rig.document().path()};
    rig.window->tabs().showNext(1);
    rig.action("saveAs")->trigger();
    QVERIFY(rig.notices().join("").contains("another tab"));
  }

  void aBrokenFileCostsNothing() {
    Rig rig(folder_->path());
    rig.window->files().open({sample("buttons/B.button.json")});
    rig.scale(2);
    const Button before = rig.document().button();
    QFile broken(at("broken.button.json"));
    QVERIFY(broken.open(QIODevice::WriteOnly));
    broken.write("{\"format\":");
    broken.close();
    rig.window->files().open({at("broken.button.json"), at("missing.button.json")});
    QCOMPARE(rig.window->tabs().all().size(), std::size_t{1});
    QVERIFY(rig.document().button() == before);
    QCOMPARE(rig.window->notices().texts().size(), 2);
    QVERIFY(rig.window->notices().texts()[0].contains("broken.button.json"));
  }

  void closingAsks() {
    Rig rig(folder_->path());
    rig.action("new")->trigger();
    rig.action("close")->trigger();  // untouched: no question
    QVERIFY(!rig.window->tabs().current());
    rig.action("new")->trigger();
    rig.scale(2);
    rig.prompts.unsavedAnswers = {SaveChoice::cancel, SaveChoice::save, SaveChoice::discard};
    rig.action("close")->trigger();
    QVERIFY(rig.window->tabs().current());
    rig.prompts.saveAnswers = {QString()};  // the prompt for the file name is cancelled
    rig.action("close")->trigger();
    QVERIFY(rig.window->tabs().current());
    rig.action("close")->trigger();
    QVERIFY(!rig.window->tabs().current());
    QCOMPARE(rig.prompts.unexpected, 0);
  }

  void quittingAsksOnceForAll() {
    Rig rig(folder_->path());
    rig.window->files().open({sample("buttons/B.button.json"), sample("buttons/C.button.json")});
    rig.scale(2);
    rig.window->tabs().showNext(1);
    rig.scale(2);
    rig.prompts.unsavedAnswers = {SaveChoice::cancel, SaveChoice::discard};
    QVERIFY(!rig.window->close());
    QCOMPARE(rig.prompts.lastUnsaved.size(), 2);
    QVERIFY(rig.window->close());
    rig.recovery.flush();
    QVERIFY(RecoveryStore(folder_->filePath("recovery")).leftBehind().isEmpty());
  }

  void undoAndRedoSayWhat() {
    Rig rig(folder_->path());
    rig.action("new")->trigger();
    QVERIFY(!rig.action("undo")->isEnabled());
    const Button before = rig.document().button();
    rig.scale(2);
    QVERIFY(rig.action("undo")->text().contains("Scale force"));
    rig.action("undo")->trigger();
    QVERIFY(rig.document().button() == before);
    rig.action("redo")->trigger();
    rig.document().history().beginDrag("Drag");
    rig.document().history().preview(before);
    rig.action("undo")->trigger();  // ends the drag, nothing more
    QVERIFY(!rig.document().history().dragging());
    QVERIFY(!(rig.document().button() == before));
  }

  void graphAndTableShareOneSelection() {
    Rig rig(folder_->path());
    rig.action("new")->trigger();
    DocumentTab& tab = *rig.window->tabs().current();
    auto* table = tab.valuesPanel()->findChild<QTableView*>("valuesTable");
    QVERIFY(table);
    GraphCanvas& canvas = tab.workspace().canvas();
    const auto rowOf = [&](const MarkId& mark) {
      return qobject_cast<ValuesPanel*>(tab.valuesPanel())->model().rowOf(mark).value();
    };
    const MarkId first{MarkKind::knot, Stroke::press, 0}, second{MarkKind::knot, Stroke::press, 1};
    canvas.setSelected(first);
    QCOMPARE(table->currentIndex().row(), rowOf(first));
    table->setCurrentIndex(table->model()->index(rowOf(second), ValuesModel::force));
    QVERIFY(canvas.selected() == second);
    QCOMPARE(table->currentIndex().column(),
             int(ValuesModel::force));  // the cell that was chosen stays chosen
  }

  void recoversWhatWasLeft() {
    // Remains of a killed editor: a recovery file under a lock nobody holds.
    QVERIFY(QDir().mkpath(at("recovery/dead")));
    QFile::copy(sample("buttons/B.button.json"), at("b.button.json"));
    const Button saved = (*openDocument(at("b.button.json")))->button();
    const Button unsaved = *scaleForce(saved, 1.25);
    for (const QString& path : {at("b.button.json"), QString()}) {
      QFile file(at("recovery/dead/" + QString(path.isEmpty() ? "2" : "1") + ".recovery.json"));
      QVERIFY(file.open(QIODevice::WriteOnly));
      file.write(QByteArray::fromStdString(
          recoveryText({unsaved, path, path.isEmpty() ? "new" : "b", QDateTime::currentDateTimeUtc()})));
    }
    Rig rig(folder_->path());
    rig.window->files().offerRecovery();
    QVERIFY(rig.window->notices().texts().join("").contains("kept unsaved changes"));
    rig.press("discardRecovery");  // not confirmed: offered again
    rig.press("recover");
    QCOMPARE(rig.window->tabs().all().size(), std::size_t{2});
    for (DocumentTab* tab : rig.window->tabs().all()) {
      QVERIFY(tab->document().button() == unsaved);
      QVERIFY(tab->document().history().modified());
    }
    DocumentTab* onFile = rig.window->tabs().withPath(at("b.button.json"));
    QVERIFY(onFile);
    onFile->document().history().stack().undo();
    QVERIFY(onFile->document().button() == saved);
    QVERIFY(!onFile->document().history().modified());
    QVERIFY(!QDir(at("recovery/dead")).exists());
  }

  // Somebody else saved the file after the editor had died: the recovered changes do not go over it unasked.
  void recoveredChangesAskBeforeTheyOverwrite() {
    QVERIFY(QDir().mkpath(at("recovery/dead")));
    const QString path = at("b.button.json");
    QFile::copy(sample("buttons/B.button.json"), path);
    QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner);
    auto mine = openDocument(path);
    const Button unsaved = *scaleForce((*mine)->button(), 1.25);
    QFile left(at("recovery/dead/1.recovery.json"));
    QVERIFY(left.open(QIODevice::WriteOnly));
    left.write(QByteArray::fromStdString(
        recoveryText({unsaved, path, "b", QDateTime::currentDateTimeUtc(), (*mine)->knownContent()})));
    left.close();
    ButtonDocument other(*scaleForce((*mine)->button(), 3));
    QVERIFY(saveDocument(other, path).ok());
    Rig rig(folder_->path());
    rig.window->files().offerRecovery();
    rig.press("recover");
    QVERIFY(rig.document().button() == unsaved);
    rig.action("save")->trigger();
    QVERIFY((*openDocument(path))->button() == other.button());
    QVERIFY(rig.notices().join(' ').contains("Not saved"));
    rig.press("overwrite");
    QVERIFY((*openDocument(path))->button() == unsaved);
  }

  void changesFromOutsideAreSaid() {
    Rig rig(folder_->path());
    QFile::copy(sample("buttons/B.button.json"), at("b.button.json"));
    QFile::setPermissions(at("b.button.json"), QFile::ReadOwner | QFile::WriteOwner);
    rig.window->files().open({at("b.button.json")});
    rig.scale(1.5);
    const Button mine = rig.document().button();
    const auto writeOther = [&](double factor) {
      ButtonDocument other(*scaleForce(mine, factor));
      QVERIFY(saveDocument(other, at("b.button.json")).ok());
    };
    writeOther(3);
    QTRY_VERIFY(rig.notices().join("").contains("Another program"));
    rig.press("keepMine");
    QVERIFY(rig.document().button() == mine);
    QVERIFY(rig.window->isWindowModified());
    writeOther(4);
    QTRY_VERIFY(rig.notices().join("").contains("Another program"));
    rig.press("reload");
    QVERIFY(rig.document().button() == *scaleForce(mine, 4));
    QVERIFY(!rig.window->isWindowModified());
    QFile::remove(at("b.button.json"));
    QTRY_VERIFY(rig.notices().join("").contains("deleted or moved"));
    QVERIFY(rig.window->isWindowModified());
    rig.action("save")->trigger();
    QVERIFY(QFile::exists(at("b.button.json")));
    QVERIFY(rig.notices().isEmpty());
  }

  void exportsAndCopies() {
    Rig rig(folder_->path());
    rig.window->files().open({sample("buttons/B.button.json")});
    rig.prompts.saveAnswers = {at("e.csv"), at("e.svg"), at("e"), at("e.wav"), at("no/folder/e.wav")};
    rig.prompts.graphAnswers = {GraphExport{}};
    for (const char* name : {"exportCsv", "exportGraph", "exportPng", "exportWav"})
      rig.action(name)->trigger();
    for (const char* file : {"e.csv", "e.svg", "e.png", "e.wav"}) QVERIFY2(QFile::exists(at(file)), file);
    QCOMPARE(QImage(at("e.png")).size(), QSize(2400, 1600));
    rig.action("exportWav")->trigger();
    QVERIFY(rig.notices().join("").contains("Not exported"));
    rig.action("copyCsv")->trigger();
    QVERIFY(QApplication::clipboard()->text().startsWith("stroke,displacement_mm,force_N"));
    rig.action("copyPicture")->trigger();
    QCOMPARE(QApplication::clipboard()->image().size(), QSize(1800, 1200));
  }

  void sharesAPageAndWritesForDevices() {
    Rig rig(folder_->path());
    rig.window->files().open({sample("buttons/B.button.json")});
    rig.prompts.saveAnswers = {at("b"), at("b.ahap")};
    if (playback::hasPageEngine()) {
      rig.action("sharePage")->trigger();
      QVERIFY(QFile::exists(at("b.html")));
    } else {
      rig.prompts.saveAnswers.pop_front();
    }
    DeviceExportDialog dialog(rig.document().button());
    auto* format = dialog.findChild<QComboBox*>("deviceFormat");
    auto* rate = dialog.findChild<QComboBox*>("deviceRate");
    dialog.show();
    for (int i = 0; i < format->count(); ++i) {
      format->setCurrentIndex(i);
      QVERIFY(dialog.findChild<QLabel*>("deviceLoss")
                  ->text()
                  .startsWith("Share of the vibration's energy that the export keeps"));
      QCOMPARE(rate->isVisible(), dialog.choice().wanted.settings.format == playback::ExportFormat::pcm);
      QVERIFY(dialog.findChild<QPushButton*>("deviceExport")->isEnabled());
    }
    format->setCurrentIndex(format->findText("iPhone", Qt::MatchStartsWith));
    rig.prompts.deviceAnswers = {dialog.choice()};
    rig.action("exportDevice")->trigger();
    for (const char* file : {"b.press.ahap", "b.release.ahap"}) QVERIFY2(QFile::exists(at(file)), file);
    rig.action("exportDevice")->trigger();  // cancelled: no question, no file, no message
    QVERIFY(rig.notices().isEmpty());
    rig.prompts.magneticAnswers = {"#define DETENT_RAPID_UM 100\n"};
    rig.prompts.saveAnswers = {at("key")};
    rig.action("exportMagnetic")->trigger();
    QFile key(at("key.h"));
    QVERIFY(key.open(QIODevice::ReadOnly));
    QCOMPARE(key.readAll(), "#define DETENT_RAPID_UM 100\n");
    rig.prompts.magneticTyped.typed = {{"magneticActuate", 1.2}};
    for (int again = 0; again < 2; ++again) rig.action("exportMagnetic")->trigger();  // cancelled
    QVERIFY(rig.notices().isEmpty());
    QCOMPARE(rig.prompts.magneticChoices.back().typed, rig.prompts.magneticTyped.typed);
    // If a format has no room for the press, this is reported before anything is written.
    rig.window->files().open({sample("buttons/latch.button.json")});
    rig.action("exportMagnetic")->trigger();  // another button has its own choice
    QVERIFY(rig.prompts.magneticChoices.back().typed.isEmpty());
    DeviceExportDialog latch(rig.document().button());
    auto* formats = latch.findChild<QComboBox*>("deviceFormat");
    formats->setCurrentIndex(formats->findText("OpenXR", Qt::MatchContains));
    const auto cut = [&] { return latch.findChild<QLabel*>("deviceLoss")->text().contains("cut off"); };
    QVERIFY(!cut());
    latch.findChild<QSpinBox*>("deviceWayDown")->setValue(10'000);
    QVERIFY(cut());
  }

  // A folder of tables, and a project in the units shown, of the button in front and of the state shown.
  void exportsForProgramsOfOthers() {
    Rig rig(folder_->path());
    rig.window->files().open({sample("buttons/B.button.json"), sample("buttons/latch.button.json")});
    rig.document().setActiveState(1);
    rig.prompts.saveAnswers = {at("latch-datapackage"), at("p"), at("p.wpd.json"), at("no/such/folder")};
    rig.action("exportDataPackage")->trigger();
    QVERIFY(rig.prompts.lastSuggested.endsWith("-datapackage"));
    QCOMPARE(QDir(at("latch-datapackage")).entryList(QDir::Files),
             (QStringList{"curve-1.csv", "curve-2.csv", "datapackage.json", "figures.csv"}));
    rig.action("exportTracedProject")->trigger();
    rig.action("exportTracedProject")->trigger();
    QVERIFY(QFile::exists(at("p.tar")) && QFile::exists(at("p.wpd.json")));
    QFile project(at("p.wpd.json"));
    QVERIFY(project.open(QIODevice::ReadOnly));
    const auto& shown = rig.document().button().states()[1];
    SvgPlotStyle style;
    style.forceUnit = rig.view.units().force;
    style.lengthUnit = rig.view.units().length;
    QCOMPARE(project.readAll().toStdString(), tracedProjectFrom(shown, style));
    rig.action("exportDataPackage")->trigger();
    QVERIFY(rig.notices().join("").contains("Not exported"));
    QVERIFY(!QFileInfo::exists(at("no")));
  }

  // A machine that is switched off ends no session.
  void theSessionIsStoredWithEveryTab() {
    Rig rig(folder_->path());
    const auto stored = [&] { return rig.settings.value("session/files").toStringList(); };
    rig.window->files().open({sample("buttons/B.button.json"), sample("buttons/C.button.json")});
    QCOMPARE(stored().size(), 2);
    rig.window->files().close(*rig.window->tabs().current());
    QCOMPARE(stored(), QStringList{sample("buttons/B.button.json")});
    rig.window->close();  // the open tabs come back at the next start
    QCOMPARE(stored(), QStringList{sample("buttons/B.button.json")});
  }

  void makesButtonsOfSeveral() {
    Rig rig(folder_->path());
    rig.window->files().open({sample("buttons/B.button.json")});
    rig.action("morph")->trigger();  // alone: nothing is in between
    QVERIFY(!rig.window->findChild<MorphDialog*>());
    rig.window->files().open({sample("buttons/C.button.json")});
    const double b_mm = metricsOf(rig.window->tabs().all()[0]->document().button().states()[0])
                            .press.tactile[0]
                            .point.displacement_mm;
    const double c_mm = metricsOf(rig.window->tabs().all()[1]->document().button().states()[0])
                            .press.tactile[0]
                            .point.displacement_mm;
    rig.action("morph")->trigger();
    auto* dialog = rig.window->findChild<MorphDialog*>();
    QVERIFY(dialog);
    auto* share = dialog->findChild<QSlider*>("morphShare");
    share->setValue(0);
    QVERIFY(dialog->between()->states() == rig.document().button().states());
    share->setValue(25);
    QTRY_VERIFY_WITH_TIMEOUT(
        dialog->findChild<QLabel*>("morphForecastTo")->text().startsWith("Compared with B"), 20'000);
    dialog->findChild<QPushButton*>("morphCreate")->click();
    QCOMPARE(rig.window->tabs().all().size(), std::size_t(3));
    const double made_mm =
        metricsOf(rig.document().button().states()[0]).press.tactile[0].point.displacement_mm;
    QVERIFY(std::abs(made_mm - (0.75 * c_mm + 0.25 * b_mm)) < 0.01);
    QVERIFY(rig.document().history().modified());  // the button exists in no file
    // A two-level button is another kind: it is not ticked, and refused where it is.
    rig.window->files().open({sample("buttons/D.button.json")});
    rig.window->tabs().show(rig.window->tabs().all()[0]->document());
    rig.action("average")->trigger();
    auto* which = rig.window->findChild<AverageDialog*>();
    QVERIFY(which);
    auto* list = which->findChild<QListWidget*>("averageButtons");
    auto* create = which->findChild<QPushButton*>("averageCreate");
    QCOMPARE(which->titles().size(), 3);
    QCOMPARE(list->item(3)->checkState(), Qt::Unchecked);
    list->item(3)->setCheckState(Qt::Checked);
    QVERIFY(!create->isEnabled() && !which->spread());
    QVERIFY(which->findChild<QLabel*>("averageRefusal")->text().contains("of one kind"));
    list->item(3)->setCheckState(Qt::Unchecked);
    QVERIFY(create->isEnabled());
    create->click();
    QCOMPARE(rig.window->tabs().all().size(), std::size_t(5));
    QVERIFY(rig.document().history().modified());
    QVERIFY(rig.notices().join("").contains("Mean of 3"));
    QVERIFY(rig.document().title().contains("Mean of 3"));  // not the name of one of them
  }

  // Presets fill in the fields, later changes stay, and a graph that cannot be drawn cannot be exported.
  void choosesHowAGraphIsPrinted() {
    const Button button = *readButton((sample("buttons/C.button.json")).toStdString());
    GraphExportDialog dialog(button, {});
    dialog.show();
    const auto box = [&](const char* name) { return dialog.findChild<QComboBox*>(name); };
    const auto field = [&](const char* name) { return dialog.findChild<QuantityField*>(name); };
    auto* accept = dialog.findChild<QPushButton*>("graphExport");
    const auto type = [&](const char* name, const QString& text) {
      field(name)->findChild<QLineEdit*>()->clear();
      QTest::keyClicks(field(name)->findChild<QLineEdit*>(), text);
    };
    QVERIFY(dialog.choice().style.dimensions && accept->isEnabled());
    box("graphPreset")->setCurrentIndex(1);
    QVERIFY(dialog.choice().style.monochrome && !dialog.choice().style.callouts);
    QCOMPARE(*dialog.choice().style.width_mm, 88.0);
    type("graphWidth", "120");
    QCOMPARE(*dialog.choice().style.width_mm, 120.0);
    box("graphForce")->setCurrentIndex(box("graphForce")->findText("gf"));
    type("graphYTo", "150 gf");
    QVERIFY(std::abs(dialog.choice().style.yEnds->highest - 150) < 1e-9);
    QCOMPARE(dialog.choice().style.yEnds->lowest, 0.0);
    type("graphYTo", "-3 gf");
    QVERIFY(!accept->isEnabled());
    QVERIFY(!dialog.findChild<QLabel*>("graphRefusal")->text().isEmpty());
    type("graphYTo", "automatic");
    QVERIFY(accept->isEnabled() && !dialog.choice().style.yEnds);
    type("graphTolerance", "10 %");
    QCOMPARE(*dialog.choice().style.tolerance, 0.1);
    type("graphToleranceForce", "5 gf");  // one of the two
    QVERIFY(!dialog.choice().style.tolerance);
    QVERIFY(std::abs(*dialog.choice().style.tolerance_N - 5 * 0.00980665) < 1e-9);
    QCOMPARE(field("graphTolerance")->findChild<QLineEdit*>()->text(), QString("none"));
    dialog.findChild<QSpinBox*>("graphFontSize")->setValue(30);
    QVERIFY(!accept->isEnabled());
  }

  /// Exports, prints and copies are pictures of their own; the window goes on as it was, to the pixel.
  void exportsLeaveTheWindowAlone() {
    Rig rig(folder_->path());
    rig.window->files().open({sample("buttons/C.button.json")});
    GraphCanvas& canvas = rig.window->tabs().current()->workspace().canvas();
    canvas.zoomAt(canvas.rect().center(), 1.5, 1.2);
    const auto seen = [&] { return canvas.grab().toImage().convertToFormat(QImage::Format_RGB32); };
    // A busy machine takes its time until the window has its size: nothing is exported before it lies still.
    constexpr int still_ms = 300;
    QImage before;
    QTRY_VERIFY_WITH_TIMEOUT((before = seen(), QTest::qWait(still_ms), seen() == before), 10'000);
    const QPointF place_px = canvas.mapping().toPixel(1.6, 0.65);
    rig.prompts.printedTo = at("alone.pdf");
    for (const char* name :
         {"exportCsv", "exportGraph", "exportPng", "exportWav", "print", "copyPicture", "copyCsv"}) {
      rig.prompts.saveAnswers = {at(QString("alone.") + QString(name).right(3).toLower())};
      rig.prompts.graphAnswers = {GraphExport{}};
      rig.action(name)->trigger();
      QVERIFY2(seen() == before, name);
      QCOMPARE(canvas.mapping().toPixel(1.6, 0.65), place_px);
      QTest::qWait(20);  // lets delayed work run
      QVERIFY2(seen() == before, name);
    }
  }

  /// The imported button has the keyboard focus, and the dialogue is gone.
  void theKeyboardFollowsAnImport() {
    Rig rig(folder_->path());
    rig.window->files().open({sample("plots/white-vector.pdf")});
    auto* dialog = rig.window->findChild<ImportDialog*>();
    QVERIFY(QTest::qWaitForWindowActive(dialog));
    auto* accept = dialog->findChild<QPushButton*>("import");
    QTRY_VERIFY_WITH_TIMEOUT(accept->isEnabled(), 60'000);
    accept->setFocus();
    QTest::keyClick(accept, Qt::Key_Space);
    QTRY_VERIFY(rig.window->tabs().current());
    QTRY_VERIFY(rig.window->isActiveWindow());
    QTRY_COMPARE(QApplication::focusWidget(), &rig.window->tabs().current()->workspace().canvas());
  }

  void theListOfABatchLearnsOfAnImportByHand() {
    Rig rig(folder_->path());
    rig.action("importMany")->trigger();
    auto* batch = rig.window->findChild<QDialog*>("batchDialog");
    auto* list = batch->findChild<QTreeWidget*>("batchList");
    rig.prompts.openAnswers = {{sample("plots/white-vector.pdf")}};
    batch->findChild<QPushButton*>("batchFiles")->click();
    QTRY_VERIFY_WITH_TIMEOUT(list->topLevelItem(0)->text(1).endsWith('%'), 60'000);
    list->topLevelItem(0)->setSelected(true);
    batch->findChild<QPushButton*>("batchCorrect")->click();
    auto* accept = rig.window->findChild<ImportDialog*>()->findChild<QPushButton*>("import");
    QTRY_VERIFY_WITH_TIMEOUT(accept->isEnabled(), 60'000);
    accept->click();
    QCOMPARE(list->topLevelItem(0)->text(1), QString("100 %, checked"));
  }

  void picturesAndPagesGoToTheImport() {
    Rig rig(folder_->path());
    QImage picture(60, 40, QImage::Format_RGB32);
    picture.fill(Qt::white);
    QApplication::clipboard()->setImage(picture);
    rig.action("paste")->trigger();
    const auto dialogs = [&] {
      int visible = 0;
      for (const auto* dialog : rig.window->findChildren<ImportDialog*>()) visible += dialog->isVisible();
      return visible;
    };
    QCOMPARE(dialogs(), 1);
    rig.window->findChild<ImportDialog*>()->reject();
    QCOMPARE(dialogs(), 0);
    QMimeData files;
    files.setUrls({QUrl::fromLocalFile(sample("plots/locked-dark.png")),
                   QUrl::fromLocalFile(sample("plots/two-level-legend.png")),
                   QUrl::fromLocalFile(sample("buttons/C.button.json"))});
    QVERIFY(FileController::canTake(files));
    QVERIFY(rig.window->files().take(files));
    QCOMPARE(dialogs(), 1);
    QCOMPARE(rig.document().title(), QString("C"));
    rig.window->findChild<ImportDialog*>()->reject();
    QTRY_COMPARE(dialogs(), 1);  // the second page had waited
    rig.window->findChild<ImportDialog*>()->reject();
    QCoreApplication::processEvents();
    QCOMPARE(dialogs(), 0);
    QMimeData nothing;
    nothing.setText("words");
    QVERIFY(!FileController::canTake(nothing));
  }

  void nothingIsWrittenOverSomebodyElsesChange() {
    const QString path = at("b.button.json");
    QVERIFY(QFile::copy(sample("buttons/B.button.json"), path));
    const auto contents = [](const QString& of) {
      QFile file(of);
      return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    const auto writeOther = [&](double factor) {
      auto other = openDocument(path);
      (*other)->history().apply(*scaleForce((*other)->button(), factor), "Scale");
      QVERIFY(saveDocument(**other, path).ok());
    };
    Rig rig(folder_->path());
    rig.window->files().open({path});
    rig.scale(1.1);
    writeOther(2);
    const QByteArray otherCopy = contents(path);
    rig.action("save")->trigger();  // before the watch could have said anything
    QCOMPARE(contents(path), otherCopy);
    QVERIFY(rig.notices().join(' ').contains("changed"));
    QVERIFY(rig.document().history().modified());
    // Save as leaves the file of the other program unchanged.
    rig.prompts.saveAnswers.push_back(at("mine.button.json"));
    rig.press("saveAs");
    QCOMPARE(contents(path), otherCopy);
    QVERIFY(QFile::exists(at("mine.button.json")));
    QVERIFY(!rig.document().history().modified());
    // Overwriting is a decision for this content only.
    rig.window->files().open({path});
    rig.scale(1.2);
    writeOther(3);
    rig.action("save")->trigger();
    rig.press("overwrite");
    QVERIFY(!rig.document().history().modified());
    QVERIFY(*openDocument(path).value()->button().states()[0].graph.press().knots().begin() ==
            *rig.document().graph().press().knots().begin());
    rig.scale(1.2);
    writeOther(4);
    const QByteArray again = contents(path);
    rig.action("save")->trigger();
    QCOMPARE(contents(path), again);
    rig.press("reload");
    QVERIFY(!rig.document().history().modified());
    rig.document().history().stack().undo();
    QVERIFY(rig.document().history().modified());
  }

  void everyNoticeOfAFailedSaveOffersAnotherPlace() {
    Rig rig(folder_->path());
    rig.window->files().open({sample("buttons/B.button.json")});
    rig.prompts.saveAnswers.push_back(at("no/such/folder/b.button.json"));
    rig.action("saveAs")->trigger();
    rig.prompts.saveAnswers.push_back(at("b.button.json"));
    rig.press("saveAs");
    QVERIFY(QFile::exists(at("b.button.json")));
    QVERIFY(!rig.notices().join(' ').contains("Not saved"));
  }

  // Three unsaved buttons of one name: each is proposed a file of its own, none that was just written.
  void saveAllNeverProposesAFileItJustWrote() {
    Rig rig(folder_->path());
    rig.settings.setValue("files/folder", folder_->path());
    rig.prompts.takesSuggestions = true;
    for (int i = 0; i < 3; ++i) rig.action("new")->trigger(), rig.scale(1.1 + i);
    rig.action("saveAll")->trigger();
    QSet<QString> paths;
    for (DocumentTab* tab : rig.window->tabs().all()) {
      QVERIFY(!tab->document().history().modified());
      QVERIFY(QFile::exists(tab->document().path()));
      paths << tab->document().path();
    }
    QCOMPARE(paths.size(), 3);
    QCOMPARE(rig.prompts.unexpected, 0);
  }

  // Keys named in the list of shortcuts work with every focus.
  void listedKeysWorkWhereverTheFocusIs() {
    Rig rig(folder_->path());
    rig.window->files().open({sample("buttons/B.button.json")});
    rig.window->activateWindow();
    QCoreApplication::processEvents();
    QVERIFY(QTest::qWaitForWindowActive(rig.window.get()));
    rig.action("feel")->trigger();
    rig.action("historyDockToggle")->trigger();
    rig.action("checksDockToggle")->trigger();
    for (const char* place : {"graphCanvas", "valuesTable", "libraryOpenButtons", "tabBar", "historyView",
                              "checksList", "pressPad", "gain", "modeChoice", "libraryFilter"}) {
      auto* focus = rig.window->findChild<QWidget*>(place);
      QVERIFY2(focus, place);
      rig.action("edit")->trigger();
      for (const char* name : {"rename", "valuesDockToggle", "historyDockToggle", "libraryDockToggle",
                               "operationScaleTravel", "operationAddJump", "compare", "undo"}) {
        QAction* action = rig.action(name);
        QVERIFY2(action, name);
        action->setEnabled(true);
        int triggered = 0;
        const auto counted = connect(action, &QAction::triggered, this, [&] { ++triggered; });
        rig.window->findChild<QDockWidget*>("valuesDock")->show();
        rig.window->findChild<QDockWidget*>("libraryDock")->show();
        rig.window->findChild<QDockWidget*>("valuesDock")->raise();
        focus->setFocus();
        const QKeyCombination keys = action->shortcut()[0];
        QTest::keyClick(rig.window->focusWidget() ? rig.window->focusWidget() : focus, keys.key(),
                        keys.keyboardModifiers());
        disconnect(counted);
        for (QDialog* dialog : rig.window->findChildren<QDialog*>())
          if (dialog->isVisible()) dialog->reject();
        QVERIFY2(triggered == 1, qPrintable(QString("%1 at %2").arg(name, place)));
      }
    }
  }

  void aPanelBehindAnotherIsShownByItsKey() {
    Rig rig(folder_->path());
    rig.window->files().open({sample("buttons/B.button.json")});
    auto* history = rig.window->findChild<QDockWidget*>("historyDock");
    QVERIFY(history->visibleRegion().isEmpty());  // behind the values
    rig.action("historyDockToggle")->trigger();
    QTRY_VERIFY(!history->visibleRegion().isEmpty());
    rig.action("historyDockToggle")->trigger();
    QTRY_VERIFY(!history->isVisible());
  }

  void aButtonIsCopiedAsTextAndDuplicated() {
    Rig rig(folder_->path());
    rig.window->files().open({sample("buttons/B.button.json")});
    const Button button = rig.document().button();
    QVERIFY(QMetaObject::invokeMethod(rig.action("editCopy"), "trigger"));
    QVERIFY(QApplication::clipboard()->text().contains("detent-button"));
    rig.action("paste")->trigger();
    QCOMPARE(rig.window->tabs().all().size(), 2);
    QVERIFY(rig.document().button() == button);
    QVERIFY(rig.document().history().modified());
    rig.action("duplicate")->trigger();
    QCOMPARE(rig.window->tabs().all().size(), 3);
    QVERIFY(rig.document().button() == button);
  }

  // Import, save, close, open: the page, the traced points and Refit are there again; without the sheet there
  // is a way to show it.
  void thePageComesBack() {
    const QString sheet = at("sheet.pdf"), button = at("b.button.json");
    QVERIFY(QFile::copy(sample("plots/white-vector.pdf"), sheet));
    importer::ImportRequest request;
    request.path = sheet.toStdString();
    auto report = importer::ImportSession::open(request.path)->importGraph(request);
    QVERIFY(report.ok());
    {
      auto imported = importedDocument(std::make_shared<importer::ImportReport>(*report));
      QVERIFY(saveDocument(*imported, button).ok());
    }
    Rig rig(folder_->path());
    rig.window->files().open({button});
    const QSignalSpy wanted(&rig.document(), &ButtonDocument::originWanted);
    QTRY_VERIFY_WITH_TIMEOUT(rig.document().sheet().has_value(), 60000);
    // The page alone, behind the curves: nothing was read again without a request.
    const GraphCanvas& canvas = rig.window->tabs().current()->workspace().canvas();
    QVERIFY(canvas.hasUnderlay() && !rig.document().origin());
    QCOMPARE(wanted.count(), 0);
    const importer::Homography& traced = report->evidence->axes.calibration.value.viewToUnits;
    const auto unitsAt = [&](double x, double y) {
      const importer::Point at = traced({x, y});
      return QPointF(at.x, at.y);
    };
    const auto& corners = report->evidence->frame.corners;
    const QRectF frame(unitsAt(corners[3].x, corners[3].y), unitsAt(corners[1].x, corners[1].y));
    const QTransform axesToPixel = rig.document().sheet()->pixelToAxes.inverted();
    QVERIFY(axesToPixel.mapRect(frame).width() > 500 && axesToPixel.mapRect(frame).height() > 200);
    // Whoever wants the points gets them: Refit opens when they are there.
    QVERIFY(rig.action("operationRefit")->isEnabled());
    rig.action("operationRefit")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(rig.window->findChild<OperationDialog*>() != nullptr, 60000);
    QVERIFY(rig.document().origin() && !canvas.tracedPoints(Stroke::press).empty());
    rig.window->findChild<OperationDialog*>()->reject();
    QVERIFY(!rig.document().history().modified());
    rig.window->tabs().remove(*rig.window->tabs().current());
    // Moved away: another file of its name is not it; the person shows where it is.
    QVERIFY(QDir(folder_->path()).mkdir("elsewhere"));
    QVERIFY(QFile::rename(sheet, at("elsewhere/renamed.pdf")));
    QVERIFY(QFile::copy(sample("plots/two-level-legend.png"), sheet));
    rig.window->files().open({button});
    QTRY_VERIFY_WITH_TIMEOUT(rig.notices().join(' ').contains("sheet.pdf"), 60000);
    QVERIFY(!rig.document().origin());
    rig.prompts.openAnswers.push_back({sheet});
    rig.press("findSheet");
    QTRY_VERIFY_WITH_TIMEOUT(rig.notices().join(' ').contains("from another datasheet"), 60000);
    rig.prompts.openAnswers.push_back({at("elsewhere/renamed.pdf")});
    rig.press("findSheet");
    QTRY_VERIFY_WITH_TIMEOUT(rig.document().sheet().has_value(), 60000);
    QVERIFY(!rig.notices().join(' ').contains("sheet"));
    // From now on it is found where it was shown to be.
    rig.window->tabs().remove(*rig.window->tabs().current());
    rig.window->files().open({button});
    QTRY_VERIFY_WITH_TIMEOUT(rig.document().sheet().has_value(), 60000);
    // Traced points are loaded when they are shown.
    rig.action("viewResiduals")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(rig.document().origin() != nullptr, 60000);
  }

  // Behind another panel's tab the checks do not have the page read again; in front they do.
  void theChecksWantThePageWhenTheyAreSeen() {
    const QString sheet = at("sheet.pdf"), button = at("b.button.json");
    QVERIFY(QFile::copy(sample("plots/white-vector.pdf"), sheet));
    importer::ImportRequest request;
    request.path = sheet.toStdString();
    auto report = importer::ImportSession::open(request.path)->importGraph(request);
    QVERIFY(report.ok());
    QVERIFY(saveDocument(*importedDocument(std::make_shared<importer::ImportReport>(*report)), button).ok());
    Rig rig(folder_->path());
    rig.window->files().open({button});
    const QSignalSpy wanted(&rig.document(), &ButtonDocument::originWanted);
    QTRY_VERIFY_WITH_TIMEOUT(rig.document().sheet().has_value(), 60000);
    rig.scale(1.25);
    QCOMPARE(wanted.count(), 0);
    rig.action("checksDockToggle")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(rig.document().origin() != nullptr, 60000);
  }

  // By choice the button's file holds the page: where the sheet is gone, it lies behind the curves where it
  // lay.
  void thePageIsKeptInTheFile() {
    const QString sheet = at("sheet.pdf"), button = at("b.button.json");
    QVERIFY(QFile::copy(sample("plots/white-vector.pdf"), sheet));
    importer::ImportRequest request;
    request.path = sheet.toStdString();
    auto report = importer::ImportSession::open(request.path)->importGraph(request);
    QVERIFY(report.ok());
    QVERIFY(saveDocument(*importedDocument(std::make_shared<importer::ImportReport>(*report)), button).ok());
    const qint64 without_bytes = QFileInfo(button).size();
    Rig rig(folder_->path());
    QAction& keep = *rig.action("keepPage");
    QVERIFY(!keep.isEnabled());
    rig.window->files().open({button});
    QTRY_VERIFY_WITH_TIMEOUT(rig.document().sheet().has_value(), 60000);
    const PlacedPage shown = *rig.document().sheet();
    QVERIFY(keep.isEnabled() && !keep.isChecked());
    keep.trigger();
    QVERIFY(keep.isChecked() && rig.document().history().modified());
    rig.action("save")->trigger();
    QVERIFY(!rig.document().history().modified());
    QVERIFY(QFileInfo(button).size() > without_bytes + 10000);
    QVERIFY(QFileInfo(button).size() < without_bytes + (3 << 19));
    rig.window->tabs().remove(*rig.window->tabs().current());

    QVERIFY(QFile::remove(sheet));
    rig.window->files().open({button});
    QTRY_VERIFY_WITH_TIMEOUT(rig.document().sheet().has_value(), 60000);
    QTRY_VERIFY(rig.notices().join(' ').contains("kept in the button's file"));
    QVERIFY(keep.isEnabled() && keep.isChecked());
    const PlacedPage kept = *rig.document().sheet();
    QVERIFY(!kept.readable && !rig.document().originOnDemand());
    QCOMPARE(kept.picture.size(), shown.picture.size());
    const QPointF middle(0.5 * shown.picture.width(), 0.5 * shown.picture.height());
    const QPointF off = kept.pixelToAxes.map(middle) - shown.pixelToAxes.map(middle);
    QVERIFY(std::abs(off.x()) < 1e-9 && std::abs(off.y()) < 1e-9);
    QCOMPARE(kept.picture.convertToFormat(QImage::Format_RGB32),
             shown.picture.convertToFormat(QImage::Format_RGB32));
    QVERIFY(!rig.document().history().modified());
    // Taken out again.
    keep.trigger();
    QVERIFY(!keep.isChecked() && rig.document().history().modified());
    rig.action("save")->trigger();
    QCOMPARE(QFileInfo(button).size(), without_bytes);
  }

  // A large page is kept smaller, and lies where it lay.
  void aLargePageIsKeptSmaller() {
    QImage noise(3000, 1500, QImage::Format_RGB32);
    std::mt19937 random(7);
    for (int y = 0; y < noise.height(); ++y)
      for (int x = 0; x < noise.width(); ++x) noise.setPixel(x, y, QRgb(random()));
    const PlacedPage page{noise, QTransform(0.001, 0, 0, 0, -0.0005, 0, -0.5, 1.5, 1)};
    const auto cutout = cutoutOf(page);
    QVERIFY(cutout && cutout->png.size() <= largestCutout_bytes);
    const auto kept = placedFrom(*cutout);
    QVERIFY(kept && kept->picture.width() >= 320 && kept->picture.width() < 1000);
    const QRectF all(-0.5, -0.5, kept->picture.width(), kept->picture.height());
    const QRectF there = kept->pixelToAxes.mapRect(all),
                 before = page.pixelToAxes.mapRect(QRectF(-0.5, -0.5, 3000, 1500));
    QVERIFY(std::abs(there.left() - before.left()) < 1e-9 && std::abs(there.right() - before.right()) < 1e-9);
    QVERIFY(std::abs(there.top() - before.top()) < 1e-9 && std::abs(there.bottom() - before.bottom()) < 1e-9);
    QVERIFY(!placedFrom({"\x89PNG\r\n\x1a\nbroken", cutout->pixelToAxes}));
  }

  // A button that was reshaped so far that its page does not prove itself is read again at once, as is a page
  // on its side that nothing says is on its side.
  void aPageThatDoesNotProveItselfIsReadAgain() {
    const QString sheet = at("sheet.png"), button = at("b.button.json");
    QVERIFY(QFile::copy(sample("plots/two-level-legend.png"), sheet));
    importer::ImportRequest request;
    request.path = sheet.toStdString();
    auto report = importer::ImportSession::open(request.path)->importGraph(request);
    QVERIFY(report.ok());
    auto imported = importedDocument(std::make_shared<importer::ImportReport>(*report));
    const auto document = importer::Document::open(request.path);
    QVERIFY(document.ok());
    QVERIFY(placedPage(imported->button(), *document, {}).has_value());
    const Button reshaped = *scaleForce(imported->button(), 0.4);
    QVERIFY(!placedPage(reshaped, *document, {}));
    imported->history().apply(reshaped, "Scale force");
    QVERIFY(saveDocument(*imported, button).ok());
    Rig rig(folder_->path());
    rig.window->files().open({button});
    QTRY_VERIFY_WITH_TIMEOUT(rig.document().origin() != nullptr, 60000);
    QVERIFY(rig.document().button() == reshaped);
  }

  void aSampleIsThereToTry() {
    Rig rig(folder_->path());
    auto* offered = rig.window->findChild<QPushButton*>("welcome_trySample");
    QVERIFY(offered && offered->isVisible());
    offered->click();
    auto* dialog = rig.window->findChild<ImportDialog*>();
    QVERIFY(dialog && dialog->isVisible());
    auto* accept = dialog->findChild<QPushButton*>("import");
    QTRY_VERIFY_WITH_TIMEOUT(accept->isEnabled(), 60000);
    accept->click();
    QVERIFY(rig.document().button().provenance().has_value());
  }

  void whatCannotBeReadLeavesTheRecentList() {
    Rig rig(folder_->path());
    const QString button = at("b.button.json"), sheet = at("s.png");
    QVERIFY(QFile::copy(sample("buttons/B.button.json"), button));
    QVERIFY(QFile::copy(sample("plots/locked-dark.png"), sheet));
    rig.window->files().open({button});
    rig.window->files().open({sheet});
    QTRY_COMPARE_WITH_TIMEOUT(rig.window->files().recent().paths().size(), 2, 60000);
    rig.window->findChild<ImportDialog*>()->reject();
    for (const QString& path : {button, sheet}) {
      QFile file(path);
      QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
      file.write("nothing of the kind");
    }
    rig.window->tabs().remove(*rig.window->tabs().current());
    rig.window->files().open({button});
    QCOMPARE(rig.window->files().recent().paths(), QStringList{sheet});
    rig.window->files().open({sheet});
    QTRY_VERIFY_WITH_TIMEOUT(rig.window->files().recent().paths().isEmpty(), 60000);
  }

  void checksAreLiveAndLeadToTheirPlace() {
    Rig rig(folder_->path());
    rig.window->files().open({sample("buttons/B.button.json")});
    rig.action("checksDockToggle")->trigger();
    auto* checks = rig.window->findChild<ChecksPanel*>();
    QVERIFY(checks);
    const ForceGraph& graph = rig.document().graph();
    const auto swapped = ForceGraph::fromCurves(*graph.release(), graph.press());
    QVERIFY(swapped.ok());
    const int before = static_cast<int>(checks->texts().size());
    rig.document().history().apply(
        *editGraph(rig.document().button(), 0, [&](const ForceGraph&) { return swapped; }), "Exchange");
    QVERIFY(checks->texts().size() > before);
    QVERIFY(checks->texts().join(' ').contains("above the press"));
    QVERIFY(checks->texts().join(' ').contains(" cN"));
    rig.action("unit_force_gf")->trigger();
    QVERIFY(checks->texts().join(' ').contains(" gf") && !checks->texts().join(' ').contains(" cN"));
    auto* list = checks->findChild<QListWidget*>("checksList");
    emit list->itemClicked(list->item(0));
    QVERIFY(rig.window->tabs().current()->workspace().canvas().selected().has_value());
    rig.document().history().stack().undo();
    QCOMPARE(static_cast<int>(checks->texts().size()), before);
  }

  void aFileThatAnotherWindowHasSaysSo() {
    const QString file = folder_->filePath("shared.button.json");
    QVERIFY(QFile::copy(sample("buttons/B.button.json"), file));
    Rig here(folder_->path());
    here.window->files().open({file});
    QVERIFY(here.notices().isEmpty());
    Rig there(folder_->path());
    there.window->files().open({file});
    QVERIFY(there.notices().join(' ').contains("has this file open"));
  }

  void aDialogueLeavesItsPreviewInSight() {
    Rig rig(folder_->path());
    rig.window->resize(700, 500);
    rig.window->move(0, 0);
    rig.window->findChild<QDockWidget*>("libraryDock")->hide();
    rig.window->files().open({sample("buttons/B.button.json")});
    QCoreApplication::processEvents();
    rig.action("operationScaleForce")->trigger();
    auto* dialog = rig.window->findChild<OperationDialog*>();
    QVERIFY(dialog && dialog->isVisible());
    const QWidget& canvas = rig.window->tabs().current()->workspace().canvas();
    const QRect graph(canvas.mapToGlobal(QPoint()), canvas.size());
    const int room = dialog->screen()->availableGeometry().right() - graph.right();
    QVERIFY2(room < dialog->frameGeometry().width() || !graph.intersects(dialog->frameGeometry()),
             "it covers the graph");
    dialog->reject();
  }

  void f6LeavesEveryPanel() {
    Rig rig(folder_->path());
    rig.window->files().open({sample("buttons/B.button.json")});
    rig.window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(rig.window.get()));
    rig.window->tabs().current()->workspace().canvas().setFocus();
    rig.window->findChild<QDockWidget*>("libraryDock")->show();
    QCoreApplication::processEvents();
    QSet<QWidget*> seen;
    for (int i = 0; i < 3; ++i) {
      seen << QApplication::focusWidget();
      rig.action("nextPanel")->trigger();
    }
    QCOMPARE(seen.size(), 3);  // graph, values, library
    QCOMPARE(QApplication::focusWidget(), &rig.window->tabs().current()->workspace().canvas());
    rig.action("previousPanel")->trigger();
    QVERIFY(QApplication::focusWidget() != &rig.window->tabs().current()->workspace().canvas());
  }

  void thePanelsComeBackAsWideAsTheyWere() {
    constexpr int wide_px = 391;
    for (int run = 0; run < 3; ++run) {
      Rig rig(folder_->path());
      rig.window->files().open({sample("buttons/B.button.json")});
      auto* values = rig.window->findChild<QDockWidget*>("inspectorDock");
      QTest::qWait(60);
      if (run == 0) {
        rig.window->resize(1280, 820);
        rig.window->resizeDocks({values}, {wide_px}, Qt::Horizontal);
        QTest::qWait(20);
      }
      // A slow program lays its panels out later.
      QTRY_VERIFY2(std::abs(values->width() - wide_px) <= 2, qPrintable(QString::number(values->width())));
      if (run == 1) rig.action("compare")->trigger();  // hides them: they come back with the next button
      QVERIFY(rig.window->close());
    }
  }

  void aBrokenWidthIsNoWidth() {
    constexpr int wide_px = 391, least_px = 150, most_px = 640;
    const auto widthAfter = [&](const QVariant& stored) {
      {
        Rig rig(folder_->path());
        rig.window->resize(1280, 820);
        rig.window->files().open({sample("buttons/B.button.json")});
        QTest::qWait(60);
        rig.window->close();
        rig.settings.setValue("window/inspector_px", stored);
      }
      Rig again(folder_->path());
      again.window->files().open({sample("buttons/B.button.json")});
      QTest::qWait(200);
      return again.window->findChild<QDockWidget*>("inspectorDock")->width();
    };
    QVERIFY(std::abs(widthAfter(wide_px) - wide_px) <= 2);
    for (const QVariant& broken : {QVariant(1000000), QVariant(-5), QVariant("wide")}) {
      const int width_px = widthAfter(broken);
      QVERIFY2(width_px > least_px && width_px < most_px, qPrintable(QString::number(width_px)));
    }
  }
  // A page that is looked at does not change where an unsaved button is proposed to be saved.
  void filesAreSavedWhereTheLastOneWasSaved() {
    Rig rig(folder_->path());
    for (const char* name : {"saved", "pages", "batch", "results"}) QVERIFY(QDir(at(".")).mkdir(at(name)));
    rig.action("new")->trigger();
    rig.prompts.saveAnswers = {at("saved/one.csv")};
    rig.action("exportCsv")->trigger();
    QVERIFY(QFile::copy(sample("buttons/B.button.json"), at("pages/b.button.json")));
    rig.window->files().open({at("pages/b.button.json")});
    rig.action("new")->trigger();
    rig.prompts.saveAnswers = {QString()};
    rig.action("save")->trigger();
    QCOMPARE(QFileInfo(rig.prompts.lastSuggested).absolutePath(), at("saved"));
    // The folders of the batch are kept, too.
    rig.action("importMany")->trigger();
    auto* batch = rig.window->findChild<QDialog*>("batchDialog");
    rig.prompts.saveAnswers = {at("batch"), QString()};
    for (const char* folder : {"pages", "batch"}) {
      batch->findChild<QPushButton*>("batchFolder")->click();
      QCOMPARE(rig.prompts.lastFolder, at(folder));
    }
    batch->close();
    // Pages are looked for where the last one was, not where something was saved since.
    rig.prompts.saveAnswers = {at("saved/two.csv")};
    rig.action("exportCsv")->trigger();
    rig.action("import")->trigger();
    QCOMPARE(rig.prompts.lastFolder, at("batch"));
  }

  void theTabsOfTheLastSessionComeBack() {
    const QString b = at("b.button.json"), c = at("c.button.json");
    QVERIFY(QFile::copy(sample("buttons/B.button.json"), b));
    QVERIFY(QFile::copy(sample("buttons/C.button.json"), c));
    {
      Rig rig(folder_->path());
      rig.window->files().open({b, c});
      rig.window->tabs().show(rig.window->tabs().withPath(b)->document());
      QVERIFY(rig.window->close());
    }
    {
      Rig rig(folder_->path());
      QVERIFY(rig.window->tabs().all().empty());  // opens only at the program's request
      rig.window->restoreSession();
      QCOMPARE(rig.window->tabs().all().size(), std::size_t(2));
      QCOMPARE(rig.document().path(), b);
      QVERIFY(rig.window->close());
    }
    QVERIFY(QFile::remove(c));
    Rig rig(folder_->path());
    rig.window->restoreSession();
    QCOMPARE(rig.window->tabs().all().size(), std::size_t(1));
    QVERIFY(rig.notices().isEmpty());
  }

  void printsGraphAndValues() {
    Rig rig(folder_->path());
    rig.window->files().open({sample("buttons/B.button.json")});
    rig.action("print")->trigger();  // cancelled
    rig.prompts.printedTo = at("paper.pdf");
    rig.action("print")->trigger();
    // The graph lies whole on the paper: it is read from there again.
    importer::ImportRequest request;
    request.path = at("paper.pdf").toStdString();
    const auto read = [&request] {
      return importer::ImportSession::open(request.path)->importGraph(request);
    };
    const auto light = read();
    QVERIFY2(light.ok(), light.ok() ? "" : "the printed graph is not found on its paper");
    QVERIFY(std::abs(light->button.states()[0].graph.travel_mm() - 4) < 0.02);
    rig.view.setAppearance(Appearance::dark);
    const GraphCanvas& canvas = rig.window->tabs().current()->workspace().canvas();
    QTRY_VERIFY(isDark(canvas.palette()));
    request.path = at("dark.pdf").toStdString();
    rig.prompts.printedTo = at("dark.pdf");
    rig.action("print")->trigger();
    const auto dark = read();  // paper is white; Qt outlines a text a hair differently each time
    QVERIFY(dark.ok());
    QVERIFY(std::abs(dark->confidence - light->confidence) < 0.05);
    QTRY_VERIFY(isDark(canvas.palette()));
  }

  // A note of a self-locking button is printed with its state.
  void printsNotesWithTheirState() {
    Rig rig(folder_->path());
    rig.window->files().open({sample("buttons/EF.button.json")});
    Annotations annotations;
    annotations.notes = {{0, Stroke::press, 1, "a grain"}, {1, Stroke::release, 1, "a scrape"}};
    rig.document().setAnnotations(annotations);
    rig.prompts.printedTo = at("notes.pdf");
    rig.action("print")->trigger();
    const auto document = importer::Document::open(at("notes.pdf").toStdString());
    QVERIFY(document.ok());
    const auto page = document->page(1);
    QVERIFY(page.ok());
    QStringList texts;
    for (const importer::TextBox& box : page->texts) texts << QString::fromStdString(box.utf8);
    const QString printed = texts.join(' ').simplified();
    QVERIFY2(printed.contains("unlocked: Press at 1 mm: a grain"), qPrintable(printed));
    QVERIFY2(printed.contains("locked: Release at 1 mm: a scrape"), qPrintable(printed));
  }

  // Sentences of classes that are no QObject too: the hints of all tools of the import, a refusal of the
  // model.
  void everySentenceIsFoundInGerman() {
    ViewSettings settings;
    ImportDialog dialog(settings);
    auto* view = dialog.findChild<PageView*>();
    QSignalSpy hints(view, &PageView::hint);
    const auto allHints = [&] {
      QStringList all;
      hints.clear();
      for (int kind = static_cast<int>(PageToolKind::pan); kind >= 0; --kind)
        view->setTool(static_cast<PageToolKind>(kind));
      for (const auto& hint : hints) all << hint.front().toString();
      return all;
    };
    const QStringList english = allHints();
    QVERIFY(english.size() >= 10);
    // A sentence names a choice as the window does, not by its word on the command line.
    const Message noRoom("no room for \"%1\"", Message::of(nameOf(playback::LevelQuantity::eventSize), {}));
    QCOMPARE(inWords(noRoom, settings.units()), QString("no room for \"strength of the click\""));
    QVERIFY(installTranslation(*qApp, QLocale("de_DE"), DETENT_TRANSLATIONS));
    const auto ended = qScopeGuard([] { qDeleteAll(qApp->findChildren<QTranslator*>()); });
    const QStringList german = allHints();
    QCOMPARE(german.size(), english.size());
    for (int i = 0; i < german.size(); ++i) QVERIFY2(german[i] != english[i], qPrintable(english[i]));
    Rig rig(folder_->path());
    rig.window->files().open({sample("buttons/B.button.json")});
    for (const QAction* action : rig.window->allActions())
      if (action->objectName().startsWith("tool")) QVERIFY(!action->toolTip().contains("Click"));
    QCOMPARE(inWords(Message("the file cannot be written: %1", "x"), settings.units()),
             QString("die Datei lässt sich nicht schreiben: x"));
    const auto inGerman = [&](const char* words) {
      return inWords(Message::of(words, {}), settings.units()) != QString::fromUtf8(words);
    };
    for (const auto& mode : playback::feedbackModes.all)
      if (mode.value != playback::FeedbackMode::off) QVERIFY2(inGerman(mode.word), mode.word);
    for (const auto& quantity : playback::levelQuantities.all)
      QVERIFY2(inGerman(quantity.word), quantity.word);
    for (const auto& listening : playback::listenings.all) QVERIFY2(inGerman(listening.word), listening.word);
    const auto device = playback::forceDeviceFrom("serial:");
    QVERIFY2(sentenceOf(device.failure(), settings.units())
                 .contains(QString::fromUtf8("seriellen Schnittstelle fehlt")),
             qPrintable(sentenceOf(device.failure(), settings.units())));
  }

  // Corrections in the import dialogue survive a kill; Escape asks before it throws them away.
  void correctionsOfAnImportAreWork() {
    const QString sheet = sample("plots/white-vector.pdf");
    Corrections given;
    given.yUnit = ForceUnit::gramForce;
    given.masks = {{1, 2, 3, 4}};
    given.drawn.press = {{1.5, 2.5}, {3, 4}};
    {
      const ImportDraft draft{sheet, {}, importer::Quality::draft, GraphId{1, 1}, {{{1, 1}, given, false}}};
      QVERIFY(draftFrom(textOf(draft)) == draft);
      RecoveryStore dead(at("recovery"));
      dead.keepImport(textOf(draft));
      dead.flush();
      // The destructor releases the lock and leaves the file, as a killed program does.
    }
    Rig rig(folder_->path());
    rig.window->files().offerRecovery();
    QVERIFY(rig.notices().join(' ').contains("white-vector.pdf"));
    rig.press("continueImport");
    auto* dialog = rig.window->findChild<ImportDialog*>();
    QVERIFY(dialog && dialog->isVisible());
    QVERIFY(dialog->draft().graphs.size() == 1);
    auto* view = dialog->findChild<PageView*>();
    QTRY_VERIFY_WITH_TIMEOUT(view->state().current() && view->state().current()->history.now() == given,
                             60000);
    QVERIFY(view->state().current()->history.canUndo());
    // The recovered import is stored by this editor now.
    QVERIFY(!QDir(at("recovery")).entryList({"*"}, QDir::Dirs | QDir::NoDotAndDotDot).isEmpty());
    rig.prompts.confirmAnswers.push_back(false);
    dialog->reject();
    QVERIFY(dialog->isVisible());
    rig.prompts.confirmAnswers.push_back(true);
    dialog->reject();
    QVERIFY(!dialog->isVisible());
    rig.recovery.flush();
    RecoveryStore next(at("recovery"));
    next.leftBehind();
    QVERIFY(next.leftImports().isEmpty());
  }

  void unitsAndAppearanceAreKept() {
    {
      Rig rig(folder_->path());
      rig.action("unit_force_gf")->trigger();
      rig.action("unit_length_in")->trigger();
      rig.view.setAppearance(Appearance::dark);
      QVERIFY(isDark(QApplication::palette()));
      rig.window->findChild<QDockWidget*>("libraryDock")->show();
      rig.action("libraryDockToggle")->trigger();
      QVERIFY(rig.window->close());
    }
    Rig rig(folder_->path());
    QVERIFY(rig.view.units() == (DisplayUnits{LengthUnit::inch, ForceUnit::gramForce}));
    QVERIFY(rig.action("unit_force_gf")->isChecked());
    QCOMPARE(rig.view.appearance(), Appearance::dark);
    QVERIFY(!rig.window->findChild<QDockWidget*>("libraryDock")->isVisible());
    rig.view.setAppearance(Appearance::light);
    QVERIFY(!isDark(QApplication::palette()));
  }

  void storedNonsenseIsIgnored() {
    QSettings settings(at("odd.ini"), QSettings::IniFormat);
    settings.setValue("view/forceUnit", "bananas");
    settings.setValue("snap/gridForce_N", "nan");
    settings.setValue("snap/gridLength_mm", -3);
    settings.setValue("view/underlayOpacity", 17);
    ViewSettings view;
    restoreView(view, settings);
    QVERIFY(view.units() == DisplayUnits{});
    QVERIFY(view.snap() == SnapSettings{});
    QCOMPARE(view.underlayOpacity(), ViewSettings().underlayOpacity());
  }

  void textCanBeReadOnEveryBackground() {
    for (const QPalette& palette : {lightPalette(), darkPalette()}) {
      for (const auto& [text, background] :
           {std::pair(QPalette::WindowText, QPalette::Window), std::pair(QPalette::Text, QPalette::Base),
            std::pair(QPalette::Text, QPalette::AlternateBase),
            std::pair(QPalette::ButtonText, QPalette::Button),
            std::pair(QPalette::HighlightedText, QPalette::Highlight),
            std::pair(QPalette::Link, QPalette::Base),
            std::pair(QPalette::ToolTipText, QPalette::ToolTipBase)})
        QVERIFY2(contrast(palette.color(text), palette.color(background)) >= 4.5,
                 qPrintable(QString("role %1 on %2").arg(text).arg(background)));
    }
  }

  // Visible contrast of every label, button and field of every window, light and dark: the background is the
  // most frequent colour.
  void everyTextCanBeRead() {
    Rig rig(folder_->path());
    rig.window->resize(1500, 950);
    for (const char* name : {"buttons/B.button.json", "buttons/E.button.json"})
      rig.window->files().open({sample(name)});
    rig.action("feel")->trigger();
    rig.window->findChild<QToolButton*>("setupToggle")->click();
    for (const char* appearance : {"light", "dark"}) {
      rig.view.setAppearance(*appearance == 'd' ? Appearance::dark : Appearance::light);
      rig.action("compare")->trigger();
      QTest::qWait(50);
      collectCutTexts(*rig.window, appearance);
      for (QWidget* setup : {static_cast<QWidget*>(rig.window->findChild<FeelSetup*>()),
                             static_cast<QWidget*>(rig.window->findChild<ForceSetup*>())})
        collectCutTexts(*setup, QString(appearance) + ' ' + setup->metaObject()->className());
      for (const char* name :
           {"operationScaleForce", "forecasts", "study", "preferences", "glossary", "importMany"}) {
        rig.action(name)->trigger();
        const auto opened = windowsBeside(rig);
        QVERIFY2(opened.size() == 1, name);
        collectCutTexts(*opened.front(), QString(appearance) + ' ' + name);
        opened.front()->close();
      }
      ImportDialog import(rig.view);
      import.show();
      import.openFile(sample("plots/black-red-curves.png"));
      QTRY_VERIFY_WITH_TIMEOUT(import.findChild<QPushButton*>("import")->isEnabled(), 60000);
      collectCutTexts(import, QString(appearance) + " import");
    }
  }

  // Fields, boxes and buttons are seen by their outlines, light and dark, with and without the focus.
  void outlinesCanBeSeen() {
    for (const QPalette& palette : {lightPalette(), darkPalette()}) {
      QWidget window;
      window.setPalette(palette);
      auto* column = new QVBoxLayout(&window);
      const std::initializer_list<QWidget*> controls = {
          new QLineEdit, new QCheckBox,        new QRadioButton,           new QComboBox,
          new QSpinBox,  new QPushButton("x"), new QSlider(Qt::Horizontal)};
      for (QWidget* control : controls) column->addWidget(control);
      window.show();
      for (QWidget* focused : controls) {
        focused->setFocus();
        const QImage seen = window.grab().toImage();
        for (QWidget* control : controls) {
          const QRect place(control->mapTo(&window, QPoint()), control->size());
          const double found = outlineContrast(seen, place, palette.color(QPalette::Window));
          QVERIFY2(found >= 3,
                   qPrintable(QString("%1 %2: %3")
                                  .arg(isDark(palette) ? "dark" : "light", control->metaObject()->className())
                                  .arg(found)));
        }
      }
    }
  }

  // The handle of a scroll bar stands out from its groove, also while it is held.
  void handlesOfScrollBarsCanBeSeen() {
    for (const QPalette& palette : {lightPalette(), darkPalette()})
      for (const Qt::Orientation way : {Qt::Vertical, Qt::Horizontal})
        for (const bool held : {false, true}) {
          QScrollBar bar(way);
          bar.setPalette(palette);
          bar.setRange(0, 300);
          bar.setPageStep(100);
          const QSize hint = bar.sizeHint();
          bar.resize(way == Qt::Vertical ? QSize(hint.width(), 400) : QSize(400, hint.height()));
          bar.setSliderDown(held);
          QStyleOptionSlider option;
          option.initFrom(&bar);
          option.orientation = way;
          option.maximum = 300;
          option.pageStep = 100;
          const auto middle = [&](QStyle::SubControl part) {
            return bar.style()->subControlRect(QStyle::CC_ScrollBar, &option, part, &bar).center();
          };
          const QImage seen = bar.grab().toImage();
          const double found = contrast(seen.pixelColor(middle(QStyle::SC_ScrollBarSlider)),
                                        seen.pixelColor(middle(QStyle::SC_ScrollBarAddPage)));
          QVERIFY2(found >= 3, qPrintable(QString("%1 %2 %3: %4")
                                              .arg(isDark(palette) ? "dark" : "light")
                                              .arg(way)
                                              .arg(held ? "held" : "free")
                                              .arg(found)));
        }
  }

  // The same stroke has the same colour in the window, in its SVG and in a comparison.
  void oneColourCodeInWindowSvgAndComparison() {
    Rig rig(folder_->path());
    rig.view.setAppearance(Appearance::light);
    rig.window->files().open({sample("buttons/C.button.json"), sample("buttons/B.button.json")});
    const GraphColors colors = graphColors(false);
    QTRY_COMPARE(rig.window->tabs().current()->workspace().canvas().colors().press, colors.press);
    rig.prompts.saveAnswers.push_back(at("b.svg"));
    rig.prompts.graphAnswers = {GraphExport{}};
    rig.action("exportGraph")->trigger();
    QFile file(at("b.svg"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray svg = file.readAll();
    for (const QColor& color : {colors.press, colors.release}) QVERIFY(svg.contains(color.name().toUtf8()));
    rig.action("compare")->trigger();
    auto* plot = rig.window->findChild<ComparePanel*>()->findChild<QCustomPlot*>("comparePlot");
    QVERIFY(plot);
    QCOMPARE(plot->plottable(0)->pen().color(), colors.press);
    for (int i = 0; i < plot->plottableCount(); ++i)
      // the release's colour means a stroke, so no plot may have it
      QVERIFY(plot->plottable(i)->pen().color() != colors.release);
  }

  // A second button's inspector is laid out while it is hidden; its table has room for the names even so.
  void namesOfKeyFiguresStandInTheirColumn() {
    Rig rig(folder_->path());
    rig.window->resize(1280, 720);
    for (const char* name : {"B", "C", "E"}) {
      rig.window->files().open({sample("buttons/") + name + ".button.json"});
      int shown = 0;
      for (auto* panel : rig.window->findChildren<KeyFiguresPanel*>()) {
        if (!panel->isVisible()) continue;
        ++shown;
        auto* table = panel->findChild<QTableView*>();
        QTRY_VERIFY2(table->verticalHeader()->isHidden(), name);
        QTRY_VERIFY2(!table->isColumnHidden(KeyFiguresModel::figure), name);
      }
      QCOMPARE(shown, 1);
    }
  }

  void tabsOfOneTitleAreDistinguished() {
    Rig rig(folder_->path());
    rig.window->files().open({sample("buttons/C.button.json")});
    rig.action("duplicate")->trigger();
    auto* bar = rig.window->findChild<QTabBar*>("tabBar");
    const QString title = bar->tabText(1);
    QVERIFY2(title.endsWith(" *") && !title.contains("not saved"), qPrintable(title));
    rig.action("duplicate")->trigger();
    QCOMPARE(bar->tabText(0), QString("C"));
    for (int copy = 1; copy <= 2; ++copy)
      QCOMPARE(bar->tabText(copy), QString("%1 (not saved, %2) *").arg(title.chopped(2)).arg(copy));
    rig.window->tabs().remove(*rig.window->tabs().all()[1]);
    QCOMPARE(bar->tabText(1), title);
  }

  void chosenPairOfAComparisonIsKept() {
    Rig rig(folder_->path());
    rig.window->files().open(
        {sample("buttons/B.button.json"), sample("buttons/C.button.json"), sample("buttons/D.button.json")});
    rig.action("compare")->trigger();
    auto* panel = rig.window->findChild<ComparePanel*>();
    const auto choice = [&](const char* name) { return panel->findChild<QComboBox*>(name); };
    for (const auto& [name, index] : {std::pair{"compareButtonA", 1}, std::pair{"compareButtonB", 0}}) {
      choice(name)->setCurrentIndex(index);
      emit choice(name)->activated(index);
    }
    const QString first = choice("compareButtonA")->currentText(),
                  second = choice("compareButtonB")->currentText();
    for (const char* view : {"edit", "feel"}) {  // the shown button, D, is not one of the two
      rig.action(view)->trigger();
      rig.action("compare")->trigger();
      QCOMPARE(choice("compareButtonA")->currentText(), first);
      QCOMPARE(choice("compareButtonB")->currentText(), second);
    }
  }

  // The desktop turns dark and light again while the editor runs: the texts of every open window stay
  // readable.
  void theDesktopsChangeOfThemeIsFollowed() {
    bool dark = false;
    Rig rig(folder_->path(), [&dark] { return dark ? darkPalette() : lightPalette(); });
    rig.view.setAppearance(Appearance::system);
    rig.window->files().open({sample("buttons/B.button.json"), sample("buttons/E.button.json")});
    rig.action("feel")->trigger();
    rig.action("compare")->trigger();
    rig.action("study")->trigger();
    const GraphCanvas& canvas = rig.window->tabs().current()->workspace().canvas();
    for (const bool now : {true, false, true}) {
      dark = now;
      QEvent change(QEvent::ThemeChange);
      QApplication::sendEvent(rig.window.get(), &change);
      QCoreApplication::processEvents();
      QCOMPARE(isDark(QApplication::palette()), dark);
      QCOMPARE(isDark(canvas.palette()), dark);
      const auto backgroundIsDark = [&rig] {  // beside all axes and their names
        const QImage picture = rig.window->tabs().current()->workspace().canvas().grab().toImage();
        return picture.pixelColor(2, 2).lightness() < 128;
      };
      QTRY_COMPARE(backgroundIsDark(), dark);
      collectCutTexts(*rig.window, dark ? "desktop turned dark" : "desktop turned light");
      for (const QPointer<QWidget>& window : windowsBeside(rig))
        collectCutTexts(*window,
                        (dark ? "desktop turned dark " : "desktop turned light ") + window->objectName());
    }
    // A choice by hand is not overruled by the desktop.
    rig.view.setAppearance(Appearance::light);
    QEvent change(QEvent::ThemeChange);
    QApplication::sendEvent(rig.window.get(), &change);
    QVERIFY(!isDark(QApplication::palette()));
  }

  void noticesCanBeReadOnTheirBackground() {
    Rig rig(folder_->path());
    for (const char* appearance : {"dark", "light", "dark"}) {
      rig.view.setAppearance(*appearance == 'd' ? Appearance::dark : Appearance::light);
      rig.window->notices().say("a", NoticeBar::Kind::trouble, "Trouble");
      rig.window->notices().say("b", NoticeBar::Kind::information, "Information");
      QCoreApplication::processEvents();
      for (const auto* label : rig.window->notices().findChildren<QLabel*>("noticeText"))
        QVERIFY2(!label->isVisible() ||  // one that was replaced
                     contrast(label->palette().color(QPalette::WindowText),
                              label->parentWidget()->palette().color(QPalette::Window)) >= 4.5,
                 qPrintable(QString(appearance) + ": " + label->text()));
    }
  }

  // The graph has most of the window.
  void theGraphOwnsTheWindow() {
    Rig rig(folder_->path());
    rig.window->resize(1366, 768);
    QTest::qWait(60);
    for (const char* name : {"A", "B", "C", "D"})
      rig.window->files().open({sample(qPrintable(QString("buttons/%1.button.json").arg(name)))});
    QTest::qWait(100);
    const auto share = [&rig](const QWidget& graph) {
      return double(graph.width()) * graph.height() / (double(rig.window->width()) * rig.window->height());
    };
    const QWidget& canvas = rig.window->tabs().current()->workspace().canvas();
    QTRY_VERIFY2(share(canvas) >= 0.65, qPrintable(QString::number(share(canvas))));
    rig.window->compareAll(rig.window->tabs().documents());
    QTest::qWait(100);
    const auto* plot = rig.window->findChild<QWidget*>("comparePlot");
    QTRY_VERIFY(plot->isVisible());
    QTRY_VERIFY2(share(*plot) >= 0.60, qPrintable(QString::number(share(*plot))));
    qInfo("graph while editing %.3f, while comparing four %.3f of the window", share(canvas), share(*plot));
    rig.action("edit")->trigger();
    QTest::qWait(50);
    QTRY_VERIFY(canvas.isVisible() && share(canvas) >= 0.65);
    // The numbers of the selected point stand beside the graph.
    auto* table = rig.window->tabs().current()->inspector()->findChild<QTableView*>("selectionTable");
    QVERIFY(!table->isVisible());  // nothing is selected
    rig.window->tabs().current()->workspace().canvas().setSelected(
        MarkId{MarkKind::tactilePoint, Stroke::press, 0});
    QVERIFY(table->isVisible());
    const auto peak = tactilePoints(rig.document().graph().press(), Stroke::press).front();
    QCOMPARE(table->model()->index(ValuesModel::displacement, 0).data(Qt::EditRole).toDouble(),
             peak.displacement_mm);
    QVERIFY(table->model()->setData(table->model()->index(ValuesModel::force, 0), "75 cN", Qt::EditRole));
    QVERIFY(std::abs(tactilePoints(rig.document().graph().press(), Stroke::press).front().force_N - 0.75) <
            1e-9);
  }

  // Enter on a point opens its numbers in the inspector; another Enter makes one step and goes back to the
  // graph.
  void numbersOfAPointAreTypedInTheInspector() {
    Rig rig(folder_->path());
    rig.window->files().open({sample("buttons/B.button.json")});
    rig.window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(rig.window.get()));
    rig.window->findChild<QDockWidget*>("inspectorDock")->hide();
    GraphCanvas& canvas = rig.window->tabs().current()->workspace().canvas();
    const auto type = [&](Qt::Key opens, const QString& text, Qt::Key ends) {
      QTest::keyClick(&canvas, opens);
      auto* editor = rig.window->findChild<QLineEdit*>("valueEditor");
      QTRY_VERIFY(editor && editor->isVisible() && editor->hasFocus());
      editor->selectAll();
      QTest::keyClicks(editor, text);
      QTest::keyClick(editor, ends);
      QTest::qWait(20);
    };
    const auto peak = [&] { return tactilePoints(rig.document().graph().press(), Stroke::press).front(); };
    const auto steps = [&] { return rig.document().history().stack().count(); };
    canvas.setFocus();
    QTest::keyClick(&canvas, Qt::Key_Return);
    QVERIFY(!rig.window->findChild<QLineEdit*>("valueEditor"));  // nothing is selected
    canvas.setSelected(MarkId{MarkKind::tactilePoint, Stroke::press, 0});
    type(Qt::Key_Return, "1.4 mm", Qt::Key_Return);
    QCOMPARE(peak().displacement_mm, 1.4);
    QCOMPARE(steps(), 1);
    QTRY_VERIFY(canvas.hasFocus());
    type(Qt::Key_F2, "60 gf", Qt::Key_Return);
    QVERIFY(std::abs(peak().force_N - 60 * 0.00980665) < 1e-9);
    QCOMPARE(steps(), 2);
    const Button kept = rig.document().button();
    type(Qt::Key_F2, "70", Qt::Key_Escape);
    QVERIFY(rig.document().button() == kept);
    QTRY_VERIFY(canvas.hasFocus());
    // A refused number stays open, with its reason.
    type(Qt::Key_Return, "3.9", Qt::Key_Return);
    auto* editor = rig.window->findChild<QLineEdit*>("valueEditor");
    QVERIFY(editor && editor->isVisible());
    auto* trouble = rig.window->findChild<QLabel*>("selectionTrouble");
    QVERIFY(!trouble->text().isEmpty());
    for (const Appearance theme : {Appearance::dark, Appearance::light}) {
      rig.view.setAppearance(theme);
      QCoreApplication::processEvents();
      QCOMPARE(trouble->palette().color(QPalette::WindowText),
               graphColors(theme == Appearance::dark).refused);
    }
    rig.view.setAppearance(Appearance::system);
    QVERIFY(editor->isVisible());
    QTest::keyClick(editor, Qt::Key_Escape);
    QVERIFY(rig.document().button() == kept);
  }

  // Another button's curves lie behind the edited ones, and in no picture that is exported.
  void aReferenceStandsBehindTheCurve() {
    Rig rig(folder_->path());
    rig.window->files().open({sample("buttons/C.button.json"), sample("buttons/B.button.json")});
    GraphCanvas& canvas = rig.window->tabs().current()->workspace().canvas();
    auto* menu = rig.window->findChild<QMenu*>("referenceMenu");
    const auto choose = [&](const QString& text) {
      emit menu->aboutToShow();
      for (QAction* entry : menu->actions())
        if (entry->text() == text) return entry->trigger();
      QFAIL(qPrintable(text));
    };
    const QImage plain = canvas.grab().toImage(), exported = canvas.renderImage({900, 600}, 1);
    choose("C");
    QVERIFY(canvas.reference() && canvas.reference()->name == "C");
    QVERIFY(!(canvas.grab().toImage() == plain));
    QVERIFY(canvas.renderImage({900, 600}, 1) == exported);
    emit menu->aboutToShow();
    for (const QAction* entry : menu->actions()) QCOMPARE(entry->isChecked(), entry->text() == "C");
    choose("This button as it is &now");
    rig.scale(1.5);
    QVERIFY(canvas.reference()->state.graph.press().force_N(1) <
            0.7 * rig.document().graph().press().force_N(1));
    choose("&None");
    QVERIFY(!canvas.reference());
  }

  void ownPictureOpensAsItsButton() {
    const QString file = at("own.png"), plain = at("plain.png");
    {
      Rig rig(folder_->path());
      rig.window->files().open({sample("buttons/B.button.json")});
      rig.prompts.saveAnswers.push_back(file);
      rig.action("exportPng")->trigger();
      QVERIFY(QImage(file).width() == 2400);
      QVERIFY(rig.window->close());
    }
    Rig rig(folder_->path());
    rig.window->files().open({file});
    QVERIFY(rig.window->tabs().current());
    const auto original = readButtonFile(sample("buttons/B.button.json").toStdString());
    QVERIFY(rig.document().button().states() == original->states());
    QVERIFY(rig.document().path().isEmpty());  // saving does not write over the picture
  }

  void keyFiguresAreCopiedAsATable() {
    Rig rig(folder_->path());
    rig.window->files().open({sample("buttons/B.button.json")});
    rig.action("copyFigures")->trigger();
    const QString table = QApplication::clipboard()->text();
    QVERIFY2(table.contains("Peak force\t55\tcN\n"), qPrintable(table));
    QVERIFY2(table.contains("Pre-travel\t2\tmm\n"), qPrintable(table));
  }

  // A button that was read from a page in gf is shown in gf, until the user chooses a unit.
  void theUnitsOfThePageStayUntilOthersAreChosen() {
    Rig rig(folder_->path());
    const auto read = readButtonFile(sample("buttons/B.button.json").toStdString());
    QVERIFY(read.ok());
    Provenance from;
    from.xAxis = AxisProvenance{"mm", 0, 4, 0.3, DecidedBy::found};
    from.yAxis = AxisProvenance{"gf", 0, 120, 0.3, DecidedBy::found};
    const auto ofPage = Button::fromStates("in gf", read->states(), from);
    QVERIFY(ofPage.ok());
    const auto shown = [&] { return rig.window->findChild<QToolButton*>("unitButton")->text(); };
    QCOMPARE(shown(), QString("mm, cN"));
    DocumentTab& inGf = rig.window->tabs().add(std::make_unique<ButtonDocument>(*ofPage));
    QCOMPARE(shown(), QString("mm, gf"));
    rig.window->files().open({sample("buttons/C.button.json")});
    QCOMPARE(shown(), QString("mm, cN"));
    rig.window->tabs().show(inGf.document());
    QCOMPARE(shown(), QString("mm, gf"));
    storeView(rig.view, rig.settings);  // units that nobody chose are not chosen for the next run
    ViewSettings next;
    restoreView(next, rig.settings);
    QVERIFY(!next.unitsChosen());
    rig.action("unit_force_N")->trigger();
    QCOMPARE(shown(), QString("mm, N"));
    rig.window->tabs().show(rig.window->tabs().all()[1]->document());
    QCOMPARE(shown(), QString("mm, N"));
    storeView(rig.view, rig.settings);
    restoreView(next, rig.settings);
    QVERIFY(next.unitsChosen() && next.units().force == ForceUnit::newton);
    rig.window->tabs().show(inGf.document());
    rig.action("unitsOfPage")->trigger();
    QCOMPARE(shown(), QString("mm, gf"));
  }

  void theTableOfValuesShowsAllItsColumns() {
    for (const char* name : {"B", "EF"}) {
      Rig rig(folder_->path());
      rig.window->resize(1366, 768);
      rig.window->files().open({sample("buttons/") + name + ".button.json"});
      QTest::qWait(50);
      rig.action("valuesDockToggle")->trigger();
      QTest::qWait(50);
      savePicture(*rig.window, QString("values-%1").arg(name));
      const QHeaderView& heads =
          *rig.window->findChild<ValuesPanel*>()->findChild<QTableView*>()->horizontalHeader();
      QVERIFY2(heads.length() <= heads.viewport()->width(),
               qPrintable(QString("%1 of %2 px").arg(heads.viewport()->width()).arg(heads.length())));
    }
  }

  // A dialogue beside the graph opens on the screen, wherever the window is.
  void dialoguesBesideTheGraphOpenOnTheScreen() {
    Rig rig(folder_->path());
    rig.window->files().open({sample("buttons/B.button.json")});
    const QRect screen = rig.window->screen()->availableGeometry();
    rig.window->resize(screen.size());
    for (const QPoint& place : {screen.topLeft(), screen.bottomRight() - QPoint(200, 150),
                                QPoint(screen.left() - rig.window->width() + 50, screen.top() - 300)}) {
      rig.window->move(place);
      QTest::qWait(20);
      rig.action("operationContacts")->trigger();
      auto* dialog = rig.window->findChild<OperationDialog*>();
      QVERIFY(dialog && dialog->isVisible());
      QVERIFY2(screen.contains(QRect(dialog->pos(), dialog->size() + QSize(8, 40))),
               qPrintable(QString("%1, %2").arg(dialog->x()).arg(dialog->y())));
      dialog->reject();
      QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
  }

  // The dialogue names the units of the columns: first those of the window, then mm and N as in every file.
  void samplesAreWrittenInTheUnitsThatAreChosen() {
    Rig rig(folder_->path());
    rig.view.setUnits({LengthUnit::micrometre, ForceUnit::gramForce});
    rig.window->files().open({sample("buttons/B.button.json")});
    for (const auto& [action, filter, header, first] :
         {std::tuple{"exportCsv", 0, "stroke,displacement_µm,force_gf", "press,0,32.630918"},
          {"exportCsv", 1, "stroke,displacement_mm,force_N", "press,0,0.32"},
          {"exportSemicolonCsv", 0, "stroke;displacement_µm;force_gf", "press;0;32,630918"},
          {"exportSemicolonCsv", 1, "stroke;displacement_mm;force_N", "press;0;0,32"},
          {"exportCsvAt", 0, "stroke,displacement_µm,force_gf", "press,0,32.630918"}}) {
      rig.prompts.textAnswers = {QString("0.5 mm")};
      rig.prompts.saveAnswers = {at("units.csv")};
      rig.prompts.filterAnswer = filter;
      rig.action(action)->trigger();
      const QStringList filters = rig.prompts.lastFilter.split(";;");
      QCOMPARE(filters.size(), 2);
      QVERIFY2(filters[0].contains("µm and gf") && filters[1].contains("mm and N"),
               qPrintable(rig.prompts.lastFilter));
      QFile written(at("units.csv"));
      QVERIFY(written.open(QIODevice::ReadOnly));
      const QStringList lines = QString::fromUtf8(written.readAll()).split('\n');
      QCOMPARE(lines[0], QString::fromUtf8(header));
      QVERIFY2(lines[1].startsWith(QLatin1String(first)), qPrintable(lines[1]));
    }
    rig.view.setUnits(modelUnits);
    rig.prompts.saveAnswers = {at("units.csv")};
    rig.prompts.filterAnswer = 0;
    rig.action("exportCsv")->trigger();
    QVERIFY2(rig.prompts.lastFilter.contains("mm and N") && !rig.prompts.lastFilter.contains(";;"),
             qPrintable(rig.prompts.lastFilter));
  }

  void samplesAreWrittenAtGivenTravels() {
    Rig rig(folder_->path());
    rig.view.setUnits(modelUnits);
    rig.window->files().open({sample("buttons/B.button.json")});
    const auto exported = [&](const QString& typed, const char* name) {
      rig.prompts.textAnswers.push_back(typed);
      rig.prompts.saveAnswers.push_back(at(name));
      rig.action("exportCsvAt")->trigger();
      QFile written(at(name));
      return written.open(QIODevice::ReadOnly) ? QString::fromUtf8(written.readAll()).split('\n')
                                               : QStringList();
    };
    const QStringList steps = exported("0.5 mm", "steps.csv");
    QCOMPARE(steps.size(), 1 + 10 + 10 + 1);  // both ends of each bottom-out
    QCOMPARE(steps[1], QString("press,0,0.32"));
    QCOMPARE(steps.mid(9, 3), QStringList({"press,4,0.6", "press,4,1.15", "release,4,1.15"}));
    for (const char* given : {"1.25 1.75", "1.25 mm 1.75 mm", "1.25;1.75", " 1.25 mm; 1.75 "})
      QCOMPARE(exported(given, "given.csv").mid(1, 2), QStringList({"press,1.25,0.55", "press,1.75,0.42"}));
    for (const char* wrong : {"0", "-1", "9 1", "two", "", "0.0000001"}) {
      QVERIFY2(exported(wrong, "wrong.csv").isEmpty(), wrong);
      QVERIFY2(!rig.notices().join(' ').contains(".."), qPrintable(rig.notices().join(' ')));
    }
  }

  // Ticks depend on the size of the graph alone, not on the one it had in another view.
  void ticksStayAfterAComparison() {
    Rig rig(folder_->path());
    rig.window->resize(1366, 768);
    rig.window->files().open({sample("buttons/C.button.json"), sample("buttons/B.button.json")});
    const GraphCanvas& canvas = rig.window->tabs().current()->workspace().canvas();
    QTest::qWait(100);
    const QVector<double> x = canvas.xAxis->tickVector(), y = canvas.yAxis->tickVector();
    const QSize size = canvas.size();
    rig.action("compare")->trigger();
    QTest::qWait(100);
    rig.action("edit")->trigger();
    QTest::qWait(100);
    QCOMPARE(canvas.size(), size);
    QCOMPARE(canvas.xAxis->tickVector(), x);
    QCOMPARE(canvas.yAxis->tickVector(), y);
  }

  // In a window of 1366 x 768, whatever the number of buttons; with many the numbers scroll.
  void namesOfAComparisonAreReadWhole() {
    Rig rig(folder_->path());
    rig.window->resize(1366, 768);
    rig.window->files().open({sample("buttons/B.button.json"), sample("buttons/E.button.json")});
    rig.action("compare")->trigger();
    auto* panel = rig.window->findChild<ComparePanel*>();
    auto* table = panel->findChild<QTableWidget*>("compareTable");
    for (int buttons = 2; buttons <= static_cast<int>(ComparePanel::mostSides); ++buttons) {
      QTest::qWait(50);
      savePicture(*rig.window, QString("compare-%1").arg(buttons));
      const QHeaderView& names = *table->verticalHeader();
      const int room_px = names.isVisible()
                              ? names.width() - 2 * names.style()->pixelMetric(QStyle::PM_HeaderMargin)
                              : table->columnWidth(0) - 6;
      for (int row = 0; row < table->rowCount(); ++row) {
        const QString name = table->item(row, 0)->text();
        QVERIFY2(table->fontMetrics().horizontalAdvance(name) <= room_px,
                 qPrintable(QString("%1 buttons, %2 px: %3").arg(buttons).arg(room_px).arg(name)));
      }
      if (buttons <= 3) QVERIFY2(names.isHidden(), qPrintable(QString::number(buttons)));
      panel->findChild<QPushButton*>("compareAdd")->click();
    }
  }

  // One open button: the comparison says what it needs, and the second button joins it.
  void aComparisonOfOneButtonLeadsToASecondOne() {
    Rig rig(folder_->path());
    rig.window->resize(1366, 768);
    rig.window->files().open({sample("buttons/B.button.json")});
    rig.action("compare")->trigger();
    auto* panel = rig.window->findChild<ComparePanel*>();
    const auto visible = [&](const char* name) { return panel->findChild<QWidget*>(name)->isVisible(); };
    QTest::qWait(50);
    savePicture(*rig.window, "compare-alone");
    QVERIFY(visible("compareAlone") && !visible("compareTable"));
    QVERIFY(panel->findChild<QLabel*>("compareWhat")->text().contains("second button"));
    for (const char* way : {"compare_open", "compare_new", "compare_measured"}) QVERIFY2(visible(way), way);
    QVERIFY(!panel->findChild<QPushButton*>("compare_reference"));
    rig.prompts.openAnswers = {{sample("buttons/C.button.json")}};
    panel->findChild<QPushButton*>("compare_open")->click();
    QTest::qWait(50);
    QVERIFY(panel->isVisible() && visible("compareTable") && !visible("compareAlone"));
    QCOMPARE(rig.window->tabs().current(), rig.window->tabs().all()[0]);  // the one edited before
    const auto choice = [&](const char* name) { return panel->findChild<QComboBox*>(name)->currentText(); };
    QCOMPARE(choice("compareButtonA"), rig.window->tabs().all()[0]->document().title());
    QCOMPARE(choice("compareButtonB"), rig.window->tabs().all()[1]->document().title());

    // A reference curve that stands behind the button is one of the ways.
    rig.window->tabs().remove(*rig.window->tabs().all()[1]);
    GraphCanvas& canvas = rig.window->tabs().current()->workspace().canvas();
    canvas.showReference(Reference{canvas.state(), "as measured"});
    rig.action("edit")->trigger();
    rig.action("compare")->trigger();
    panel->findChild<QPushButton*>("compare_reference")->click();
    QVERIFY(visible("compareTable"));
    QCOMPARE(choice("compareButtonB"), QString("as measured"));
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    // The two states of one button are a comparison.
    for (DocumentTab* tab : rig.window->tabs().all()) rig.window->tabs().remove(*tab);
    rig.window->files().open({sample("buttons/latch.button.json")});
    rig.action("compare")->trigger();
    QVERIFY(visible("compareTable"));
  }

  void comparesTheOpenOnes() {
    Rig rig(folder_->path());
    rig.window->files().open({sample("buttons/B.button.json"), sample("buttons/C.button.json")});
    rig.action("compare")->trigger();
    auto* dialog = rig.window->findChild<ComparePanel*>();
    QVERIFY(dialog && dialog->isVisible());
    QVERIFY(dialog->tableText().count('\n') > 8);
    QVERIFY(rig.window->findChild<QScrollArea*>("compareArea")->isAncestorOf(dialog));
    const QImage before = dialog->findChild<QCustomPlot*>("comparePlot")->grab().toImage();
    for (const char* ending : {"svg", "pdf", "png"}) {
      rig.prompts.saveAnswers.push_back(at(QString("comparison.") + ending));
      dialog->findChild<QToolButton*>("comparePicture")->click();
      QVERIFY(QFileInfo(at(QString("comparison.") + ending)).size() > 1000);
    }
    QVERIFY(dialog->findChild<QCustomPlot*>("comparePlot")->grab().toImage() == before);
    rig.window->tabs().remove(*rig.window->tabs().all()[0]);
    rig.window->tabs().remove(*rig.window->tabs().all()[0]);
    QVERIFY(dialog->tableText().count('\n') <= 1);
  }

  void feelPanelIsMadeWhenSeen() {
    Rig rig(folder_->path());
    rig.window->files().open({sample("buttons/B.button.json"), sample("buttons/C.button.json")});
    QVERIFY(!rig.window->findChild<QWidget*>("feelOther"));
    rig.action("feel")->trigger();
    QTRY_VERIFY(rig.window->findChild<QWidget*>("feelOther"));
    QCOMPARE(rig.window->findChild<QComboBox*>("feelOther")->currentText(), QString("B"));  // shown before C
    rig.window->tabs().showNext(1);
    QCOMPARE(rig.window->findChild<QComboBox*>("feelOther")->currentText(), QString("C"));
    rig.window->tabs().remove(*rig.window->tabs().all()[0]);
    rig.window->tabs().remove(*rig.window->tabs().all()[0]);
  }

  void geometryIsReportedByName() {
    Rig rig(folder_->path());
    rig.window->files().open({sample("buttons/B.button.json")});
    QCoreApplication::processEvents();
    const QJsonObject report = QJsonDocument::fromJson(geometryJson()).object();
    QSet<QString> names;
    for (const auto& widget : report["widgets"].toArray()) names << widget.toObject()["name"].toString();
    for (const char* name : {"mainWindow", "tabBar", "cursorPosition", "unitButton", "keyFiguresTable"})
      QVERIFY2(names.contains(name), name);
    new GeometryReport(at("geometry.json"), rig.window.get());
    QTRY_VERIFY(QFile::exists(at("geometry.json")));
    // A report that stays old is one of a program that is busy.
    const QDateTime first = QFileInfo(at("geometry.json")).lastModified();
    QTRY_VERIFY(QFileInfo(at("geometry.json")).lastModified() > first);
    QTRY_VERIFY(reportedWindow("mainWindow")["exposed"].toBool());
  }

 private:
  static QJsonObject reportedWindow(const QString& name) {
    for (const auto& window : QJsonDocument::fromJson(geometryJson()).object()["windows"].toArray())
      if (window.toObject()["name"].toString() == name) return window.toObject();
    return {};
  }
  QString at(const QString& name) const { return folder_->filePath(name); }
  std::unique_ptr<QTemporaryDir> folder_;
};

DETENT_WINDOW_TEST(WindowTest, [] {
  QApplication::setStyle(outlinedStyle());
  return true;
})
#include "window_test.moc"
