// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/key_figures_model.h"

#include <algorithm>
#include <cmath>
#include <QCoreApplication>
#include <QFont>
#include <QPalette>

#include "editor/document/graph_colors.h"
#include "editor/document/message_words.h"
#include "editor/panels/value_delegate.h"
#include "editor/quantity/reading_error.h"

namespace detent::editor {
namespace {

constexpr int figuresDragPause_ms = 80;
constexpr int editedFigureDigits = 12;  // typed values are shown unchanged
constexpr int shownDigits = 4;

bool needsContact(KeyFigure figure) {
  using enum KeyFigure;
  return figure == preTravel || figure == operatingForce || figure == overTravel || figure == resetTravel ||
         figure == resetForce || figure == differentialTravel;
}

struct Moves {
  Q_DECLARE_TR_FUNCTIONS(Moves)
};

/// "the press between 1.25 and 4 mm"; empty if the stroke moves by less than a target is met to.
QString movedStretch(const ForceGraph& before, const ForceGraph& after, Stroke stroke,
                     const DisplayUnits& units) {
  constexpr int samples = 400, digits = 3;
  if (stroke == Stroke::release && !(before.release() && after.release())) return {};
  const StrokeCurve &from = before.curve(stroke), &to = after.curve(stroke);
  std::optional<double> first_mm, last_mm;
  const double end_mm = std::max(from.end_mm(), to.end_mm());
  for (int i = 0; i <= samples; ++i) {
    const double at_mm = end_mm * i / samples;
    const auto force_N = [at_mm](const StrokeCurve& curve) {
      return curve.force_N(std::clamp(at_mm, curve.start_mm(), curve.end_mm()));
    };
    if (std::abs(force_N(from) - force_N(to)) <= TargetTolerance().force_N) continue;
    if (!first_mm) first_mm = at_mm;
    last_mm = at_mm;
  }
  if (!first_mm) return {};
  return (stroke == Stroke::press ? Moves::tr("the press between %1 and %2")
                                  : Moves::tr("the release between %1 and %2"))
      .arg(quantityText(*first_mm, Quantity::length, units, digits),
           quantityWithUnit(*last_mm, Quantity::length, units, digits));
}

FigureUnit unitOf(KeyFigure figure) { return keyFigureNames()[static_cast<std::size_t>(figure)].unit; }

}  // namespace

Quantity quantityOf(KeyFigure figure) {
  switch (unitOf(figure)) {
    case FigureUnit::mm:
      return Quantity::length;
    case FigureUnit::N:
      return Quantity::force;
    case FigureUnit::N_per_mm:
      return Quantity::slope;
    case FigureUnit::share:
      return Quantity::share;
    case FigureUnit::mJ:
      return Quantity::number;
  }
  return Quantity::number;
}

QString termOf(KeyFigure figure) {
  return QCoreApplication::translate("detent", keyFigureNames()[static_cast<std::size_t>(figure)].term);
}

QString definitionOf(KeyFigure figure) {
  using enum KeyFigure;
  switch (figure) {
    case initialForce:
      return KeyFiguresModel::tr("Force at the start of the press; this is the preload, if there is one.");
    case preTravel:
      return KeyFiguresModel::tr("Displacement of the operating point (PT).");
    case operatingForce:
      return KeyFiguresModel::tr(
          "Force of the press at the operating point; keyboards call it actuation force.");
    case peakForce:
      return KeyFiguresModel::tr("Force of the tactile point with the largest drop after it.");
    case peakTravel:
      return KeyFiguresModel::tr("Displacement of the tactile point with the largest drop after it.");
    case valleyForce:
      return KeyFiguresModel::tr(
          "Lowest force between the peak and the next tactile point, or the end of the press.");
    case valleyTravel:
      return KeyFiguresModel::tr("Displacement of the lowest force after the peak.");
    case drop:
      return KeyFiguresModel::tr("Peak force minus valley force; the drop the finger feels.");
    case snapRatio:
      return KeyFiguresModel::tr(
          "Tactile drop divided by peak force; also called tactile ratio or click ratio.");
    case slopeToPeak:
      return KeyFiguresModel::tr("Mean slope from the start to the peak; without a peak, to the bottom-out.");
    case slopeOfDrop:
      return KeyFiguresModel::tr("Mean slope from the peak to the valley (a negative value).");
    case slopeToBottomOut:
      return KeyFiguresModel::tr("Mean slope from the valley to the bottom-out.");
    case resetTravel:
      return KeyFiguresModel::tr("Displacement at which the contact opens on the release.");
    case resetForce:
      return KeyFiguresModel::tr("Force of the release at the reset point (RF).");
    case differentialTravel:
      return KeyFiguresModel::tr("Operating point minus reset point (MD).");
    case overTravel:
      return KeyFiguresModel::tr("From the operating point to the end of the press (OT).");
    case bottomOutForce:
      return KeyFiguresModel::tr(
          "Force where the bottom-out starts; without a bottom-out, at the end of the travel.");
    case bottomOutTravel:
      return KeyFiguresModel::tr(
          "Displacement where the bottom-out starts; without a bottom-out, the end of the travel.");
    case totalTravel:
      return KeyFiguresModel::tr("Displacement of the end of the press (TT).");
    case endForce:
      return KeyFiguresModel::tr("Force at the end of the press.");
    case pressWork:
      return KeyFiguresModel::tr("Area under the press curve.");
    case hysteresis:
      return KeyFiguresModel::tr("Area between press and release: the energy lost in one actuation.");
  }
  return {};
}

KeyFiguresModel::KeyFiguresModel(ButtonDocument& document, ViewSettings& settings, QObject* parent)
    : QAbstractTableModel(parent),
      document_(document),
      settings_(settings),
      typedSolve_(this,
                  [this](const Solving::Query& query) {
                    query.tell([this, outcome = solved(query)] { takeTyped(outcome); });
                  }),
      aheadSolve_(this, [this](const Solving::Query& query) {
        query.tell([this, outcome = solved(query)] { takeAhead(outcome); });
      }) {
  pause_.setSingleShot(true);
  pause_.setInterval(figuresDragPause_ms);
  connect(&pause_, &QTimer::timeout, this, &KeyFiguresModel::follow);
  connect(&document_, &ButtonDocument::changed, this, [this] {
    if (!document_.history().dragging()) return follow();
    if (!pause_.isActive()) pause_.start();
  });
  connect(&document_, &ButtonDocument::activeStateChanged, this, [this] {
    giveUp();
    follow();
  });
  connect(&settings_, &ViewSettings::changed, this, [this] {
    emit headerDataChanged(Qt::Horizontal, 0, columns - 1);
    emit dataChanged(index(0, 0), index(rowCount() - 1, columns - 1));
  });
  follow();
}

const ButtonState& KeyFiguresModel::state() const {
  return document_.button().states()[document_.activeState()];
}

void KeyFiguresModel::follow() {
  pause_.stop();
  figures_ = keyFiguresOf(state());
  moves_.clear();
  if (!document_.history().dragging()) {
    solveNext();
    if (anyWanted()) solveAhead();
  }
  emit dataChanged(index(0, 0), index(rowCount() - 1, columns - 1));
}

bool KeyFiguresModel::anyWanted() const {
  return std::any_of(wanted_.begin(), wanted_.end(), [](const auto& value) { return value.has_value(); });
}

std::vector<FigureTarget> KeyFiguresModel::kept() const {
  std::vector<FigureTarget> targets;
  for (std::size_t i = 0; i < keyFigureCount; ++i)
    if (const auto value = figures_.values[i]; kept_[i] && value)
      targets.push_back({static_cast<KeyFigure>(i), *value});
  return targets;
}

TargetOutcome KeyFiguresModel::solved(const Solving::Query& query) {
  return bentToTargets(query.request.button, query.request.state, query.request.targets, {}, {},
                       {[&query] { return query.overtaken(); }, mostKnots});
}

void KeyFiguresModel::solveAhead() {
  preview_.reset();
  previewed_.reset();
  conflict_.clear();
  moves_.clear();
  looking_ = anyWanted();
  if (looking_) {
    std::vector<FigureTarget> targets = kept();
    for (std::size_t i = 0; i < keyFigureCount; ++i)
      if (wanted_[i]) targets.push_back({static_cast<KeyFigure>(i), *wanted_[i]});
    aheadSolve_.ask({document_.history().committed(), document_.activeState(), std::move(targets)});
  } else {
    aheadSolve_.cancel();
  }
  emit dataChanged(index(0, wanted), index(rowCount() - 1, wanted));
  emit previewChanged();
  emit solvingChanged();
}

void KeyFiguresModel::takeAhead(const TargetOutcome& outcome) {
  looking_ = false;
  previewed_ = outcome.button;
  if (previewed_) preview_ = previewed_->states()[document_.activeState()];
  if (preview_) {
    ahead_ = keyFiguresOf(*preview_);
    std::vector<KeyFigure> set;
    for (std::size_t i = 0; i < keyFigureCount; ++i)
      if (wanted_[i]) set.push_back(static_cast<KeyFigure>(i));
    moves_ = movesBetween(state(), *preview_, set);
  }
  if (outcome.conflict) conflict_ = sentenceOf(outcome.conflict->failure, settings_.units());
  emit dataChanged(index(0, wanted), index(rowCount() - 1, wanted));
  emit previewChanged();
  emit solvingChanged();
}

QString KeyFiguresModel::movesBetween(const ButtonState& before, const ButtonState& after,
                                      const std::vector<KeyFigure>& set) const {
  QStringList stretches, figures;
  for (const Stroke stroke : {Stroke::press, Stroke::release})
    if (const QString moved = movedStretch(before.graph, after.graph, stroke, settings_.units());
        !moved.isEmpty())
      stretches << moved;
  const KeyFigures now = keyFiguresOf(before), then = keyFiguresOf(after);
  for (std::size_t i = 0; i < keyFigureCount; ++i) {
    const auto which = static_cast<KeyFigure>(i);
    if (!now[which] || !then[which] || std::ranges::find(set, which) != set.end()) continue;
    if (shown(*now[which], which, false) != shown(*then[which], which, false)) figures << termOf(which);
  }
  QStringList sentences;
  if (!stretches.isEmpty()) sentences << Moves::tr("Moves %1.").arg(stretches.join(QStringLiteral(", ")));
  if (!figures.isEmpty()) sentences << Moves::tr("Also changes: %1.").arg(figures.join(QStringLiteral(", ")));
  return sentences.join(QLatin1Char(' '));
}

void KeyFiguresModel::forgetMoves() {
  if (!preview_) moves_.clear();
}

void KeyFiguresModel::take() {
  if (!previewed_ || document_.history().dragging()) return;
  const Button next = *previewed_;
  QStringList changes;
  for (std::size_t i = 0; i < keyFigureCount; ++i)
    if (wanted_[i]) changes << changeOf(static_cast<KeyFigure>(i), *wanted_[i]);
  giveUp();
  document_.history().apply(next, tr("Set: %1").arg(changes.join(QStringLiteral(", "))));
}

void KeyFiguresModel::giveUp() {
  if (!anyWanted()) return;
  wanted_.fill({});
  solveAhead();
}

int KeyFiguresModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(keyFigureCount);
}

int KeyFiguresModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : columns; }

QString KeyFiguresModel::shown(double value, KeyFigure which, bool exact) const {
  const Quantity quantity = quantityOf(which);
  const int digits = exact ? editedFigureDigits : shownDigits;
  if (quantity == Quantity::share) return quantityWithUnit(value, quantity, settings_.units(), digits);
  if (quantity == Quantity::number) return numberText(value, digits);
  if (exact) return quantityText(value, quantity, settings_.units(), digits);
  return readText(value, quantity, settings_.units(), readingErrorOf(document_.button()), digits);
}

QString KeyFiguresModel::changeOf(KeyFigure which, double value) const {
  return QStringLiteral("%1 %2").arg(termOf(which),
                                     quantityWithUnit(value, quantityOf(which), settings_.units()));
}

QVariant KeyFiguresModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const KeyFigure which = figureOf(index);
  const auto at = static_cast<std::size_t>(index.row());
  const std::optional<double> value = figures_[which];
  if (role == Qt::ToolTipRole)
    return value ? definitionOf(which) : QStringLiteral("%1\n%2").arg(definitionOf(which), absenceOf(index));
  if (role == Qt::ForegroundRole && !value) return QPalette().brush(QPalette::Disabled, QPalette::Text);
  switch (index.column()) {
    case figure:
      return role == Qt::DisplayRole ? termOf(which) : QVariant();
    case now:
    case wanted: {
      if (role == Qt::TextAlignmentRole) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
      if (!value && index.column() == now && role == Qt::DisplayRole)
        return needsContact(which) ? tr("Set…") : QStringLiteral("–");
      if (!value) return {};
      if (role == ValueDelegate::unitRole) {
        if (unitOf(which) == FigureUnit::mJ) return QStringLiteral("mJ");
        return unitOf(which) == FigureUnit::share ? QString()
                                                  : symbolOf(quantityOf(which), settings_.units());
      }
      const bool exact = role == Qt::EditRole;
      if (role != Qt::DisplayRole && role != Qt::EditRole && role != Qt::FontRole) return {};
      if (index.column() == now) return role == Qt::FontRole ? QVariant() : shown(*value, which, exact);
      if (role == Qt::FontRole) {
        QFont font;
        font.setBold(wanted_[at].has_value());
        font.setItalic(!wanted_[at].has_value());
        return font;
      }
      if (wanted_[at]) return shown(*wanted_[at], which, exact);
      if (exact || !preview_ || !ahead_[which]) return QString();
      const QString then = shown(*ahead_[which], which, false);
      return then == shown(*value, which, false) ? QString() : then;
    }
    case keep:
      if (role == Qt::CheckStateRole && value) return kept_[at] ? Qt::Checked : Qt::Unchecked;
      if (role == Qt::AccessibleTextRole) return tr("Lock: %1").arg(termOf(which));
      return {};
    default:
      return {};
  }
}

QVariant KeyFiguresModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Vertical) {
    const bool isShown = role == Qt::DisplayRole || role == Qt::ToolTipRole;
    return isShown ? data(index(section, figure), role) : QVariant();
  }
  if (role == Qt::ToolTipRole) {
    if (section == now) return tr("Changes apply immediately; locked figures don't move.");
    if (section == wanted) return tr("All targets are met together; the dashed curve previews the result.");
    if (section == keep) return tr("Locked figures stay as they are while others change.");
  }
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case figure:
      return tr("Key figure");
    case now:
      return tr("Current");
    case wanted:
      return tr("Target");
    case keep:
      return tr("Lock");
    default:
      return {};
  }
}

Qt::ItemFlags KeyFiguresModel::flags(const QModelIndex& index) const {
  if (!index.isValid() || index.row() >= rowCount()) return Qt::NoItemFlags;
  // A disabled cell would not become the current one, and the text typed next would go to another row.
  Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
  if (!figures_[figureOf(index)]) return flags;
  if (index.column() == now || index.column() == wanted) flags |= Qt::ItemIsEditable;
  if (index.column() == keep) flags |= Qt::ItemIsUserCheckable;
  return flags;
}

std::optional<double> KeyFiguresModel::read(const QModelIndex& index, const QString& text) const {
  return readQuantity(text, quantityOf(figureOf(index)), settings_.units(), figures_[figureOf(index)]).value;
}

QString KeyFiguresModel::doubtOf(const QModelIndex& index, const QString& text) const {
  if (text == data(index, Qt::EditRole).toString()) return {};
  const auto value = read(index, text);
  return value ? editor::doubtOf(text, *value, quantityOf(figureOf(index)), settings_.units()) : QString();
}

QString KeyFiguresModel::refusalOf(const QModelIndex& index, const QString& text) const {
  if (index.column() == wanted && text.trimmed().isEmpty()) return {};
  const Quantity quantity = quantityOf(figureOf(index));
  const QuantityReading reading = readQuantity(text, quantity, settings_.units(), figures_[figureOf(index)]);
  return reading.value ? QString() : editor::refusalOf(reading, quantity, settings_.units());
}

QString KeyFiguresModel::absenceOf(const QModelIndex& index) const {
  const KeyFigure which = figureOf(index);
  if (figures_[which]) return {};
  using enum KeyFigure;
  const bool hasPeak = figures_[peakForce].has_value();
  switch (which) {
    case preTravel:
    case operatingForce:
    case overTravel:
      return tr(
          "No operating point is set. Set it in Edit > Curve > Operating and reset point (Ctrl+Shift+O).");
    case resetTravel:
    case resetForce:
      return tr("No reset point is set. Set it in Edit > Curve > Operating and reset point (Ctrl+Shift+O).");
    case differentialTravel:
      return tr(
          "This figure needs an operating point and a reset point: Edit > Curve > Operating and reset point "
          "(Ctrl+Shift+O).");
    case hysteresis:
      return tr("The button has no release curve. Add one with Edit > Curve > Mirror press to release.");
    case peakForce:
    case peakTravel:
    case valleyForce:
    case valleyTravel:
    case drop:
    case snapRatio:
    case slopeOfDrop:
    case slopeToBottomOut:
      if (!hasPeak)
        return tr("The press has no tactile point. Add one with Edit > Curve > Add jump (Ctrl+Shift+J).");
      break;
    default:
      break;
  }
  return tr("This part of the curve is too short for a slope or ratio.");
}

bool KeyFiguresModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const Qt::ItemFlags can = flags(index);
  if (role == Qt::EditRole && !(can & Qt::ItemIsEditable)) return false;
  if (role == Qt::CheckStateRole && (can & Qt::ItemIsUserCheckable)) {
    kept_[static_cast<std::size_t>(index.row())] = value.toInt() == Qt::Checked;
    emit dataChanged(index, index);
    if (anyWanted()) solveAhead();
    return true;
  }
  if (role != Qt::EditRole || document_.history().dragging()) return false;  // another edit holds the button
  if (const QString why = refusalOf(index, value.toString()); !why.isEmpty()) {
    emit refused(index, why);
    return false;
  }
  return index.column() == now ? setNow(index, value.toString()) : setWanted(index, value.toString());
}

bool KeyFiguresModel::setNow(const QModelIndex& index, const QString& text) {
  if (text == data(index, Qt::EditRole).toString()) return true;
  typed_.push_back({figureOf(index), *read(index, text), document_.activeState()});
  if (typed_.size() == 1) solveNext();
  return true;
}

void KeyFiguresModel::solveNext() {
  std::erase_if(typed_,
                [this](const Typed& typed) { return typed.state >= document_.button().states().size(); });
  if (!typed_.empty()) {
    const Typed& next = typed_.front();
    std::vector<FigureTarget> targets =
        next.state == document_.activeState() ? kept() : std::vector<FigureTarget>();
    targets.push_back({next.figure, next.value});
    typedSolve_.ask({document_.history().committed(), next.state, std::move(targets)});
  }
  emit solvingChanged();
}

void KeyFiguresModel::takeTyped(const TargetOutcome& outcome) {
  // Every change of the button starts a new request (follow), so this answer fits the present button. Another
  // edit may be in progress.
  if (document_.history().dragging())
    return QTimer::singleShot(figuresDragPause_ms, this, &KeyFiguresModel::solveNext);
  const auto [which, value, state] = typed_.front();
  typed_.pop_front();
  if (outcome.button) {
    emit accepted();
    const QString moves =
        movesBetween(document_.button().states()[state], outcome.button->states()[state], {which});
    document_.history().apply(*outcome.button, tr("Set: %1").arg(changeOf(which, value)));
    moves_ = moves;
    emit previewChanged();
  } else {
    emit refused(index(static_cast<int>(which), now),
                 sentenceOf(outcome.conflict->failure, settings_.units()));
  }
  solveNext();
}

bool KeyFiguresModel::setWanted(const QModelIndex& index, const QString& text) {
  auto& value = wanted_[static_cast<std::size_t>(index.row())];
  const std::optional<double> next = text.trimmed().isEmpty() ? std::nullopt : read(index, text);
  if (value == next) return true;
  value = next;
  emit accepted();
  solveAhead();
  return true;
}

}  // namespace detent::editor
