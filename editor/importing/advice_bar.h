// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Problem and remedies above the page, with the helpful corrections as buttons; one question at a time.

#include <QFrame>
#include <QGridLayout>
#include <QLabel>
#include <QList>
#include <QPushButton>

#include "editor/importing/finding_words.h"

namespace detent::editor {

class AdviceBar : public QFrame {
  Q_OBJECT

 public:
  enum class Tone { note, doubt, fault };

  explicit AdviceBar(QWidget* parent = nullptr);

  /// Shows an advice; changes nothing if it is shown already.
  void say(Tone tone, const Advice& advice);
  void clear();
  QString text() const { return words_->text(); }

 signals:
  void remedyChosen(RemedyKind correction);
  /// The unit that the user chose for an axis without a printed one.
  void lengthUnitChosen(LengthUnit unit);
  void forceUnitChosen(ForceUnit unit);
  /// The axis of this question, giveXUnit or giveYUnit, measures another quantity.
  void otherQuantityChosen(RemedyKind question);

 private:
  void addButtons(const std::vector<RemedyKind>& remedies);
  QPushButton* addButton(const QString& text);
  QPushButton* addUnit(const QString& symbol, const char* name);
  void addLengthUnits();
  void addForceUnits();
  void addNoUnit(RemedyKind question);

  QLabel *mark_, *words_;
  QLabel* question_;
  QGridLayout *units_, *buttons_;
  int unit_ = 0, button_ = 0;  ///< numbers of the next unit's and the next button's place
  Tone tone_ = Tone::note;
  QString said_;
};

}  // namespace detent::editor
