// SPDX-License-Identifier: GPL-3.0-or-later
// Actions, menus and tool bar of the window. Every action has a name, a text, a
// tool tip and, unless it is one of a set of choices, keys.

#include <QActionGroup>
#include <QApplication>
#include <QDir>
#include <QMenuBar>
#include <QMessageBox>
#include <QToolBar>

#include "editor/canvas/graph_canvas.h"
#include "editor/document/described.h"
#include "editor/document/form_widgets.h"
#include "editor/document/line_icon.h"
#include "editor/measured/measured_window.h"
#include "editor/quantity/offered_units.h"
#include "editor/study/participant_language.h"
#include "editor/window/help_window.h"
#include "editor/window/main_window.h"
#include "editor/window/preferences_dialog.h"

namespace detent::editor {
namespace {

/// Shows a window beside the main one; it is made at its first use.
template <class Make>
void showBeside(QPointer<QDialog>& window, const Make& make) {
  if (!window) window = make();
  bringUp(*window);
}

QMenu* menuOf(QMenuBar* bar, const QString& title, const char* name) {
  QMenu* menu = bar->addMenu(title);
  menu->setObjectName(name);
  menu->setToolTipsVisible(true);
  return menu;
}

}  // namespace

QAction* MainWindow::action(const char* name, const QString& text, const QString& tip,
                            const QKeySequence& keys, const std::function<void()>& act) {
  auto* made =
      described(new QAction(text, this), name,
                keys.isEmpty() ? tip : tr("%1 (%2)").arg(tip, keys.toString(QKeySequence::NativeText)));
  made->setShortcut(keys);
  connect(made, &QAction::triggered, this, act);
  ownActions_ << made;
  return made;
}

QAction* MainWindow::tabAction(const char* name, const QString& text, const QString& tip,
                               const QKeySequence& keys, const std::function<void(DocumentTab&)>& act) {
  QAction* made = action(name, text, tip, keys, [this, act] {
    if (DocumentTab* tab = tabs_->current()) act(*tab);
  });
  needTab_ << made;
  return made;
}

void MainWindow::makeFileActions() {
  QMenu* menu = menuOf(menuBar(), tr("&File"), "fileMenu");
  menu->addAction(action("new", tr("&New from template…"), tr("Start a new button from a template"),
                         QKeySequence("Ctrl+N"), [this] { files_->newButton(); }));
  menu->addAction(action("open", tr("&Open…"), tr("Open buttons, datasheets, pictures or CSV files"),
                         QKeySequence("Ctrl+O"), [this] { files_->openByDialog(); }));
  menu->addAction(action("import", tr("&Import a datasheet…"),
                         tr("Read the force graph from a picture, PDF, SVG or CSV"), QKeySequence("Ctrl+I"),
                         [this] { files_->importByDialog(); }));
  menu->addAction(action("importMany", tr("Import &many files…"),
                         tr("Import files or a folder in the background, with a list of results"),
                         QKeySequence("Ctrl+Alt+I"), [this] { files_->importMany(); }));
  menu->addAction(action("trySample", tr("&Try a sample datasheet"),
                         tr("Import a datasheet that comes with Detent, to see how it works"),
                         QKeySequence("Ctrl+Alt+T"), [this] { files_->importSample(); }));
  recentMenu_ = menu->addMenu(tr("Open &recent"));
  recentMenu_->setObjectName("recentMenu");
  recentMenu_->setToolTipsVisible(true);
  menu->addSeparator();
  menu->addAction(tabAction("save", tr("&Save"), tr("Save this button"), QKeySequence("Ctrl+S"),
                            [this](DocumentTab& tab) { files_->save(tab); }));
  menu->addAction(tabAction("saveAs", tr("Save &as…"), tr("Save this button under another name"),
                            QKeySequence("Ctrl+Shift+S"), [this](DocumentTab& tab) { files_->saveAs(tab); }));
  menu->addAction(tabAction("saveAll", tr("Save a&ll"), tr("Save every button with unsaved changes"),
                            QKeySequence("Ctrl+Alt+S"), [this](DocumentTab&) { files_->saveAll(); }));
  keepPage_ = tabAction("keepPage", tr("&Keep the page in the file"),
                        tr("Save the part of the page around the graph in the file of the button, so that "
                           "you see it without the datasheet"),
                        QKeySequence("Ctrl+Alt+P"), [this](DocumentTab& tab) {
                          files_->sheets().keepPage(tab.document(), keepPage_->isChecked());
                          updateKeepPage();
                        });
  keepPage_->setCheckable(true);
  menu->addAction(keepPage_);
  QMenu* exports = menu->addMenu(tr("&Export"));
  exports->setObjectName("exportMenu");
  exports->setToolTipsVisible(true);
  exports->addAction(tabAction("exportPng", tr("&Picture (PNG)…"),
                               tr("Write a picture of the graph, 2400 by 1600 pixels. It contains the "
                                  "button, so that Detent can open it again"),
                               QKeySequence("Ctrl+E"),
                               [this](DocumentTab& tab) { files_->exports().png(tab); }));
  exports->addAction(
      tabAction("exportGraph", tr("&Graph for datasheet, paper or slide…"),
                tr("Write the graph ready for print: SVG, PDF or PNG in any size, language and unit"),
                QKeySequence("Ctrl+Shift+E"), [this](DocumentTab& tab) { files_->exports().graph(tab); }));
  exports->addAction(tabAction("exportCsv", tr("&Samples (CSV)…"),
                               tr("Write samples of the state shown, in the units shown or in mm and N"),
                               QKeySequence("Ctrl+Alt+E"),
                               [this](DocumentTab& tab) { files_->exports().csv(tab); }));
  exports->addAction(tabAction(
      "exportSemicolonCsv", tr("Samples with d&ecimal commas (CSV)…"),
      tr("Write the samples with decimal commas and semicolons, as many spreadsheets expect them"),
      QKeySequence("Ctrl+Alt+Shift+E"), [this](DocumentTab& tab) { files_->exports().semicolonCsv(tab); }));
  exports->addAction(
      tabAction("exportCsvAt", tr("Samples &at given travels (CSV)…"),
                tr("Write press and release at even steps of travel, or at the travels you type"),
                QKeySequence("Ctrl+Alt+R"), [this](DocumentTab& tab) { files_->exports().csvAt(tab); }));
  exports->addAction(tabAction(
      "exportDataPackage", tr("Data pac&kage (described tables)…"),
      tr("Write a folder of tables (curve and key figures), with a description of every column and its unit, "
         "as the standard Frictionless Data Package requires"),
      QKeySequence("Ctrl+Alt+F"), [this](DocumentTab& tab) { files_->exports().dataPackage(tab); }));
  exports->addAction(tabAction(
      "exportTracedProject", tr("WebPlotDigitizer p&roject…"),
      tr("Write the state shown as a WebPlotDigitizer project, with axes in the units shown"),
      QKeySequence("Ctrl+Alt+J"), [this](DocumentTab& tab) { files_->exports().tracedProject(tab); }));
  exports->addAction(tabAction("exportWav", tr("&Vibration of a press (WAV)…"),
                               tr("Export the vibration of a standard press (WAV, mono, 48 kHz)"),
                               QKeySequence("Ctrl+Alt+W"),
                               [this](DocumentTab& tab) { files_->exports().wav(tab); }));
  exports->addAction(
      tabAction("exportDevice", tr("For a &device…"),
                tr("Export a press for phones, headsets, driver chips, firmware and touchpads"),
                QKeySequence("Ctrl+Alt+V"), [this](DocumentTab& tab) { files_->exports().device(tab); }));
  exports->addAction(tabAction(
      "exportMagnetic", tr("For a &magnetic keyboard…"),
      tr("Choose rapid trigger and dead zones, see what the key does, export a C header"),
      QKeySequence("Ctrl+Alt+Y"), [this](DocumentTab& tab) { files_->exports().magneticKey(tab); }));
  menu->addAction(
      tabAction("sharePage", tr("S&hare as web page…"),
                tr("Write a web page on which anyone can press the button, without installing anything"),
                QKeySequence("Ctrl+Alt+H"), [this](DocumentTab& tab) { files_->exports().page(tab); }));
  menu->addSeparator();
  menu->addAction(tabAction("print", tr("&Print…"), tr("Print the graph with its values"),
                            QKeySequence("Ctrl+P"), [this](DocumentTab& tab) { print(tab); }));
  menu->addSeparator();
  menu->addAction(tabAction("close", tr("&Close"), tr("Close this button"), QKeySequence("Ctrl+W"),
                            [this](DocumentTab& tab) { files_->close(tab); }));
  menu->addAction(action("quit", tr("&Quit"), tr("Close all buttons and quit"), QKeySequence("Ctrl+Q"),
                         [this] { close(); }));
}

void MainWindow::makeEditActions() {
  QMenu* menu = menuOf(menuBar(), tr("&Edit"), "editMenu");
  undo_ =
      tabAction("undo", tr("&Undo"), tr("Undo the last step"), QKeySequence("Ctrl+Z"), [](DocumentTab& tab) {
        EditHistory& history = tab.document().history();
        history.dragging() ? history.cancelDrag() : history.stack().undo();
      });
  redo_ = tabAction("redo", tr("&Redo"), tr("Redo the last undone step"), QKeySequence("Ctrl+Shift+Z"),
                    [](DocumentTab& tab) {
                      if (!tab.document().history().dragging()) tab.document().history().stack().redo();
                    });
  redo_->setShortcuts({QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
  undo_->setIconText(tr("Undo"));  // in lists; the menu names the step, too
  redo_->setIconText(tr("Redo"));
  menu->addAction(undo_);
  menu->addAction(redo_);
  menu->addSeparator();
  QAction* paste =
      action("paste", tr("&Paste"),
             tr("Import the picture or file on the clipboard, or paste copied points or a copied button"),
             QKeySequence("Ctrl+V"), [this] { this->paste(); });
  menu->addAction(paste);
  menu->addAction(tabAction("duplicate", tr("&Duplicate"), tr("Open a copy of this button in a new tab"),
                            QKeySequence("Ctrl+D"), [this](DocumentTab& tab) { duplicateButton(tab); }));
  editMenus_[GraphWorkspace::clipboard] = {menu, paste, {}};
  editMenus_[GraphWorkspace::selection] = {menu, menu->addSeparator(), {}};
  const auto submenu = [menu](const QString& title, const char* name) {
    QMenu* made = menu->addMenu(title);
    made->setObjectName(name);
    made->setToolTipsVisible(true);
    return made;
  };
  editMenus_[GraphWorkspace::arrangement].menu = submenu(tr("Arran&ge"), "arrangeMenu");
  editMenus_[GraphWorkspace::operations].menu = submenu(tr("Cur&ve"), "curveMenu");
  QMenu* copies = submenu(tr("Copy a&s"), "copyMenu");
  copies->addAction(tabAction("copyPicture", tr("&Copy as picture"), tr("Copy a picture of the graph"),
                              QKeySequence("Ctrl+Shift+C"), [this](DocumentTab& tab) { copyPicture(tab); }));
  copies->addAction(tabAction("copyCsv", tr("Copy as C&SV"),
                              tr("Copy samples of the state shown, in mm and N"), QKeySequence("Ctrl+Alt+C"),
                              [this](DocumentTab& tab) { copyCsv(tab); }));
  copies->addAction(tabAction("copyFigures", tr("Copy key fi&gures"),
                              tr("Copy the key figures as a table for spreadsheets, in the units shown"),
                              QKeySequence("Ctrl+Alt+G"), [this](DocumentTab& tab) { copyFigures(tab); }));
  menu->addAction(tabAction("rename", tr("Re&name the button…"), tr("Give the button another name"),
                            QKeySequence("F2"), [this](DocumentTab& tab) { renameButton(tab); }));
  menu->addSeparator();
  menu->addAction(action("preferences", tr("Pre&ferences…"), tr("Units, theme, language and layout"),
                         QKeySequence("Ctrl+,"), [this] { showPreferences(); }));
  toolMenu_.menu = menuOf(menuBar(), tr("&Tools"), "toolMenu");
  toolMenu_.end = toolMenu_.menu->addSeparator();
}

void MainWindow::makeViewActions() {
  viewMenu_.menu = menuOf(menuBar(), tr("&View"), "viewMenu");
  QMenu* menu = viewMenu_.menu;
  viewMenu_.end = menu->addSeparator();
  auto* views = new QActionGroup(this);
  const auto view = [&](const char* name, const QString& title, const QString& tip, const char* keys,
                        CentreView shown) {
    QAction* own = tabAction(name, title, tip, QKeySequence(keys), [this, shown](DocumentTab& tab) {
      shown == CentreView::compare ? compareShown(tab) : showView(shown);
    });
    own->setCheckable(true);
    views->addAction(own);
    menu->addAction(own);
    return own;
  };
  showEdit_ = view("edit", tr("&Edit"), tr("Show the graph and its inspector"), "Alt+0", CentreView::edit);
  showCompare_ = view("compare", tr("&Compare"), tr("Overlay buttons and show their differences"), "Ctrl+K",
                      CentreView::compare);
  showFeel_ = view("feel", tr("Fee&l"), tr("Press the button, hear it and see its vibration"), "Alt+4",
                   CentreView::feel);
  menu->addSeparator();
  QMenu* references = menu->addMenu(tr("&Reference curve"));
  references->setObjectName("referenceMenu");
  connect(references, &QMenu::aboutToShow, this, [this, references] { fillReferences(*references); });
  unitMenu_ = new QMenu(tr("Units"), this);  // of the status bar
  unitMenu_->setObjectName("unitMenu");
  makeUnitActions(unitMenu_);
  menu->addSeparator();
  menu->addAction(action("nextPanel", tr("&Next panel"), tr("Move the focus to the next panel"),
                         QKeySequence("F6"), [this] { focusNextPanel(1); }));
  menu->addAction(action("previousPanel", tr("Pre&vious panel"), tr("Move the focus to the previous panel"),
                         QKeySequence("Shift+F6"), [this] { focusNextPanel(-1); }));
  for (QDockWidget* dock : QList<QDockWidget*>{libraryDock_} + inspectorDocks())
    for (QAction* own : ownActions_)
      if (own->objectName() == dock->objectName() + "Toggle") menu->addAction(own);
  QAction* fullScreen =
      action("fullScreen", tr("&Full screen"), tr("Use the whole screen"), QKeySequence("F11"),
             [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
  menu->addAction(fullScreen);
}

// The menu shows which of these actions is chosen, so they have no keys.
void MainWindow::makeUnitActions(QMenu* menu) {
  const auto add = [&](QActionGroup* group, const QString& kind, const QString& symbol, const QString& tip,
                       const std::function<void()>& act) {
    QAction* unit = action("unit", symbol, tip, {}, act);
    unit->setObjectName("unit_" + kind + "_" + symbol);
    unit->setData(kind + ":" + symbol);
    unit->setCheckable(true);
    group->addAction(unit);
    menu->addAction(unit);
  };
  pageUnits_ = action("unitsOfPage", tr("As on the &page"),
                      tr("Show each button in the units of the page that it was read from"), {},
                      [this] { at_.view.followPages(); });
  pageUnits_->setCheckable(true);
  menu->addAction(pageUnits_);
  menu->addSeparator();
  auto* lengths = new QActionGroup(this);
  for (const LengthUnit unit : offeredLengthUnits)
    add(lengths, "length", unitText(symbolOf(unit)),
        tr("Show displacements in %1").arg(unitText(symbolOf(unit))), [this, unit] {
          DisplayUnits units = at_.view.units();
          units.length = unit;
          at_.view.setUnits(units);
        });
  menu->addSeparator();
  auto* forces = new QActionGroup(this);
  for (const ForceUnit unit : offeredForceUnits)
    add(forces, "force", unitText(symbolOf(unit)), tr("Show forces in %1").arg(unitText(symbolOf(unit))),
        [this, unit] {
          DisplayUnits units = at_.view.units();
          units.force = unit;
          at_.view.setUnits(units);
        });
}

void MainWindow::makeWindowActions() {
  buttonMenu_ = menuOf(menuBar(), tr("&Button"), "buttonMenu");
  QMenu* menu = buttonMenu_;
  menu->addAction(tabAction("morph", tr("&Blend two buttons…"),
                            tr("Create a button that lies between two open buttons"),
                            QKeySequence("Ctrl+Alt+B"), [this](DocumentTab& tab) { morph(tab); }));
  menu->addAction(tabAction("average", tr("&Average open buttons…"),
                            tr("Create the mean of several specimens of one button, and show their spread"),
                            QKeySequence("Ctrl+Alt+A"), [this](DocumentTab& tab) { average(tab); }));
  menu->addAction(action("forecasts", tr("Predicted &confusion…"),
                         tr("Predict for all open buttons which of them people will confuse"),
                         QKeySequence("Ctrl+Shift+K"), [this] { showForecasts(); }));
  menu->addAction(action("measured", tr("&Measured switches…"),
                         tr("Look through measured switches: table, map, curves"), QKeySequence("Ctrl+M"),
                         [this] { showMeasured(); }));
  menu->addAction(tabAction(
      "feelsLike", tr("&Find similar switches…"), tr("List the measured switches nearest to this button"),
      QKeySequence("Ctrl+Alt+M"), [this](DocumentTab& tab) { showMeasured().askFor(tab.document()); }));
  menu->addAction(action("study", tr("&Study with people…"),
                         tr("Ask people whether they can tell buttons apart"), QKeySequence("Ctrl+Alt+K"),
                         [this] { showStudy(); }));
  menu->addSeparator();
  menu->addAction(tabAction("nextTab", tr("&Next button"), tr("Show the next open button"),
                            QKeySequence("Ctrl+PgDown"), [this](DocumentTab&) { tabs_->showNext(1); }));
  menu->addAction(tabAction("previousTab", tr("&Previous button"), tr("Show the previous open button"),
                            QKeySequence("Ctrl+PgUp"), [this](DocumentTab&) { tabs_->showNext(-1); }));
}

void MainWindow::makeHelpActions() {
  QMenu* menu = menuOf(menuBar(), tr("&Help"), "helpMenu");
  menu->addAction(
      action("guide", tr("&User's guide"), tr("Read how to use Detent"), QKeySequence("F1"),
             [this] { showBeside(guide_, [this] { return new GuideWindow(documentsFolder(), this); }); }));
  menu->addAction(action("glossary", tr("&Glossary"), tr("Show in pictures what each figure measures"),
                         QKeySequence("Ctrl+F1"),
                         [this] { showBeside(glossary_, [this] { return new GlossaryWindow(this); }); }));
  menu->addAction(action("shortcuts", tr("&Keyboard shortcuts"), tr("List every action with its keys"),
                         QKeySequence("Ctrl+Shift+F1"), [this] { showShortcuts(); }));
  menu->addAction(action("about", tr("&About Detent"), tr("Version and licence"), QKeySequence("Shift+F1"),
                         [this] { showAbout(); }));
}

void MainWindow::makeToolBar() {
  tools_ = addToolBar(tr("Tools"));
  tools_->setObjectName("toolBar");
  tools_->setMovable(false);
  tools_->toggleViewAction()->setEnabled(false);  // a tool bar hidden by mistake is hard to find again
  const auto add = [this](const char* name) {
    for (QAction* own : ownActions_)
      if (own->objectName() == name) {
        own->setIcon(lineIcon(name));
        tools_->addAction(own);
      }
  };
  for (const char* name : {"new", "open", "import", "save"}) add(name);
  tools_->addSeparator();
  for (const char* name : {"undo", "redo"}) add(name);
  tools_->addSeparator();
  auto* room = new QWidget;
  room->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  toolsEnd_ = tools_->addWidget(room);
  for (QAction* view : {showEdit_, showCompare_, showFeel_}) tools_->addAction(view);
}

// ---- what changes with the tab

void MainWindow::fill(TabMenu& menu, const QList<QAction*>& actions) {
  for (QAction* old : menu.shown) menu.menu->removeAction(old);
  menu.menu->insertActions(menu.end, actions);
  menu.shown = actions;
}

void MainWindow::showTabActions(DocumentTab* tab) {
  for (QAction* old : toolMenu_.shown) tools_->removeAction(old);
  for (std::size_t i = 0; i < editMenus_.size(); ++i)
    fill(editMenus_[i], tab ? tab->workspace().editActions(GraphWorkspace::EditGroup(i)) : QList<QAction*>());
  for (const auto group : {GraphWorkspace::arrangement, GraphWorkspace::operations})
    editMenus_[group].menu->menuAction()->setVisible(tab != nullptr);
  fill(toolMenu_, tab ? tab->workspace().toolActions() : QList<QAction*>());
  fill(viewMenu_, tab ? tab->workspace().viewActions() : QList<QAction*>());
  for (QAction* tool : toolMenu_.shown)
    if (tool->icon().isNull()) tool->setIcon(lineIcon(tool->objectName()));
  tools_->insertActions(toolsEnd_, toolMenu_.shown);
  toolMenu_.menu->menuAction()->setVisible(tab != nullptr);
}

void MainWindow::updateUndo() {
  const DocumentTab* tab = tabs_->current();
  const QUndoStack* stack = tab ? &tabs_->current()->document().history().stack() : nullptr;
  undo_->setEnabled(stack && stack->canUndo());
  redo_->setEnabled(stack && stack->canRedo());
  undo_->setText(stack && stack->canUndo() ? tr("&Undo: %1").arg(stack->undoText()) : tr("&Undo"));
  redo_->setText(stack && stack->canRedo() ? tr("&Redo: %1").arg(stack->redoText()) : tr("&Redo"));
}

void MainWindow::updateRecent() {
  recentMenu_->clear();
  const QStringList paths = files_->recent().paths();
  const QStringList names = distinctNames(paths);
  for (int i = 0; i < paths.size(); ++i) {
    const QString& path = paths[i];
    QString name = names[i];
    QAction* entry =
        recentMenu_->addAction(name.replace('&', "&&"), this, [this, path] { files_->open({path}); });
    entry->setToolTip(QDir::toNativeSeparators(path));
  }
  recentMenu_->addSeparator();
  recentMenu_->addAction(tr("&Clear list"), this, [this] { files_->recent().clear(); });
  recentMenu_->setEnabled(!paths.isEmpty());
  welcome_->setRecent(paths);
}

void MainWindow::fillReferences(QMenu& menu) {
  menu.clear();
  DocumentTab* tab = tabs_->current();
  if (!tab) return;
  GraphCanvas& canvas = tab->workspace().canvas();
  const auto add = [&](const QString& text, std::optional<Reference> reference) {
    QAction* entry = menu.addAction(text, &canvas, [&canvas, reference] { canvas.showReference(reference); });
    entry->setCheckable(true);
    const auto& shown = canvas.reference();
    entry->setChecked(reference.has_value() == shown.has_value() &&
                      (!shown || (shown->name == reference->name && shown->state == reference->state)));
  };
  add(tr("&None"), {});
  add(tr("This button as it is &now"),
      Reference{canvas.state(), tr("%1 (version)").arg(tab->document().title())});
  menu.addSeparator();
  const std::vector<ButtonDocument*> documents = tabs_->documents();
  const QStringList titles = distinctTitles(documents);
  for (std::size_t i = 0; i < documents.size(); ++i) {
    const QString& title = titles[static_cast<qsizetype>(i)];
    if (documents[i] != &tab->document())
      add(QString(title).replace('&', "&&"),
          Reference{documents[i]->button().states()[documents[i]->activeState()], title});
  }
}

QList<QAction*> MainWindow::allActions() const {
  return ownActions_ + editActions() + toolMenu_.shown + viewMenu_.shown;
}

QList<QAction*> MainWindow::editActions() const {
  QList<QAction*> all;
  for (const TabMenu& part : editMenus_) all += part.shown;
  return all;
}

std::vector<ShortcutRow> MainWindow::shortcuts() const {
  std::vector<ShortcutRow> rows = shortcutRows(tr("Window"), ownActions_);
  const auto add = [&](const QString& group, const QList<QAction*>& actions) {
    const std::vector<ShortcutRow> more = shortcutRows(group, actions);
    rows.insert(rows.end(), more.begin(), more.end());
  };
  add(tr("Tools"), toolMenu_.shown);
  add(tr("Editing"), editActions());
  add(tr("View"), viewMenu_.shown);
  return rows;
}

void MainWindow::showPreferences() {
  showBeside(preferences_, [this] {
    auto* made = new PreferencesDialog(at_.view, at_.settings, ParticipantLanguage::carried(), this);
    connect(made, &PreferencesDialog::layoutResetWanted, this, &MainWindow::resetLayout);
    return made;
  });
}

void MainWindow::showShortcuts() {
  ShortcutDialog dialog(shortcuts(), this);
  dialog.exec();
}

void MainWindow::showAbout() {
  QMessageBox::about(
      this, tr("About Detent"),
      tr("<b>Detent %1</b><p>From a printed force graph to a button you can feel.</p><p>GPL-3.0-or-later. "
         "Based on work by S. Kim and G. Lee, UIST 2013, and P. Shrestha.</p>")
          .arg(QCoreApplication::applicationVersion()));
}

}  // namespace detent::editor
