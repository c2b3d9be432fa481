// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The window of detent-edit: arranges tabs, side panels, menus and keys. Files are opened and saved by
// FileController.

#include <array>
#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>
#include <QPointer>
#include <QScrollArea>
#include <QSettings>
#include <QStackedWidget>
#include <QToolButton>

#include "editor/files/recovery_store.h"
#include "editor/window/file_controller.h"
#include "editor/window/prompts.h"
#include "editor/window/shortcut_list.h"
#include "editor/window/tab_area.h"
#include "model/unit_spread.h"

namespace detent::editor {

class ComparePanel;
class ForecastMatrix;
class ExperimenterDialog;
class FeelPanel;
class FeelSession;
class LibraryPanel;
class MeasuredWindow;
class MarginOverlay;

QPalette currentDesktopPalette();

/// Objects that a window needs; all of them outlive the window.
struct WindowContext {
  ViewSettings& view;
  QSettings& settings;
  Prompts& prompts;
  RecoveryStore& recovery;
  /// The desktop's present colours; the program's own palette is removed to read them.
  std::function<QPalette()> desktopPalette = &currentDesktopPalette;
};

/// GUI thread. Nothing heavy is made before it is seen: no sound, no import, no comparison.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(const WindowContext& context, QWidget* parent = nullptr);
  ~MainWindow() override;

  FileController& files() { return *files_; }
  TabArea& tabs() { return *tabs_; }
  NoticeBar& notices() { return *notices_; }

  /// Every action a person can reach now, those of the current tab included.
  QList<QAction*> allActions() const;
  std::vector<ShortcutRow> shortcuts() const;
  /// Opens what was open when the window was closed last, and shows what was shown.
  void restoreSession();
  /// Contents of the centre: a graph to edit, with its docks; graphs over each other with their differences;
  /// the pad below the graph.
  enum class CentreView { edit, compare, feel };
  void showView(CentreView view);
  /// Compares another button with the one that is shown.
  void compareWith(ButtonDocument* other);
  /// Compares these buttons, with differences from the first one, and shows the comparison.
  void compareAll(const std::vector<ButtonDocument*>& documents);
  /// Compares the buttons of files; opens those that are not open yet.
  void compareFiles(const QStringList& paths);
  void morph(DocumentTab& tab);
  DocumentTab& addComputed(const Button& button);
  void average(DocumentTab& tab);
  void openAverage(const UnitSpread& spread, const QStringList& titles);
  void showForecasts();
  void showStudy();
  /// Shows the window of measured switches, which is made at its first use.
  MeasuredWindow& showMeasured();

 protected:
  void showEvent(QShowEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  /// A menu that ends with the actions of the current tab.
  struct TabMenu {
    QMenu* menu = nullptr;
    QAction* end = nullptr;  // the tab's actions stand before this one
    QList<QAction*> shown;
  };

  // main_window_actions.cpp
  QAction* action(const char* name, const QString& text, const QString& tip, const QKeySequence& keys,
                  const std::function<void()>& act);
  QAction* tabAction(const char* name, const QString& text, const QString& tip, const QKeySequence& keys,
                     const std::function<void(DocumentTab&)>& act);
  void makeFileActions();
  void makeEditActions();
  void makeViewActions();
  void makeUnitActions(QMenu* menu);
  void makeWindowActions();
  void makeHelpActions();
  void makeToolBar();
  void showTabActions(DocumentTab* tab);
  QList<QAction*> editActions() const;
  void fill(TabMenu& menu, const QList<QAction*>& actions);
  void updateUndo();
  void updateRecent();
  void fillReferences(QMenu& menu);
  void showPreferences();
  void showShortcuts();
  void showAbout();

  // main_window.cpp
  void makeCentre();
  void makeDocks();
  QDockWidget* dock(const char* name, const QString& title, Qt::DockWidgetArea area,
                    const QKeySequence& keys);
  void makeStatusBar();
  void connectTabs();
  void adopt(DocumentTab& tab);
  void letGo(DocumentTab& tab);
  void showTab(DocumentTab* tab);
  void updateDocuments();
  void makeComparison();
  void offerToCompare();
  QList<QAction*> actionsNamed(std::initializer_list<const char*> names) const;
  void compareShown(DocumentTab& tab);
  void putDocksAway(bool away);
  QList<QDockWidget*> inspectorDocks() const;
  void sizeDocks();
  void keepInspectorWidth();
  void resetLayout();
  void writeComparison();
  std::vector<ButtonDocument*> openAll(const std::vector<Button>& buttons);
  void updateTitle();
  void updateKeepPage();
  void updateUnits();
  void showCursor(std::optional<CurvePoint> at);
  void turn(QDockWidget& dock);
  void makeFeelPanel();
  void showMargin();
  void chooseOther();
  void setOther(ButtonDocument* other);
  void updateFeel();
  void applyAppearance();
  void restoreWindow();
  void storeWindow();
  void storeSession();
  void copyPicture(DocumentTab& tab);
  void copyCsv(DocumentTab& tab);
  void copyFigures(DocumentTab& tab);
  void copyButton(DocumentTab& tab);
  void duplicateButton(DocumentTab& tab);
  bool pasteText(const QString& text);
  void paste();
  void print(DocumentTab& tab);
  void focusNextPanel(int by);
  void renameButton(DocumentTab& tab);

  WindowContext at_;
  QPalette systemPalette_;
  TabArea* tabs_ = nullptr;
  NoticeBar* notices_ = nullptr;
  FileController* files_ = nullptr;
  WelcomePage* welcome_ = nullptr;
  LibraryPanel* library_ = nullptr;
  FeelSession* session_ = nullptr;
  FeelPanel* feel_ = nullptr;
  ComparePanel* comparison_ = nullptr;
  ForecastMatrix* forecasts_ = nullptr;
  ExperimenterDialog* study_ = nullptr;
  MeasuredWindow* measured_ = nullptr;
  QPointer<QAction> reference_;  // opens the reference curve as a button, while one is offered
  QPointer<QDialog> guide_, glossary_, preferences_;
  QDockWidget *libraryDock_ = nullptr, *valuesDock_ = nullptr, *inspectorDock_ = nullptr,
              *historyDock_ = nullptr, *checksDock_ = nullptr, *annotationsDock_ = nullptr;
  QStackedWidget* centre_ = nullptr;  // buttons with the feel panel below them, or the comparison
  QScrollArea *feelArea_ = nullptr, *compareArea_ = nullptr;
  CentreView view_ = CentreView::edit;
  QAction* toolsEnd_ = nullptr;  // the tools of the shown button stand before this action
  QAction *showEdit_ = nullptr, *showCompare_ = nullptr, *showFeel_ = nullptr;
  bool docksAway_ = false;
  QList<QDockWidget*> awayDocks_;    // docks that are shown again when the user returns to Edit
  QPointer<QDockWidget> frontDock_;  // the visible one of docks that share a place
  QByteArray firstState_;            // arrangement of the docks before any was moved
  bool docksAreNew_ = false;         // true: no arrangement of the docks was stored
  int inspector_px_ = 0;             // width of the docks at the right; 0: not known yet
  QComboBox* other_ = nullptr;       // chooses the button that is B of the feel panel
  QPointer<MarginOverlay> margin_;
  QPointer<ButtonDocument> otherDocument_;
  QPointer<ButtonDocument> shown_, shownBefore_;
  std::pair<ButtonDocument*, ButtonDocument*> felt_;  // A and B of the feel panel
  bool otherChosen_ = false;  // true: B was chosen by hand; false: B is the button that was shown before
  QLabel* cursor_ = nullptr;
  QToolButton* units_ = nullptr;
  QToolBar* tools_ = nullptr;
  QMenu* recentMenu_ = nullptr;
  QMenu* unitMenu_ = nullptr;
  QMenu* buttonMenu_ = nullptr;
  std::array<TabMenu, GraphWorkspace::editGroups> editMenus_;
  TabMenu toolMenu_, viewMenu_;
  QAction *undo_ = nullptr, *redo_ = nullptr, *quit_ = nullptr, *keepPage_ = nullptr, *pageUnits_ = nullptr;
  QList<QAction*> ownActions_, needTab_;
  bool sessionHeld_ = true;  ///< do not store the session: no file is open yet, or all are closing
};

}  // namespace detent::editor
