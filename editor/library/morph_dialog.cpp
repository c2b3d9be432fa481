// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/library/morph_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "editor/document/described.h"
#include "editor/document/form_widgets.h"
#include "editor/document/message_words.h"
#include "editor/forecast/forecast_words.h"
#include "editor/library/compare_plot.h"
#include "model/blend.h"

namespace detent::editor {
namespace {

constexpr QSize first_px{720, 560}, leastMorphPlot_px{240, 120};
constexpr int plotShare = 3, restShare = 2;
constexpr double morphSideBySideAspect = 1.5;  // width over height from which the plot stands beside the rest

}  // namespace

MorphDialog::MorphDialog(std::vector<Button> buttons, std::size_t first, const DisplayUnits& units,
                         QWidget* parent)
    : QDialog(parent), buttons_(std::move(buttons)), units_(units) {
  setObjectName(QStringLiteral("morphDialog"));
  setWindowTitle(tr("Blend two buttons"));
  from_ = buttonChoice("morphFrom", tr("The button at the left end of the slider"), first);
  to_ = buttonChoice("morphTo", tr("The button at the right end of the slider"), first == 0 ? 1 : 0);
  share_ = described(new QSlider(Qt::Horizontal), QStringLiteral("morphShare"),
                     tr("0 % = first button, 100 % = second"), tr("Blend"));
  share_->setRange(0, 100);
  share_->setValue(50);
  percent_ = described(new QLabel, QStringLiteral("morphPercent"));
  percent_->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("100 %")));
  plot_ = described(new ComparePlot, QStringLiteral("morphPlot"), {}, tr("The three force graphs, overlaid"));
  plot_->setMinimumSize(leastMorphPlot_px);
  forecastFrom_ = wrappingLabel("morphForecastFrom");
  forecastTo_ = wrappingLabel("morphForecastTo");
  auto* way = new QHBoxLayout;
  way->addWidget(share_, 1);
  way->addWidget(percent_);
  auto* form = new QFormLayout;
  form->addRow(tr("&From (A):"), from_);
  form->addRow(tr("&To (B):"), to_);
  auto* name = new QLabel(tr("&Share of B:"));
  name->setBuddy(share_);
  form->addRow(name, way);
  auto* ends = new QDialogButtonBox(QDialogButtonBox::Cancel);
  create_ = described(ends->addButton(tr("&Create"), QDialogButtonBox::AcceptRole),
                      QStringLiteral("morphCreate"), tr("Opens the blended button in a new tab"));
  sides_ = new QBoxLayout(QBoxLayout::TopToBottom);
  auto* rest = new QVBoxLayout;
  rest->addLayout(form);
  rest->addWidget(forecastFrom_);
  rest->addWidget(forecastTo_);
  rest->addStretch();
  sides_->addWidget(plot_, plotShare);
  sides_->addLayout(rest, restShare);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(sides_, 1);
  layout->addWidget(ends);
  connect(ends, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(ends, &QDialogButtonBox::rejected, this, &QDialog::reject);
  for (QComboBox* box : {from_, to_})
    connect(box, &QComboBox::currentIndexChanged, this, &MorphDialog::follow);
  connect(share_, &QSlider::valueChanged, this, &MorphDialog::follow);
  connect(&source_, &ForecastSource::ready, this, [this](const auto& forecast) { say(*forecast); });
  resize(first_px);
  follow();
}

// In a low window the graphs have its whole height.
void MorphDialog::resizeEvent(QResizeEvent* event) {
  QDialog::resizeEvent(event);
  const bool beside = width() > morphSideBySideAspect * height();
  sides_->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  sides_->setStretch(1, beside ? restShare : 0);
}

QComboBox* MorphDialog::buttonChoice(const char* name, const QString& tip, std::size_t chosen) {
  auto* box = described(new QComboBox, QString::fromLatin1(name), tip, tip);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  for (const Button& button : buttons_) box->addItem(QString::fromStdString(button.name()));
  box->setCurrentIndex(static_cast<int>(chosen));
  return box;
}

const Button& MorphDialog::chosen(const QComboBox& box) const {
  return buttons_[static_cast<std::size_t>(box.currentIndex())];
}

void MorphDialog::follow() {
  percent_->setText(QStringLiteral("%1 %").arg(share_->value()));
  const Button &from = chosen(*from_), &to = chosen(*to_);
  auto found = detent::between(from, to, share_->value() / 100.0);
  create_->setEnabled(found.ok());
  forecastTo_->clear();
  if (!found) {
    between_.reset();
    source_.cancel();
    plot_->setGraphs({}, units_);
    return forecastFrom_->setText(sentenceOf(found.failure(), units_));
  }
  between_ = *std::move(found);
  plot_->setGraphs({{QStringLiteral("A"), from.states().front().graph},
                    {QStringLiteral("B"), to.states().front().graph},
                    {QStringLiteral("A\u2013B"), between_->states().front().graph}},
                   units_);
  source_.request({*between_, from, to}, ForecastPairs::ofFirst);
}

void MorphDialog::say(const Forecast& forecast) {
  if (forecast.pairs.size() != 2) return forecastFrom_->setText(forecast.trouble);
  forecastFrom_->setText(tr("Compared with A: %1").arg(forecastWords(forecast.pairs[0])));
  forecastTo_->setText(tr("Compared with B: %1").arg(forecastWords(forecast.pairs[1])));
}

}  // namespace detent::editor
