// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The measured switches of a library: table, map, overlay, and which of them feel like a given button. Credit
// and licence are always visible.

#include <functional>
#include <optional>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QStackedWidget>
#include <QTableView>
#include <QTimer>
#include <QToolButton>
#include <set>
#include <vector>

#include "editor/document/button_document.h"
#include "editor/document/view_settings.h"
#include "editor/measured/filter_bar.h"
#include "editor/measured/library_source.h"
#include "editor/measured/measured_table.h"
#include "editor/measured/nearest_forecasts.h"
#include "editor/measured/overlay_plot.h"
#include "editor/measured/switch_map.h"

namespace detent::editor {

/// Access of the window to the tabs and the disk; tests replace it. All of it outlives the window.
struct MeasuredContext {
  ViewSettings& view;
  QSettings& settings;  ///< "measured/…": the library's file, its folders
  std::function<std::vector<ButtonDocument*>()> documents;
  /// Opens buttons, each in a tab.
  std::function<void(const std::vector<Button>&)> open;
  /// Opens buttons, each in a tab, and overlays them in the comparison.
  std::function<void(const std::vector<Button>&)> compare;
  // The path that the user chose; empty: cancelled.
  std::function<QString(QWidget*parent)> libraryFile, folder;
  std::function<QString(QWidget* parent, const QString& suggested)> page;
};

/// The window of measured switches. Not modal. GUI thread.
class MeasuredWindow : public QDialog {
  Q_OBJECT

 public:
  explicit MeasuredWindow(MeasuredContext context, QWidget* parent = nullptr);

  /// Updates the list of open buttons.
  void followDocuments();
  /// Sorts the switches by distance to this button, nearest first.
  void askFor(ButtonDocument& document);
  /// Shows this library from now on.
  void openLibrary(const QString& database);
  /// Adds a folder's measurements to the shown library; to the user's own if there is none.
  void addFolder(const QString& folder);

 signals:
  /// The result of openLibrary or addFolder is shown.
  void shown();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  /// The reference of the comparison.
  struct Reference {
    QString name;
    importer::LibrarySwitch entry;   ///< entry in the library, if the reference is a switch of it
    std::optional<SwitchIndex> own;  ///< likewise
    QPointer<ButtonDocument> document;
  };
  QWidget* emptyPage();
  QWidget* fullPage();
  QWidget* tableView();
  QWidget* mapView();
  QLayout* askRow();
  QLayout* actionRow();
  QToolButton* libraryButton();
  QPushButton* actionButton(const char* name, const QString& text, const QString& tip,
                            const std::function<void()>& act);

  QString database() const;
  QStringList folders() const;
  LibraryRequest ofFolders() const;  ///< Request for the folders that exist.
  void indexAgain();
  void take(const QString& database, const std::shared_ptr<const MeasuredSwitches>& switches);
  void sayIndexed(const importer::IndexSummary& summary);
  void sayBusy(bool busy);
  void showRefused();

  void chooseReference();
  void askLikeChosen();
  void nearestFirst();
  void rank();
  void forecastNearest();
  void listRequested();

  void filterChanged();
  void rowsChanged();
  void restoreChosen();
  void choose(const std::set<SwitchIndex>& chosen);
  void chosenInTable();
  void showChosen();
  void sayCredits();
  std::vector<importer::LibrarySwitch> chosenEntries() const;
  void openChosen(bool compare);
  void writeReport();
  void columnMenu(QPoint at);
  void askForFolder();
  void askForLibrary();
  void followUnits();
  void followScales();

  MeasuredContext context_;
  MeasuredTable table_;
  std::set<SwitchIndex> chosen_;
  std::optional<Reference> reference_;
  std::vector<importer::RefusedFile> refused_;
  std::vector<ButtonDocument*> listed_;  // in the order of the combo box
  bool loadedOnce_ = false, restoring_ = false, comparing_ = false;

  QStackedWidget* pages_ = nullptr;
  FilterBar* filter_ = nullptr;
  QComboBox *like_ = nullptr, *mapX_ = nullptr, *mapY_ = nullptr;
  QTableView* view_ = nullptr;
  SwitchMap* map_ = nullptr;
  OverlayPlot* overlay_ = nullptr;
  QLabel *count_ = nullptr, *credits_ = nullptr, *said_ = nullptr, *emptyWords_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QPushButton *cancel_ = nullptr, *refusedButton_ = nullptr, *likeThis_ = nullptr, *openButton_ = nullptr,
              *compareButton_ = nullptr, *report_ = nullptr;
  QTimer rankSoon_, forecastSoon_;
  NearestForecasts forecasts_;
  LibrarySource source_;
};

}  // namespace detent::editor
