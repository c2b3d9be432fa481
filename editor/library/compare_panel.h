// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Compares open buttons: graphs over each other, and a table of their differences.

#include <memory>
#include <QAction>
#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QTableWidget>
#include <QTimer>
#include <QToolButton>
#include <QWidget>
#include <vector>

#include "editor/document/button_document.h"
#include "editor/document/series_colors.h"
#include "editor/document/view_settings.h"
#include "editor/forecast/forecast_bar.h"

namespace detent::editor {

class ComparePlot;

/// Compares two or more buttons, each chosen by its name; differences are counted from the first one. The
/// buttons can be edited meanwhile, and the panel follows. In a wide panel the plot is beside the figures, in
/// a narrow one above them. GUI thread.
class ComparePanel : public QWidget {
  Q_OBJECT

 public:
  static constexpr std::size_t mostSides = seriesColors;

  /// `settings` must outlive this.
  explicit ComparePanel(ViewSettings& settings, QWidget* parent = nullptr);
  ~ComparePanel() override;

  /// Sets the buttons that can be chosen. A compared button that is not among them is dropped.
  void setDocuments(const std::vector<ButtonDocument*>& documents);
  void compare(ButtonDocument* first, ButtonDocument* second);
  /// True if there is only one button, in one state. Then the panel offers `ways` to another one.
  bool isAlone() const;
  /// Ways to a second button, offered as buttons while there is only one. Must outlive this, or be replaced.
  void offer(const QList<QAction*>& ways);
  /// True if the button is one of those compared.
  bool compares(const ButtonDocument& document) const;
  /// Returns true if the user has chosen the compared buttons in the panel since the last compare().
  bool isChosen() const { return chosen_; }
  /// Compares exactly these, at most `mostSides`; a single one is shown on both sides.
  void compare(std::vector<ButtonDocument*> documents);
  /// Adds a button to those compared.
  void add(ButtonDocument* document);

  /// The table with units as CSV text; for the clipboard.
  QString tableText() const;
  const ComparePlot& plot() const { return *plot_; }

 signals:
  /// The user wants to save the plot as a picture.
  void pictureRequested();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* object, QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  /// The choice of one side.
  struct Side {
    QChar letter;  ///< part of the names of the row's widgets
    QWidget* row = nullptr;
    QLabel* swatch = nullptr;
    QComboBox* button = nullptr;
    QComboBox* state = nullptr;
    ButtonDocument* document = nullptr;
    QString name;  ///< with its state, and unlike that of another button
  };
  void build();
  QWidget* plotSide();
  QWidget* figureSide();
  QWidget* offerSide();
  void addSide();
  int placeOf(const Side& side) const;
  void showColors();
  void removeLast();
  void addNext();
  void fillButtons(Side& side);
  void fillStates(Side& side);
  void choose(Side& side, ButtonDocument* document);
  void exchange();
  const ButtonState* stateOf(const Side& side) const;
  void update();
  void giveRoomToFigures();
  int nameWidth() const;
  int leastWidth(int column) const;
  int wishedWidth(int column) const;
  int valueColumns() const;
  int tableWidth_px() const;
  void layOutTable();
  void fillTable(const std::vector<const ButtonState*>& states);
  QString distances(const std::vector<const ButtonState*>& states) const;

  ViewSettings& settings_;
  std::vector<ButtonDocument*> documents_;
  std::vector<std::unique_ptr<Side>> sides_;  // at least two
  bool chosen_ = false;
  QVBoxLayout* rows_ = nullptr;
  QSplitter* split_ = nullptr;
  /// contains the cursor's values and the tools, side by side in a wide panel
  QBoxLayout* belowPlot_ = nullptr;
  ComparePlot* plot_ = nullptr;
  QTableWidget* table_ = nullptr;
  int neededTable_px_ = 0;  // when the figures got their room
  QLabel *distance_ = nullptr, *reading_ = nullptr;
  QWidget *figures_ = nullptr, *alone_ = nullptr;  // one of the two is shown
  QVBoxLayout* ways_ = nullptr;
  ForecastBar* forecast_ = nullptr;
  QPushButton *more_ = nullptr, *fewer_ = nullptr;
  QTimer soon_;
};

}  // namespace detent::editor
