// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A label that elides its text.

#include <QLabel>
#include <QPainter>
#include <QStyle>

namespace detent::editor {

/// One line of plain text, elided without space; the tool tip has the whole text. GUI thread.
class ElidedLabel : public QLabel {
 public:
  explicit ElidedLabel(Qt::TextElideMode side) : side_(side) {
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  }
  void say(const QString& words) {
    setText(words);
    setToolTip(words);
  }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter painter(this);
    const QRect place = contentsRect();
    style()->drawItemText(&painter, place, Qt::AlignLeft | Qt::AlignVCenter, palette(), isEnabled(),
                          fontMetrics().elidedText(text(), side_, place.width()), foregroundRole());
  }

 private:
  Qt::TextElideMode side_;
};

}  // namespace detent::editor
