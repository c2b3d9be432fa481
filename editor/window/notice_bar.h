// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Messages beside the part of the window that they concern. They do not stop the work, as a dialogue would.

#include <functional>
#include <QFrame>
#include <QVBoxLayout>
#include <vector>

namespace detent::editor {

/// A column of notices above the widget that they concern; hidden without notices. GUI thread.
class NoticeBar : public QWidget {
  Q_OBJECT

 public:
  enum class Kind { information, trouble };

  /// A button of a notice; pressing it removes the notice.
  struct Choice {
    QString objectName;
    QString text;
    std::function<void()> act;
  };

  explicit NoticeBar(QWidget* parent = nullptr);

  /// A notice with the same `id` is replaced. Announced to screen readers.
  void say(const QString& id, Kind kind, const QString& text, const std::vector<Choice>& choices = {});
  void dismiss(const QString& id);
  /// Current texts, oldest first.
  QStringList texts() const;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QFrame* rowOf(const QString& id) const;
  QVBoxLayout* rows_;
};

}  // namespace detent::editor
