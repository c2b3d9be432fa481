// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A page for participants: large plain texts and buttons, each with its key. A key and its button always do
// the same, because one function handles both.

#include <functional>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <QWidget>
#include <vector>

namespace detent::editor {

inline constexpr int largeText_pt = 22, plainText_pt = 15, smallText_pt = 12;
inline constexpr int pressHeight_px = 110, answerHeight_px = 74, smallHeight_px = 44;

/// A key, and its name on the button.
struct PageKey {
  int key = 0;   ///< Qt::Key
  QString name;  ///< "A", "Enter"
};

struct PageButton {
  const char* name;  ///< object name
  QString text;
  PageKey key;  ///< 0: only the mouse
  int points = largeText_pt;
  int height_px = answerHeight_px;
};

/// GUI thread.
class KeyedPage : public QWidget {
  Q_OBJECT

 public:
  explicit KeyedPage(QWidget* parent = nullptr);

  /// Contents of the middle, from top to bottom.
  QVBoxLayout* column() const { return column_; }
  QLabel* addText(const char* name, const QString& text, int points,
                  Qt::Alignment alignment = Qt::AlignCenter, int stretch = 0);
  /// A button that acts when it is clicked; placed in the column, or by the caller.
  QPushButton* addButton(const PageButton& button, const std::function<void()>& act);
  QPushButton* makeButton(const PageButton& button, const std::function<void()>& act);
  /// A pad that acts when it is pressed, not when it is released.
  QPushButton* makePad(const PageButton& button, const std::function<void()>& act);
  /// A pad that acts when it is pressed, and is shown pressed while its stimulus is under the finger.
  QPushButton* makeFeelButton(const PageButton& button, const std::function<void()>& act);

  /// A text of any length: it can be moved with the arrows and the page keys.
  void addLongText(const char* name, const QString& text, int points);

  /// Acts as the button with that key; returns false if no button has it.
  bool press(int key) const;

 private:
  struct Bound {
    int key;
    std::function<void()> act;
  };
  QPushButton* made(const PageButton& button);

  QVBoxLayout* column_;
  std::vector<Bound> keys_;
};

}  // namespace detent::editor
