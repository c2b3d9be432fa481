// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/importing/findings_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <QToolTip>
#include <QVBoxLayout>

#include "editor/document/graph_colors.h"
#include "editor/importing/axis_quantity.h"
#include "editor/importing/finding_words.h"
#include "editor/quantity/quantity_field.h"

namespace detent::editor {
namespace {

constexpr std::array lengthUnits{LengthUnit::millimetre, LengthUnit::centimetre, LengthUnit::micrometre,
                                 LengthUnit::inch, LengthUnit::mil};
constexpr std::array forceUnits{ForceUnit::newton,    ForceUnit::centinewton,   ForceUnit::millinewton,
                                ForceUnit::gramForce, ForceUnit::kilogramForce, ForceUnit::ounceForce,
                                ForceUnit::poundForce};

QString symbol(std::string_view utf8) {
  return QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
}

QString number(double value, int digits = 5) { return numberText(value, digits); }

QIcon swatch(std::optional<importer::Rgb> color, const QColor& otherwise, const QPalette& palette) {
  QPixmap pixmap(22, 14);
  pixmap.fill(color ? QColor(color->r, color->g, color->b) : otherwise);
  QPainter painter(&pixmap);
  painter.setPen(palette.color(QPalette::Mid));
  painter.drawRect(0, 0, 21, 13);
  return QIcon(pixmap);
}

/// "found, 98 %" or "given", and the way back.
struct Origin {
  QLabel* words = nullptr;
  QToolButton* reset = nullptr;

  void set(bool given, std::optional<double> confidence) const {
    reset->setVisible(given);
    QFont font = words->font();
    font.setBold(given);
    words->setFont(font);
    if (given) {
      words->setText(QObject::tr("given"));
    } else {
      words->setText(confidence ? QObject::tr("found, %1 % sure").arg(qRound(100 * *confidence)) : QString());
    }
  }
};

struct AxisFields {
  QGroupBox* box = nullptr;
  QLineEdit *min = nullptr, *max = nullptr;
  QComboBox* unit = nullptr;
  Origin range, unitOrigin;
  QLabel* details = nullptr;
  std::vector<QWidget*> ofPage;              ///< what a force meter's log has no use for
  std::optional<double> minShown, maxShown;  ///< as they stand, in the printed unit
};

// What cannot be read stays as typed, marked, with the reason beside it.
void showRefusal(QLineEdit& edit, const QString& why) {
  QPalette colors = edit.palette();
  colors.setColor(QPalette::Text, why.isEmpty() ? edit.parentWidget()->palette().color(QPalette::Text)
                                                : graphColors(isDark(edit.palette())).refused);
  edit.setPalette(colors);
  edit.setAccessibleDescription(why);
  if (why.isEmpty()) return QToolTip::hideText();
  QToolTip::showText(edit.mapToGlobal(edit.rect().bottomLeft()), why, &edit);
}

QLabel* wrapped(QLabel* label) {
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Minimum);
  return label;
}

const importer::StepFinding* stepOf(const std::shared_ptr<const importer::GraphEvidence>& evidence,
                                    importer::ImportStep step) {
  if (!evidence) return nullptr;
  for (const auto& each : evidence->steps) {
    if (each.step == step) return &each;
  }
  return nullptr;
}

QString axisTitle(GraphAxis axis, bool ofLog) {
  if (axis == GraphAxis::x)
    return ofLog ? QObject::tr("Displacement in the file") : QObject::tr("Displacement axis (horizontal)");
  return ofLog ? QObject::tr("Force in the file") : QObject::tr("Force axis (vertical)");
}

std::optional<double> confidenceOf(const std::shared_ptr<const importer::GraphEvidence>& evidence,
                                   importer::ImportStep step) {
  const auto* found = stepOf(evidence, step);
  if (!found) return {};
  return found->confidence;
}

/// Ink of the curve that a stroke was traced on; transparent if it is not known.
QColor colorOfStroke(const std::shared_ptr<const ImportedGraph>& imported, Stroke stroke) {
  const QColor unknown(Qt::transparent);
  if (!imported || !imported->report || !imported->evidence) return unknown;
  const importer::StrokePair& pair = imported->report->strokes;
  const importer::StrokePoints* points = stroke == Stroke::press ? &pair.press
                                         : pair.release          ? &*pair.release
                                                                 : nullptr;
  if (!points || points->points_px.empty()) return unknown;
  const importer::Point middle = points->points_px[points->points_px.size() / 2];
  for (const auto& trace : imported->evidence->traces) {
    const bool on = std::any_of(trace.points_px.begin(), trace.points_px.end(), [&](importer::Point p) {
      return std::hypot(p.x - middle.x, p.y - middle.y) < 1.5;
    });
    if (on) return {trace.color.r, trace.color.g, trace.color.b};
  }
  return unknown;
}

}  // namespace

struct FindingsPanel::Fields {
  QLabel* confidence = nullptr;
  QProgressBar* sure = nullptr;
  QLabel* steps = nullptr;
  QCheckBox* confirmed = nullptr;
  QGroupBox *frameBox = nullptr, *curveBox = nullptr, *resultBox = nullptr;
  Origin frame;
  QLabel* frameDetails = nullptr;
  AxisFields x, y;
  QPushButton *pressColor = nullptr, *releaseColor = nullptr;
  Origin press, release;
  QCheckBox* swap = nullptr;
  std::vector<QWidget*> curvesOfPage;
  QLabel *strokes = nullptr, *masks = nullptr;
  QToolButton* noMasks = nullptr;
  QuantityField* dpi = nullptr;
  Origin dpiOrigin;
  QLabel *result = nullptr, *checks = nullptr, *warnings = nullptr, *seconds = nullptr;

  AxisFields& axis(GraphAxis which) { return which == GraphAxis::x ? x : y; }
};

FindingsPanel::FindingsPanel(ImportState& state, ViewSettings& settings, QWidget* parent)
    : QScrollArea(parent), state_(state), settings_(settings), fields_(std::make_unique<Fields>()) {
  setObjectName(QStringLiteral("findingsPanel"));
  setAccessibleName(tr("Findings and corrections"));
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFrameShape(QFrame::NoFrame);
  setMinimumWidth(300);
  build();
  // One answer changes several things: they are shown together, once.
  soon_.setSingleShot(true);
  soon_.setInterval(0);
  connect(&soon_, &QTimer::timeout, this, &FindingsPanel::refresh);
  const auto refreshSoon = [this] { soon_.start(); };
  connect(&state_, &ImportState::correctionsChanged, this, refreshSoon);
  connect(&state_, &ImportState::resultChanged, this, refreshSoon);
  connect(&state_, &ImportState::currentChanged, this, refreshSoon);
  connect(&state_, &ImportState::documentChanged, this, &FindingsPanel::refresh);
  connect(&settings_, &ViewSettings::changed, this, &FindingsPanel::refresh);
  refresh();
}

FindingsPanel::~FindingsPanel() = default;

void FindingsPanel::change(const QString& label, const std::function<void(Corrections&)>& edit) {
  if (!state_.current()) return;
  Corrections next = state_.current()->history.now();
  edit(next);
  state_.apply(next, label);
}

void FindingsPanel::build() {
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(8, 4, 8, 8);
  column->setSizeConstraint(QLayout::SetMinimumSize);
  Fields& f = *fields_;

  const auto origin = [&](QHBoxLayout* row, const QString& name, const QString& label,
                          const std::function<void(Corrections&)>& reset) {
    Origin made;
    row->addWidget(made.words = new QLabel);
    made.words->setForegroundRole(QPalette::PlaceholderText);
    row->addWidget(made.reset = new QToolButton);
    made.reset->setText(tr("Reset"));
    made.reset->setObjectName(name);
    made.reset->setAutoRaise(true);
    made.reset->setToolTip(tr("Back to what was found"));
    made.reset->setAccessibleName(label);
    made.reset->setVisible(false);
    connect(made.reset, &QToolButton::clicked, this, [this, label, reset] { change(label, reset); });
    return made;
  };

  column->addWidget(f.confidence = new QLabel);
  QFont large = f.confidence->font();
  large.setPointSizeF(1.25 * large.pointSizeF());
  large.setBold(true);
  f.confidence->setFont(large);
  f.confidence->setObjectName(QStringLiteral("confidence"));
  column->addWidget(f.sure = new QProgressBar);
  f.sure->setRange(0, 100);
  f.sure->setTextVisible(false);
  f.sure->setFixedHeight(6);
  f.sure->setAccessibleName(tr("How sure the import is, in percent"));
  column->addWidget(f.steps = wrapped(new QLabel));
  column->addWidget(f.confirmed = new QCheckBox(tr("I have checked it against the page")));
  f.confirmed->setObjectName(QStringLiteral("confirmed"));
  f.confirmed->setToolTip(tr("Lets a result that is in doubt be imported"));
  connect(f.confirmed, &QCheckBox::clicked, &state_, &ImportState::setConfirmed);

  // Plot frame
  column->addWidget(f.frameBox = new QGroupBox(tr("Plot frame")));
  auto* frameColumn = new QVBoxLayout(f.frameBox);
  auto* frameRow = new QHBoxLayout;
  auto* draw = new QPushButton(tr("Draw…"));
  draw->setObjectName(QStringLiteral("drawFrame"));
  draw->setToolTip(tr("Drag a new plot frame on the page"));
  connect(draw, &QPushButton::clicked, this, [this] { emit toolAsked(ToolKind::drawFrame); });
  frameRow->addWidget(draw);
  frameRow->addStretch();
  f.frame = origin(frameRow, QStringLiteral("resetFrame"), tr("Reset plot frame"),
                   [](Corrections& c) { c.frame.reset(); });
  frameColumn->addLayout(frameRow);
  frameColumn->addWidget(f.frameDetails = wrapped(new QLabel));

  // Axes
  for (const GraphAxis axis : {GraphAxis::x, GraphAxis::y}) {
    const bool isX = axis == GraphAxis::x;
    AxisFields& a = f.axis(axis);
    column->addWidget(a.box = new QGroupBox(axisTitle(axis, false)));
    auto* axisColumn = new QVBoxLayout(a.box);
    auto* row = new QHBoxLayout;
    auto* to = new QLabel(tr("to"));
    row->addWidget(a.min = new QLineEdit);
    row->addWidget(to);
    row->addWidget(a.max = new QLineEdit);
    row->addWidget(a.unit = new QComboBox);
    a.min->setObjectName(isX ? QStringLiteral("xMin") : QStringLiteral("yMin"));
    a.max->setObjectName(isX ? QStringLiteral("xMax") : QStringLiteral("yMax"));
    a.unit->setObjectName(isX ? QStringLiteral("xUnit") : QStringLiteral("yUnit"));
    a.min->setAccessibleName(isX ? tr("Displacement at the left edge of the plot frame")
                                 : tr("Force at the lower edge of the plot frame"));
    a.max->setAccessibleName(isX ? tr("Displacement at the right edge of the plot frame")
                                 : tr("Force at the upper edge of the plot frame"));
    a.unit->setAccessibleName(isX ? tr("Unit of the displacement axis as printed")
                                  : tr("Unit of the force axis as printed"));
    for (QLineEdit* edit : {a.min, a.max}) {
      edit->setMinimumWidth(56);
      edit->setToolTip(edit->accessibleName() + tr(", in the printed unit"));
    }
    if (isX) {
      for (const LengthUnit unit : lengthUnits) a.unit->addItem(symbol(symbolOf(unit)));
    } else {
      for (const ForceUnit unit : forceUnits) a.unit->addItem(symbol(symbolOf(unit)));
    }
    a.unit->setPlaceholderText(tr("as found"));
    a.unit->setToolTip(a.unit->accessibleName());
    connect(a.min, &QLineEdit::editingFinished, this, [this, axis] { takeEnd(axis, false); });
    connect(a.max, &QLineEdit::editingFinished, this, [this, axis] { takeEnd(axis, true); });
    connect(a.unit, &QComboBox::activated, this, [this, isX](int index) {
      const auto i = static_cast<std::size_t>(index);
      change(isX ? tr("Displacement unit") : tr("Force unit"), [&](Corrections& c) {
        if (isX) {
          c.xUnit = lengthUnits[i];
        } else {
          c.yUnit = forceUnits[i];
        }
      });
    });
    axisColumn->addLayout(row);
    auto* origins = new QHBoxLayout;
    auto* ticks = new QPushButton(tr("Set on page…"));
    ticks->setToolTip(tr("Click ticks of the axis on the page and type their values"));
    connect(ticks, &QPushButton::clicked, this, [this] { emit toolAsked(ToolKind::scale); });
    origins->addWidget(ticks);
    origins->addStretch();
    auto* rangeName = new QLabel(tr("Range:"));
    origins->addWidget(rangeName);
    a.ofPage = {a.min, to, a.max, ticks, rangeName};
    a.range = origin(origins, isX ? QStringLiteral("resetX") : QStringLiteral("resetY"),
                     isX ? tr("Reset displacement axis") : tr("Reset force axis"),
                     [axis](Corrections& c) { c.axis(axis) = {}; });
    axisColumn->addLayout(origins);
    auto* unitRow = new QHBoxLayout;
    auto* unitName = new QLabel(tr("Unit:"));
    unitRow->addStretch();
    unitRow->addWidget(unitName);
    a.ofPage.push_back(unitName);
    a.unitOrigin =
        origin(unitRow, isX ? QStringLiteral("resetXUnit") : QStringLiteral("resetYUnit"),
               isX ? tr("Reset displacement unit") : tr("Reset force unit"), [isX](Corrections& c) {
                 if (isX)
                   c.xUnit.reset();
                 else
                   c.yUnit.reset();
               });
    axisColumn->addLayout(unitRow);
    axisColumn->addWidget(a.details = wrapped(new QLabel));
  }

  // Curves
  column->addWidget(f.curveBox = new QGroupBox(tr("Curves")));
  auto* curves = new QVBoxLayout(f.curveBox);
  const auto colorRow = [&](QPushButton*& button, Origin& made, const QString& text, const QString& name,
                            ToolKind tool, bool isPress) {
    auto* row = new QHBoxLayout;
    row->addWidget(button = new QPushButton(text));
    button->setObjectName(name);
    button->setToolTip(isPress ? tr("Click the press curve on the page")
                               : tr("Click the release curve on the page"));
    connect(button, &QPushButton::clicked, this, [this, tool] { emit toolAsked(tool); });
    row->addStretch();
    made = origin(row, name + QStringLiteral("Reset"),
                  isPress ? tr("Reset press curve") : tr("Reset release curve"), [isPress](Corrections& c) {
                    (isPress ? c.pressColor : c.releaseColor).reset();
                    (isPress ? c.drawn.press : c.drawn.release).clear();
                  });
    curves->addLayout(row);
  };
  colorRow(f.pressColor, f.press, tr("Press curve…"), QStringLiteral("pickPress"), ToolKind::pressColor,
           true);
  colorRow(f.releaseColor, f.release, tr("Release curve…"), QStringLiteral("pickRelease"),
           ToolKind::releaseColor, false);
  curves->addWidget(f.swap = new QCheckBox(tr("Exchange press and release")));
  f.swap->setObjectName(QStringLiteral("swapStrokes"));
  connect(f.swap, &QCheckBox::clicked, this,
          [this](bool on) { change(tr("Exchange strokes"), [on](Corrections& c) { c.swapStrokes = on; }); });
  curves->addWidget(f.strokes = wrapped(new QLabel));
  auto* maskRow = new QHBoxLayout;
  auto* box = new QPushButton(tr("Mask…"));
  box->setToolTip(tr("Drag rectangles over what is not a curve"));
  connect(box, &QPushButton::clicked, this, [this] { emit toolAsked(ToolKind::maskBox); });
  maskRow->addWidget(box);
  maskRow->addWidget(f.masks = new QLabel);
  maskRow->addStretch();
  maskRow->addWidget(f.noMasks = new QToolButton);
  f.noMasks->setText(tr("Remove all"));
  f.noMasks->setAutoRaise(true);
  f.noMasks->setObjectName(QStringLiteral("removeMasks"));
  connect(f.noMasks, &QToolButton::clicked, this,
          [this] { change(tr("Remove masks"), [](Corrections& c) { c.masks.clear(); }); });
  curves->addLayout(maskRow);
  auto* dpiRow = new QHBoxLayout;
  auto* dpiLabel = new QLabel(tr("Resolution"));
  dpiRow->addWidget(dpiLabel);
  dpiRow->addWidget(f.dpi = new QuantityField(Quantity::resolution, {}));
  dpiLabel->setBuddy(f.dpi);
  f.dpi->setObjectName(QStringLiteral("dpi"));
  f.dpi->setRange({0, 1200});
  f.dpi->setLowestText(tr("by quality"));
  f.dpi->setKeyboardTracking(false);
  f.dpi->setToolTip(
      tr("Resolution at which a page of a document is drawn before it is traced, in dots per inch"));
  f.dpi->setAccessibleName(f.dpi->toolTip());
  connect(f.dpi, &QuantityField::valueChanged, this, [this](double value) {
    change(tr("Resolution"), [value](Corrections& c) {
      if (value > 0)
        c.dpi = value;
      else
        c.dpi.reset();
    });
  });
  dpiRow->addStretch();
  f.dpiOrigin = origin(dpiRow, QStringLiteral("resetDpi"), tr("Reset resolution"),
                       [](Corrections& c) { c.dpi.reset(); });
  curves->addLayout(dpiRow);

  f.curvesOfPage = {f.pressColor, f.releaseColor, box, f.masks, dpiLabel, f.dpi};

  // Result
  column->addWidget(f.resultBox = new QGroupBox(tr("Result")));
  auto* results = new QVBoxLayout(f.resultBox);
  results->addWidget(f.result = wrapped(new QLabel));
  results->addWidget(f.checks = wrapped(new QLabel));
  results->addWidget(f.warnings = wrapped(new QLabel));
  results->addWidget(f.seconds = wrapped(new QLabel));
  f.warnings->setObjectName(QStringLiteral("warnings"));
  f.checks->setObjectName(QStringLiteral("specChecks"));
  f.seconds->setObjectName(QStringLiteral("seconds"));
  f.result->setObjectName(QStringLiteral("result"));
  f.seconds->setForegroundRole(QPalette::PlaceholderText);
  for (QLabel* reason : {f.steps, f.frameDetails, f.x.details, f.y.details, f.strokes})
    reason->setForegroundRole(QPalette::PlaceholderText);
  column->addStretch();
  setWidget(content);
}

void FindingsPanel::takeEnd(GraphAxis axis, bool isMax) {
  AxisFields& a = fields_->axis(axis);
  QLineEdit* edit = isMax ? a.max : a.min;
  if (!edit->isModified()) return;
  const AxisQuantity asked = axisQuantity(axis, a.unit->currentText().toStdString());
  const auto typed = [&](const QLineEdit* field) {
    std::optional<double> now = field == a.max ? a.maxShown : a.minShown;
    if (now) *now *= shownUnitOf(asked.quantity, asked.units);
    return readQuantity(field->text(), asked.quantity, asked.units, now);
  };
  const QuantityReading value = typed(edit), other = typed(isMax ? a.min : a.max);
  showRefusal(*edit, value.value ? QString() : refusalOf(value, asked.quantity, asked.units));
  if (!value.value) return;  // as typed, so that it can be mended
  edit->setModified(false);
  change(axis == GraphAxis::x ? tr("Displacement range") : tr("Force range"), [&](Corrections& c) {
    AxisCorrection& correction = c.axis(axis);
    // Ticks given before say where the other end is; from now on the ends are given.
    if (!correction.ticks.empty())
      (isMax ? correction.min : correction.max) = other.value ? std::optional(other.shown) : std::nullopt;
    correction.ticks.clear();
    (isMax ? correction.max : correction.min) = value.shown;
  });
}

void FindingsPanel::showAxis(GraphAxis axis) {
  AxisFields& a = fields_->axis(axis);
  const ImportGraph* graph = state_.current();
  const auto shown = graph ? (graph->good ? graph->good : graph->last) : nullptr;
  const bool isX = axis == GraphAxis::x;
  const Corrections none;
  const Corrections& given = graph ? graph->history.now() : none;
  const importer::AxisReading* reading = nullptr;
  if (shown && shown->evidence) {
    const auto& calibration = shown->evidence->axes.calibration.value;
    reading = isX ? &calibration.x : &calibration.y;
  }
  const AxisCorrection& correction = given.axis(axis);
  const auto end = [&](QLineEdit* edit, std::optional<double> givenEnd, double found) {
    (edit == a.max ? a.maxShown : a.minShown) = givenEnd  ? givenEnd
                                                : reading ? std::optional(found)
                                                          : std::nullopt;
    if (edit->isModified()) return;
    edit->setText(givenEnd ? number(*givenEnd) : reading ? number(found, 4) : QString());
    edit->setModified(false);
  };
  end(a.min, correction.min, reading ? reading->min : 0);
  end(a.max, correction.max, reading ? reading->max : 0);
  const bool unitGiven = isX ? given.xUnit.has_value() : given.yUnit.has_value();
  const QString unit = isX && given.xUnit    ? symbol(symbolOf(*given.xUnit))
                       : !isX && given.yUnit ? symbol(symbolOf(*given.yUnit))
                       : reading             ? QString::fromStdString(reading->unit)
                                             : QString();
  a.unit->setCurrentIndex(a.unit->findText(unit));
  a.range.set(!correction.empty(),
              shown ? confidenceOf(shown->evidence, importer::ImportStep::axes) : std::nullopt);
  a.unitOrigin.set(unitGiven, {});
  if (!unitGiven && reading)
    a.unitOrigin.words->setText(reading->unitFound ? tr("as printed") : tr("not printed, a guess"));
  QStringList details;
  if (!correction.ticks.empty()) {
    details << (correction.ticks.size() == 1 ? tr("1 tick given; one more settles the axis")
                                             : tr("%1 ticks given").arg(correction.ticks.size()));
  } else if (reading && !reading->ticks.empty()) {
    const auto used =
        std::count_if(reading->ticks.begin(), reading->ticks.end(), [](const auto& t) { return t.used; });
    details << tr("%1 of %2 numbers used, off by %3 px")
                   .arg(used)
                   .arg(reading->ticks.size())
                   .arg(fixedText(reading->residual_px, 2));
  }
  if (reading && !reading->title.empty())
    details << tr("titled “%1”").arg(QString::fromStdString(reading->title));
  a.details->setText(details.join(QStringLiteral("; ")));
  a.details->setVisible(!details.isEmpty());
}

void FindingsPanel::showCurves() {
  Fields& f = *fields_;
  const ImportGraph* graph = state_.current();
  const Corrections none;
  const Corrections& given = graph ? graph->history.now() : none;
  const auto foundColor = [&](Stroke stroke) { return colorOfStroke(graph ? graph->good : nullptr, stroke); };
  f.pressColor->setIcon(swatch(given.pressColor, foundColor(Stroke::press), palette()));
  f.releaseColor->setIcon(swatch(given.releaseColor, foundColor(Stroke::release), palette()));
  f.press.set(given.pressColor.has_value(), {});
  f.release.set(given.releaseColor.has_value(), {});
  f.swap->setChecked(given.swapStrokes);
  const auto* strokes =
      graph && graph->good ? stepOf(graph->good->evidence, importer::ImportStep::strokes) : nullptr;
  f.strokes->setText(strokes ? inWords(strokes->evidence, settings_.units()) : QString());
  f.strokes->setVisible(strokes && !strokes->evidence.empty());
  f.masks->setText(given.masks.empty()       ? tr("none")
                   : given.masks.size() == 1 ? tr("1 place masked")
                                             : tr("%1 places masked").arg(given.masks.size()));
  f.noMasks->setVisible(!given.masks.empty());
  const QSignalBlocker quiet(f.dpi);
  f.dpi->setValue(given.dpi.value_or(0));
  f.dpiOrigin.set(given.dpi.has_value(), {});
}

void FindingsPanel::showChecks(const importer::ImportReport* report) {
  QStringList checks, warnings;
  if (report) {
    for (const auto& check : report->specChecks) {
      const QString mark = check.agrees ? QStringLiteral("✓ ") : QStringLiteral("✗ ");
      checks << mark + inWords(messageOf(check), settings_.units());
    }
    for (const auto& remark : report->remarks) {
      const bool amongChecks = remark.code == importer::RemarkCode::printedValueDiffers;
      if (!amongChecks) warnings << QStringLiteral("⚠ ") + inWords(remark, settings_.units());
    }
  }
  fields_->checks->setText(checks.isEmpty() ? QString()
                                            : tr("Printed on the page:\n%1").arg(checks.join('\n')));
  fields_->checks->setVisible(!checks.isEmpty());
  fields_->warnings->setText(warnings.join('\n'));
  fields_->warnings->setVisible(!warnings.isEmpty());
}

void FindingsPanel::showResult() {
  Fields& f = *fields_;
  const ImportGraph* graph = state_.current();
  const importer::ImportReport* report = graph && graph->good ? graph->good->report.get() : nullptr;
  f.resultBox->setVisible(report != nullptr);
  showChecks(report);
  if (!report) return;
  const DisplayUnits& u = settings_.units();
  const auto length = [&](double mm) {
    return tr("%1 %2").arg(number(u.lengthFrom(mm), 4), u.lengthSymbol());
  };
  const auto force = [&](double N) { return tr("%1 %2").arg(number(u.forceFrom(N), 4), u.forceSymbol()); };
  QStringList lines;
  lines << tr("Travel %1").arg(length(report->button.states().front().graph.travel_mm()));
  const auto stroke = [&](const QString& name, const importer::StrokeReport& s) {
    QString line =
        (s.fit.pieces == 1 ? tr("%1: 1 piece").arg(name) : tr("%1: %2 pieces").arg(name).arg(s.fit.pieces));
    if (s.rms_px > 0) line += tr(", off by %1 px").arg(number(s.rms_px, 2));
    for (const auto& fitted : s.fit.tactilePoints)
      line += tr("\n   tactile point %1, %2")
                  .arg(length(fitted.point.displacement_mm), force(fitted.point.force_N));
    if (s.fit.tactilePoints.empty()) line += tr(", no tactile point");
    lines << line;
  };
  stroke(tr("Press"), report->press);
  if (report->release) {
    stroke(tr("Release"), *report->release);
  } else {
    lines << tr("No release curve");
  }
  for (const auto& callout : report->callouts) {
    const bool operating = callout.kind == importer::CalloutKind::operatingPoint;
    lines << tr("%1 %2").arg(operating ? tr("Operating point") : tr("Reset point"),
                             length(callout.at.displacement_mm));
  }
  f.result->setText(lines.join('\n'));
  QStringList times;
  double sum = 0;
  for (const auto& [step, seconds] : report->seconds) {
    sum += seconds;
    if (seconds >= 0.0005) times << tr("%1 %2 ms").arg(nameOfWork(step)).arg(qRound(1000 * seconds));
  }
  f.seconds->setText(
      tr("Computed in %1 ms: %2").arg(qRound(1000 * sum)).arg(times.join(QStringLiteral(", "))));
}

void FindingsPanel::refresh() {
  Fields& f = *fields_;
  const ImportGraph* graph = state_.current();
  const bool log = state_.isForceLog();
  widget()->setVisible(graph != nullptr);
  if (!graph) return;
  const auto shown = graph->good ? graph->good : graph->last;
  const auto evidence = shown ? shown->evidence : nullptr;
  const bool failed = graph->last && graph->last->failure;
  const importer::ImportReport* report = graph->good ? graph->good->report.get() : nullptr;
  if (report) {
    const int percent = qRound(100 * report->confidence);
    f.confidence->setText(failed          ? tr("The last result that worked, %1 % sure").arg(percent)
                          : report->doubt ? tr("%1 % sure: please check").arg(percent)
                                          : tr("%1 % sure").arg(percent));
    f.sure->setValue(percent);
  } else {
    f.confidence->setText(state_.working() ? tr("Reading the graph …") : tr("Nothing to import yet"));
    f.sure->setValue(0);
  }
  f.sure->setVisible(report != nullptr);
  QStringList steps, reasons;
  if (evidence) {
    for (const auto& step : evidence->steps) {
      steps << tr("%1 %2 %").arg(nameOfFinding(step.step)).arg(qRound(100 * step.confidence));
      if (!step.evidence.empty())
        reasons << tr("%1: %2").arg(nameOfFinding(step.step), inWords(step.evidence, settings_.units()));
    }
  }
  f.steps->setText(steps.join(QStringLiteral(" · ")));
  f.steps->setToolTip(reasons.join('\n'));
  f.steps->setAccessibleDescription(reasons.join('\n'));
  f.steps->setVisible(!steps.isEmpty());
  f.confirmed->setVisible(report && report->doubt && !failed);
  f.confirmed->setChecked(graph->confirmed);

  f.frameBox->setVisible(!log);
  f.frame.set(graph->framedByHand(), confidenceOf(evidence, importer::ImportStep::locate));
  f.frame.reset->setVisible(graph->framedByHand() && graph->listed.has_value());
  const auto* frameStep = stepOf(evidence, importer::ImportStep::locate);
  f.frameDetails->setText(frameStep ? inWords(frameStep->evidence, settings_.units()) : QString());
  f.frameDetails->setVisible(frameStep && !frameStep->evidence.empty() && !graph->framedByHand());
  for (const GraphAxis axis : {GraphAxis::x, GraphAxis::y}) {
    for (QWidget* each : f.axis(axis).ofPage) each->setVisible(!log);
    f.axis(axis).box->setTitle(axisTitle(axis, log));
    showAxis(axis);
  }
  showCurves();
  f.curveBox->setVisible(true);
  for (QWidget* each : f.curvesOfPage) each->setVisible(!log);
  showResult();
  settleLayout();
}

/// What was shown or hidden changes the content's height: the area takes it up at once, so that nothing is
/// drawn squeezed in between.
void FindingsPanel::settleLayout() {
  widget()->layout()->activate();
  QEvent request(QEvent::LayoutRequest);
  QCoreApplication::sendEvent(widget(), &request);
}

void FindingsPanel::focusField(GraphAxis axis) {
  QLineEdit* edit = fields_->axis(axis).min;
  ensureWidgetVisible(edit);
  edit->setFocus();
  edit->selectAll();
}

void FindingsPanel::focusUnit(GraphAxis axis) {
  ensureWidgetVisible(fields_->axis(axis).unit);
  fields_->axis(axis).unit->setFocus();
}

void FindingsPanel::focusDpi() {
  ensureWidgetVisible(fields_->dpi);
  fields_->dpi->setFocus();
}

}  // namespace detent::editor
