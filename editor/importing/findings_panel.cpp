// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/findings_panel.h"

#include <algorithm>
#include <QCoreApplication>
#include <QEvent>
#include <QListWidget>
#include <QPushButton>
#include <QScrollBar>
#include <utility>

#include "editor/document/described.h"
#include "editor/importing/finding_words.h"

namespace detent::editor {
namespace {

constexpr int least_px = 270, mostOfLeast_px = 300;  // in a narrower window the panel scrolls sideways
constexpr int usual_px = 340;                        // width from which no text has to wrap

}  // namespace

FindingsPanel::FindingsPanel(ImportState& state, ViewSettings& settings, QWidget* parent)
    : QScrollArea(parent),
      state_(state),
      settings_(settings),
      confidence_(new QLabel),
      cause_(wrappedLabel()),
      steps_(wrappedLabel()),
      sure_(new QProgressBar),
      confirmed_(new QCheckBox(tr("I have checked it against the page"))),
      switches_(new SwitchesBox(state)),
      x_(new AxisBox(state, GraphAxis::x)),
      y_(new AxisBox(state, GraphAxis::y)),
      curves_(new CurvesBox(state, settings)),
      result_(new ResultBox(settings)) {
  setObjectName(QStringLiteral("findingsPanel"));
  setAccessibleName(tr("Findings and corrections"));
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setMinimumWidth(least_px);
  build();
  connectState();
  refresh();
}

void FindingsPanel::build() {
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(8, 4, 8, 8);
  column->setSizeConstraint(QLayout::SetMinimumSize);
  addConfidence(*column);
  column->addWidget(switches_);
  column->addWidget(frameBox_ = frameBox());
  for (QWidget* box : std::initializer_list<QWidget*>{x_, y_, curves_, result_}) column->addWidget(box);
  column->addStretch();
  setWidget(content);
  connect(curves_, &CurvesBox::toolRequested, this, &FindingsPanel::toolRequested);
  for (AxisBox* box : {x_, y_})
    connect(box, &AxisBox::ticksRequested, this, [this] { emit toolRequested(PageToolKind::scale); });
}

// Widens the panel to its text, which differs between languages.
bool FindingsPanel::eventFilter(QObject* object, QEvent* event) {
  const bool handled = QScrollArea::eventFilter(object, event);
  if (object != widget() || event->type() != QEvent::LayoutRequest) return handled;
  const int bar_px = verticalScrollBar()->sizeHint().width();
  const int least = widget()->minimumSizeHint().width() + bar_px;
  setMinimumWidth(std::clamp(least, least_px, mostOfLeast_px));
  const int now_px = std::max(least, std::min(widget()->sizeHint().width() + bar_px, usual_px));
  if (now_px > std::exchange(wanted_px_, now_px)) emit widthWanted(now_px);
  return handled;
}

void FindingsPanel::addConfidence(QVBoxLayout& column) {
  QFont large = confidence_->font();
  large.setPointSizeF(1.25 * large.pointSizeF());
  large.setBold(true);
  confidence_->setFont(large);
  confidence_->setObjectName(QStringLiteral("confidence"));
  sure_->setRange(0, 100);
  sure_->setTextVisible(false);
  sure_->setFixedHeight(6);
  sure_->setAccessibleName(tr("How sure the import is, in percent"));
  steps_->setForegroundRole(QPalette::PlaceholderText);
  confirmed_->setObjectName(QStringLiteral("confirmed"));
  confirmed_->setToolTip(tr("Allows an uncertain result to be imported"));
  connect(confirmed_, &QCheckBox::clicked, &state_, &ImportState::setConfirmed);
  cause_->setObjectName(QStringLiteral("confidenceCause"));
  // Widgets that appear and disappear keep their space, so that the fields below do not move under a click.
  reserveLines(*cause_, 3);
  reserveLines(*steps_, 2);
  for (QWidget* each : std::initializer_list<QWidget*>{sure_, cause_, steps_, confirmed_}) {
    QSizePolicy keepsRoom = each->sizePolicy();
    keepsRoom.setRetainSizeWhenHidden(true);
    each->setSizePolicy(keepsRoom);
  }
  for (QWidget* each : std::initializer_list<QWidget*>{confidence_, sure_, cause_, steps_, confirmed_})
    column.addWidget(each);
}

QGroupBox* FindingsPanel::frameBox() {
  auto* box = new QGroupBox(tr("Plot frame"));
  auto* draw = described(new QPushButton(tr("Draw…")), "drawFrame", tr("Drag a new plot frame on the page"));
  connect(draw, &QPushButton::clicked, this, [this] { emit toolRequested(PageToolKind::drawFrame); });
  frameOrigin_ = new OriginMark(state_, QStringLiteral("resetFrame"), tr("Reset plot frame"),
                                [](Corrections& c) { c.frame.reset(); });
  frameDetails_ = wrappedLabel();
  frameDetails_->setForegroundRole(QPalette::PlaceholderText);
  auto* row = new QHBoxLayout;
  row->addWidget(draw);
  row->addStretch();
  row->addWidget(frameOrigin_);
  auto* column = new QVBoxLayout(box);
  column->addLayout(row);
  column->addWidget(frameDetails_);
  return box;
}

// Shows several changes by one answer together.
void FindingsPanel::connectState() {
  soon_.setSingleShot(true);
  soon_.setInterval(0);
  connect(&soon_, &QTimer::timeout, this, &FindingsPanel::refresh);
  const auto refreshSoon = [this] { soon_.start(); };
  connect(&state_, &ImportState::correctionsChanged, this, refreshSoon);
  connect(&state_, &ImportState::resultChanged, this, refreshSoon);
  connect(&state_, &ImportState::graphsChanged, this, refreshSoon);
  connect(&state_, &ImportState::currentChanged, this, refreshSoon);
  connect(&state_, &ImportState::documentChanged, this, &FindingsPanel::refresh);
  connect(&settings_, &ViewSettings::changed, this, &FindingsPanel::refresh);
}

void FindingsPanel::refresh() {
  const ImportGraph* graph = state_.current();
  widget()->setVisible(graph != nullptr);
  const auto bars = graph ? Qt::ScrollBarAsNeeded : Qt::ScrollBarAlwaysOff;
  setHorizontalScrollBarPolicy(bars);
  setVerticalScrollBarPolicy(bars);
  if (!graph) return;
  const bool log = state_.isForceLog();
  const auto shown = graph->good ? graph->good : graph->last;
  const auto evidence = shown ? shown->evidence : nullptr;
  showConfidence(*graph);
  showSteps(evidence);
  switches_->follow();
  frameBox_->setVisible(!log);
  showFrame(*graph, evidence);
  for (AxisBox* box : {x_, y_}) box->follow(log);
  curves_->follow(log);
  result_->follow(graph->good ? graph->good->report.get() : nullptr, graph->refusedMarks);
  settleLayout();
}

void FindingsPanel::showConfidence(const ImportGraph& graph) {
  const bool failed = graph.last && graph.last->failure;
  const importer::ImportReport* report = graph.good ? graph.good->report.get() : nullptr;
  const int percent = report ? qRound(100 * report->confidence) : 0;
  if (report)
    confidence_->setText(failed          ? tr("Last valid result (%1 % confidence)").arg(percent)
                         : report->doubt ? tr("Confidence %1 %: check before importing").arg(percent)
                                         : tr("Confidence %1 %").arg(percent));
  else if (const auto ticked = graph.tickedCurves.size(); ticked > 0 && !state_.working())
    confidence_->setText(ticked == 1 ? tr("1 switch will be imported")
                                     : tr("%1 switches will be imported").arg(ticked));
  else
    confidence_->setText(state_.working() ? tr("Reading the graph …") : tr("Not readable yet"));
  const QString explanation = graph.last ? QString::fromStdString(graph.last->explanation) : QString();
  confidence_->setToolTip(
      explanation.isEmpty() ? QString() : QStringLiteral("<pre>%1</pre>").arg(explanation.toHtmlEscaped()));
  confidence_->setAccessibleDescription(explanation);
  const QString cause = report ? causeOf(*report, settings_.units()) : QString();
  cause_->setText(cause.isEmpty() ? QString() : tr("reason: %1").arg(cause));
  cause_->setVisible(!cause.isEmpty());
  sure_->setValue(percent);
  sure_->setVisible(report != nullptr);
  confirmed_->setVisible(report && report->doubt && !failed);
  confirmed_->setChecked(graph.confirmed);
}

void FindingsPanel::showSteps(const std::shared_ptr<const importer::GraphEvidence>& evidence) {
  QStringList steps, reasons;
  if (evidence)
    for (const auto& step : evidence->steps) {
      steps << tr("%1 %2 %").arg(nameOfFinding(step.step)).arg(qRound(100 * step.confidence));
      if (!step.evidence.empty())
        reasons << tr("%1: %2").arg(nameOfFinding(step.step), inWords(step.evidence, settings_.units()));
    }
  steps_->setText(steps.join(QStringLiteral(" · ")));
  steps_->setToolTip(reasons.join('\n'));
  steps_->setAccessibleDescription(reasons.join('\n'));
  steps_->setVisible(!steps.isEmpty());
}

void FindingsPanel::showFrame(const ImportGraph& graph,
                              const std::shared_ptr<const importer::GraphEvidence>& evidence) {
  frameOrigin_->setOrigin(graph.framedByHand(), confidenceOf(evidence, importer::ImportStep::locate));
  frameOrigin_->setResettable(graph.framedByHand() && graph.listed.has_value());
  const auto* found = stepOf(evidence, importer::ImportStep::locate);
  frameDetails_->setText(found ? inWords(found->evidence, settings_.units()) : QString());
  frameDetails_->setVisible(found && !found->evidence.empty() && !graph.framedByHand());
}

/// Applies a change of visibility at once, so that the content is not drawn compressed in between.
void FindingsPanel::settleLayout() {
  widget()->layout()->activate();
  QEvent request(QEvent::LayoutRequest);
  QCoreApplication::sendEvent(widget(), &request);
}

void FindingsPanel::focusField(GraphAxis which) {
  QLineEdit* edit = axis(which).firstField();
  ensureWidgetVisible(edit);
  edit->setFocus();
  edit->selectAll();
}

void FindingsPanel::focusUnit(GraphAxis which) {
  ensureWidgetVisible(axis(which).unitField());
  axis(which).unitField()->setFocus();
}

void FindingsPanel::focusDpi() {
  ensureWidgetVisible(curves_->resolutionField());
  curves_->resolutionField()->setFocus();
}

void FindingsPanel::focusSwitches() {
  ensureWidgetVisible(switches_);
  if (auto* list = switches_->findChild<QListWidget*>()) list->setFocus();
}

bool FindingsPanel::acceptable() {
  QWidget* refused = x_->refusedField();
  if (!refused) refused = y_->refusedField();
  if (!refused && !curves_->resolutionField()->acceptable()) refused = curves_->resolutionField();
  if (!refused) return true;
  ensureWidgetVisible(refused);
  refused->setFocus();
  return false;
}

}  // namespace detent::editor
