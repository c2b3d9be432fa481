// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The side list: open buttons and those of a folder.

#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QTimer>
#include <QToolButton>
#include <QWidget>

#include "editor/forecast/forecast_source.h"
#include "editor/library/library_model.h"

namespace detent::editor {

/// GUI thread.
class LibraryPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LibraryPanel(QWidget* parent = nullptr);

  /// Sets the documents, in the order of the tabs; `active` is marked.
  void setDocuments(const std::vector<ButtonDocument*>& documents, ButtonDocument* active);
  void setFolder(const QString& folder);
  const QString& folder() const { return files_.folder(); }

  static constexpr QSize pictureSize_px{84, 60};

 signals:
  void documentChosen(ButtonDocument* document);
  void fileChosen(const QString& path);
  /// Requests a comparison with the active button.
  void compareRequested(ButtonDocument* document);
  void compareFileRequested(const QString& path);
  /// Requests a comparison of the selected buttons only.
  void compareAllRequested(const std::vector<detent::editor::ButtonDocument*>& documents);
  void compareFilesRequested(const QStringList& paths);
  void folderChanged(const QString& folder);

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void askForecasts();
  void showForecasts(const Forecast& forecast);
  QWidget* openSection();
  QWidget* folderSection();
  void askFolder();
  void showFolderName();
  void updateDrawingColors();
  std::vector<ButtonDocument*> selectedDocuments() const;
  QStringList selectedFiles() const;
  void openMenu(QPoint at);
  void folderMenu(QPoint at);

  PictureCache pictures_{pictureSize_px};
  OpenButtonsModel open_{pictures_};
  FolderModel files_{pictures_};
  // Forecasts for the shown button; repeated after an edit of any button.
  std::vector<ButtonDocument*> documents_;
  ButtonDocument* active_ = nullptr;
  ForecastSource forecasts_;
  QTimer forecastSoon_;
  QListView* openList_ = nullptr;
  QListView* fileList_ = nullptr;
  QToolButton* folderButton_ = nullptr;
  QLineEdit* filter_ = nullptr;
  QLabel* emptyHint_ = nullptr;
};

}  // namespace detent::editor
