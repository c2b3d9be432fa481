// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/study/timing_page.h"

#include <algorithm>
#include <cmath>
#include <QPainter>

namespace detent::editor {

namespace {

constexpr int pictureHeight_px = 180, line_px = 4;
constexpr double beatRadius_px = 26, cueRadius_px = 44, ballRadius_px = 18;
constexpr double windowAt = 0.7;  // share of the width at which the ball enters its window
constexpr double barHeight_px = 40;

}  // namespace

TimingPicture::TimingPicture(const QString& left, QWidget* parent) : QWidget(parent), left_(left) {
  setObjectName("studyPicture");
  setMinimumHeight(pictureHeight_px);
}

void TimingPicture::show(const TimingView& view) {
  view_ = view;
  update();
}

void TimingPicture::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(palette().color(QPalette::WindowText), line_px));
  switch (view_.task) {
    case playback::TimingTask::cue:
      return paintBeats(painter);
    case playback::TimingTask::window:
      return paintWay(painter);
    case playback::TimingTask::tapping:
      return paintLeft(painter);
  }
}

/// Paints as many circles as beats, filled as they come; the one to press with is the largest.
void TimingPicture::paintBeats(QPainter& painter) const {
  const double step_px = static_cast<double>(width()) / static_cast<double>(view_.beats + 1);
  for (std::size_t i = 0; i < view_.beats; ++i) {
    const double radius_px = i + 1 == view_.beats ? cueRadius_px : beatRadius_px;
    painter.setBrush(i < view_.beatsCome ? palette().brush(QPalette::Highlight) : QBrush(Qt::NoBrush));
    painter.drawEllipse(QPointF(step_px * static_cast<double>(i + 1), height() / 2.0), radius_px, radius_px);
  }
}

/// The ball's middle counts: it is between the bars while the window is open.
void TimingPicture::paintWay(QPainter& painter) const {
  const double from_px = ballRadius_px + line_px, way_px = windowAt * width() - from_px,
               middle_px = height() / 2.0;
  const double tall_px = std::min(2.5 * ballRadius_px, middle_px - line_px);
  painter.fillRect(QRectF(from_px + way_px, middle_px - tall_px, way_px * view_.windowShare, 2 * tall_px),
                   palette().brush(QPalette::AlternateBase));
  for (const double bar : {0.0, view_.windowShare}) {
    const double x_px = from_px + way_px * (1 + bar);
    painter.drawLine(QPointF(x_px, middle_px - tall_px), QPointF(x_px, middle_px + tall_px));
  }
  if (view_.way < 0) return;
  painter.setPen(Qt::NoPen);
  painter.setBrush(palette().brush(QPalette::Highlight));
  const double x_px = std::min(from_px + way_px * view_.way, width() - ballRadius_px);
  painter.drawEllipse(QPointF(x_px, middle_px), ballRadius_px, ballRadius_px);
}

void TimingPicture::paintLeft(QPainter& painter) const {
  const double middle_px = height() / 2.0, whole_px = width() - 2.0 * line_px;
  const double share = std::clamp(view_.left_s / view_.run_s, 0.0, 1.0);
  painter.fillRect(QRectF(line_px, middle_px - barHeight_px / 2, whole_px * share, barHeight_px),
                   palette().brush(QPalette::Highlight));
  painter.drawRect(QRectF(line_px, middle_px - barHeight_px / 2, whole_px, barHeight_px));
  QFont font = painter.font();
  font.setPointSize(plainText_pt);
  painter.setFont(font);
  painter.drawText(QRectF(0, middle_px + barHeight_px / 2, width(), middle_px - barHeight_px / 2),
                   Qt::AlignCenter, left_.arg(std::ceil(view_.left_s)));
}

TimingPage::TimingPage(const TimingWords& words, bool padded, QWidget* parent)
    : QuestionPage(parent), picture_(new TimingPicture(words.left)) {
  column()->addWidget(picture_, 1);
  result_ = addText("studyResult", QStringLiteral(" "), largeText_pt);
  if (padded) {
    pad_ = makePad({"studyPad", words.pad, {Qt::Key_Space, words.space}, largeText_pt, pressHeight_px},
                   [this] { emit pressed(); });
    pad_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    column()->addWidget(pad_, 2);
  }
  addBottom();
}

}  // namespace detent::editor
