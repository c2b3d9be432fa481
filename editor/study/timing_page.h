// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A timed question as a participant sees it: beats, a ball that runs into its window, or the remaining time;
// and a large pad. It shows no button's name.

#include "editor/study/question_page.h"
#include "playback/study.h"

namespace detent::editor {

/// Texts on the page, in the participant's language.
struct TimingWords {
  QString pad, space;  ///< "Press here", "space bar"
  QString left;        ///< "%1 s left"
};

/// Visible state of a trial. Plain value.
struct TimingView {
  playback::TimingTask task = playback::TimingTask::cue;
  std::size_t beats = 0, beatsCome = 0;  ///< cue
  double way = 0,
         /// for a window: TimingController::wayAt, and the length of the window relative to the way to it
      windowShare = 0;
  double left_s = 0, run_s = 1;  ///< tapping

  bool operator==(const TimingView&) const = default;
};

/// The picture above the pad. GUI thread.
class TimingPicture : public QWidget {
 public:
  explicit TimingPicture(const QString& left, QWidget* parent = nullptr);
  void show(const TimingView& view);
  const TimingView& view() const { return view_; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintBeats(QPainter& painter) const;
  void paintWay(QPainter& painter) const;
  void paintLeft(QPainter& painter) const;

  QString left_;
  TimingView view_;
};

/// GUI thread.
class TimingPage : public QuestionPage {
  Q_OBJECT

 public:
  /// `padded`: keys and the pad press. Otherwise a sensor presses, and no pad is shown.
  TimingPage(const TimingWords& words, bool padded, QWidget* parent = nullptr);

  TimingPicture* picture() const { return picture_; }
  /// Null if a sensor presses.
  QPushButton* pad() const { return pad_; }
  /// Result of the previous trial: "hit".
  void showResult(const QString& text) { result_->setText(text); }

 signals:
  void pressed();  ///< The pad or its key was pressed.

 private:
  TimingPicture* picture_;
  QLabel* result_;
  QPushButton* pad_ = nullptr;
};

}  // namespace detent::editor
