// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/feel/force_box.h"

#include <QLabel>
#include <QPushButton>
#include <QStringList>
#include <QToolButton>
#include <QVBoxLayout>

#include "editor/document/described.h"
#include "editor/document/form_widgets.h"
#include "editor/feel/force_meter.h"
#include "editor/feel/force_words.h"

namespace detent::editor {

ForceBox::ForceBox(ViewSettings& settings, ForceSession& session, QWidget* parent)
    : QWidget(parent), settings_(settings), session_(session) {
  force_ = described(new QToolButton, "forceSwitch");
  force_->setText(tr("Force"));
  force_->setCheckable(true);
  connect(force_, &QToolButton::clicked, this, [this](bool on) { on ? session_.start() : session_.stop(); });
  status_ = wrappingLabel("forceStatus");
  meter_ = described(new ForceMeter(settings), "forceMeter");
  stability_ = wrappingLabel("forceStability");
  stable_ = described(new QPushButton(tr("&Make button stable")), "nearestStable",
                      tr("Change the button only as much as the device requires: damping first, then slopes; "
                         "peaks keep their force. Can be undone in one step."));
  connect(stable_, &QPushButton::clicked, &session_, &ForceSession::makeStable);

  auto* first = new QHBoxLayout;
  first->addWidget(force_, 0, Qt::AlignTop);
  first->addWidget(status_, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addLayout(first);
  column->addWidget(meter_);
  column->addWidget(stability_);
  column->addWidget(stable_, 0, Qt::AlignLeft);
  connect(&session_, &ForceSession::stateChanged, this, &ForceBox::showState);
  connect(&session_, &ForceSession::moved, this, &ForceBox::showMeters);
  connect(&session_, &ForceSession::marginChanged, this, &ForceBox::showMargin);
  connect(&settings_, &ViewSettings::changed, this, &ForceBox::showMargin);
  showMargin();
}

QString ForceBox::stateWords() const {
  if (!session_.device() && session_.trouble().isEmpty())
    return tr("No force device. Choose one under Setup; simulated devices need no hardware.");
  switch (session_.state()) {
    case ForceState::off:
      return session_.simulated()
                 ? tr("Simulated device: nothing moves in reality. Switch it on to watch it.")
                 : tr("Off: the device applies no force.");
    case ForceState::starting:
      return tr("Opening the force device…");
    case ForceState::lost:
      return tr(
          "The force device is disconnected and applies no force. Detent continues when it is connected "
          "again.");
    case ForceState::failed:
      return tr("No force: %1").arg(session_.trouble());
    case ForceState::on:
      break;
  }
  if (session_.status().homing)
    return tr(
        "No force yet: pull the handle all the way out and push it all the way in, until the light is "
        "green.");
  const QString name = QString::fromStdString(session_.device()->profile.name);
  return session_.simulated() ? tr("Simulated device on: %1").arg(name) : tr("On: %1").arg(name);
}

void ForceBox::showState() {
  const bool chosen = session_.device().has_value();
  force_->setEnabled(chosen);
  force_->setChecked(session_.state() == ForceState::starting || session_.running());
  force_->setToolTip(chosen ? tr("Feel the button as force on the device chosen under Setup")
                            : tr("Choose a force device under Setup first"));
  status_->setText(stateWords());
  meter_->setVisible(chosen);
  if (!session_.running()) meter_->setIdle();
}

void ForceBox::showMeters() {
  if (!session_.running()) return;
  if (const QString words = stateWords(); words != status_->text()) status_->setText(words);
  meter_->show(session_.status(), session_.energy(), session_.device()->profile.limits.force_N);
}

void ForceBox::showMargin() {
  showState();
  const auto& margin = session_.margin();
  stability_->setVisible(margin != nullptr);
  stable_->setVisible(margin && !margin->stable());
  if (!margin) return;
  const Button& button = session_.document()->button();
  QStringList lines{marginWords(*margin, button, settings_.units())};
  if (!session_.changes().empty())
    lines << tr("Changed: %1").arg(changeWords(session_.changes(), button, settings_.units()));
  stability_->setText(lines.join('\n'));
  QStringList remarks;
  for (const playback::ForceRemark& remark : session_.remarks())
    remarks << remarkWords(remark, button, settings_.units());
  stability_->setToolTip(remarks.isEmpty()
                             ? tr("Show in the graph which slopes the device can reproduce without vibrating")
                             : remarks.join('\n'));
}

}  // namespace detent::editor
