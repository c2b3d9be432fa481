// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Open buttons over each other, and what sets them apart.

#include <memory>
#include <QBoxLayout>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QTimer>
#include <vector>

#include "editor/document/button_document.h"
#include "editor/document/view_settings.h"
#include "editor/forecast/forecast_bar.h"

namespace detent::editor {

class ComparePlot;

/// Two buttons or more; differences are counted from the first. Not modal: all can be worked on while it is
/// open, and it follows. GUI thread.
class CompareDialog : public QDialog {
  Q_OBJECT

 public:
  static constexpr std::size_t mostSides = 6;  ///< as many colours can be told apart

  /// `settings` must outlive this.
  explicit CompareDialog(ViewSettings& settings, QWidget* parent = nullptr);
  ~CompareDialog() override;

  /// The buttons that can be chosen. One that is no longer among them is let go of.
  void setDocuments(const std::vector<ButtonDocument*>& documents);
  void compare(ButtonDocument* a, ButtonDocument* b);
  /// One more beside those compared.
  void add(ButtonDocument* document);

  /// What the table says, with units, as CSV text; for the clipboard.
  QString tableText() const;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  /// The choice of one side.
  struct Side {
    QString letter;
    QWidget* row = nullptr;
    QComboBox* button = nullptr;
    QComboBox* state = nullptr;
    ButtonDocument* document = nullptr;
  };
  void build();
  void addSide();
  void removeLast();
  void addNext();
  void fillButtons(Side& side);
  void fillStates(Side& side);
  void choose(Side& side, ButtonDocument* document);
  void exchange();
  const ButtonState* stateOf(const Side& side) const;
  void update();
  void fillTable(const std::vector<const ButtonState*>& states);
  QString distances(const std::vector<const ButtonState*>& states) const;

  ViewSettings& settings_;
  std::vector<ButtonDocument*> documents_;
  std::vector<std::unique_ptr<Side>> sides_;  // two at least
  QVBoxLayout* rows_ = nullptr;
  ComparePlot* plot_ = nullptr;
  QTableWidget* table_ = nullptr;
  QLabel *distance_ = nullptr, *reading_ = nullptr;
  ForecastBar* forecast_ = nullptr;
  QPushButton *more_ = nullptr, *fewer_ = nullptr;
  QTimer soon_;
};

}  // namespace detent::editor
