// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/values_model.h"

#include <QFont>

#include "editor/document/message_words.h"
#include "editor/panels/value_delegate.h"
#include "editor/quantity/reading_error.h"
#include "editor/tools/mark_edits.h"

namespace detent::editor {
namespace {

constexpr int valuesDragPause_ms = 80;
constexpr int shownValueDigits = 4;
constexpr int editedValueDigits = 12;  // typed values are shown unchanged

// Keeps a column of short numbers narrow.
QString wordPerLine(const QString& heading) { return QString(heading).replace(' ', '\n'); }

// The headings name the stroke.
QString shortName(MarkId mark) {
  const QString number = QString::number(mark.index + 1);
  switch (mark.kind) {
    case MarkKind::tactilePoint:
      return ValuesModel::tr("Tactile point %1").arg(number);
    case MarkKind::turn:
      return ValuesModel::tr("Valley or peak %1").arg(number);
    case MarkKind::knot:
      return ValuesModel::tr("Curve point %1").arg(number);
    case MarkKind::section:
      return ValuesModel::tr("Section %1").arg(number);
    default:
      return nameOf(mark);
  }
}

QString sectionName(SectionKind kind) {
  switch (kind) {
    case SectionKind::slope:
      return ValuesModel::tr("slope");
    case SectionKind::jump:
      return ValuesModel::tr("jump");
    case SectionKind::bottomOut:
      return ValuesModel::tr("bottom-out");
  }
  return {};
}

}  // namespace

ValuesModel::ValuesModel(ButtonDocument& document, ViewSettings& settings, QObject* parent)
    : QAbstractTableModel(parent),
      document_(document),
      settings_(settings),
      values_(valuesOf(document.graph())) {
  rows_ = rowsNow();
  pause_.setSingleShot(true);
  pause_.setInterval(valuesDragPause_ms);
  connect(&pause_, &QTimer::timeout, this, &ValuesModel::follow);
  connect(&document_, &ButtonDocument::changed, this, &ValuesModel::followSoon);
  connect(&document_, &ButtonDocument::activeStateChanged, this, &ValuesModel::follow);
  connect(&settings_, &ViewSettings::changed, this, [this] {
    emit headerDataChanged(Qt::Horizontal, 0, columns - 1);
    if (!rows_.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, columns - 1));
  });
}

const ButtonState& ValuesModel::state() const { return document_.button().states()[document_.activeState()]; }

std::vector<ValuesModel::Row> ValuesModel::rowsNow() const {
  std::vector<Row> rows;
  for (const Stroke stroke : {Stroke::press, Stroke::release}) {
    if (stroke == Stroke::release && !values_.release) continue;
    const StrokeValues& values = values_.of(stroke);
    const bool press = stroke == Stroke::press;
    const auto add = [&](const QString& heading, MarkKind kind, std::size_t count) {
      if (count > 0) rows.push_back({{}, heading});
      for (std::size_t i = 0; i < count; ++i) rows.push_back({MarkId{kind, stroke, i}, {}});
    };
    add(press ? tr("Press: tactile points") : tr("Release: tactile points"), MarkKind::tactilePoint,
        values.tactile.size());
    add(press ? tr("Press: valleys and peaks") : tr("Release: valleys and peaks"), MarkKind::turn,
        values.turns.size());
    add(press ? tr("Press: sections (end point)") : tr("Release: sections (end point)"), MarkKind::section,
        values.sections.size());
    add(press ? tr("Press: curve points") : tr("Release: curve points"), MarkKind::knot,
        state().graph.curve(stroke).knots().size());
  }
  if (state().operatingPoint_mm || state().resetPoint_mm) rows.push_back({{}, tr("Contact")});
  if (state().operatingPoint_mm) rows.push_back({MarkId{MarkKind::operatingPoint, Stroke::press, 0}, {}});
  if (state().resetPoint_mm) rows.push_back({MarkId{MarkKind::resetPoint, Stroke::release, 0}, {}});
  return rows;
}

// Updates only now and then during a drag, whose numbers change faster than a user can read.
void ValuesModel::followSoon() {
  if (!document_.history().dragging()) return follow();
  if (!pause_.isActive()) pause_.start();
}

void ValuesModel::follow() {
  pause_.stop();
  values_ = valuesOf(document_.graph());
  std::vector<Row> rows = rowsNow();
  if (rows == rows_) {
    emit dataChanged(index(0, 0), index(rowCount() - 1, columns - 1));
    return;
  }
  beginResetModel();
  rows_ = std::move(rows);
  endResetModel();
}

int ValuesModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int ValuesModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : columns; }

Quantity ValuesModel::quantityOf(int column) {
  if (column == displacement) return Quantity::length;
  return column == force ? Quantity::force : Quantity::slope;
}

std::optional<double> ValuesModel::valueAt(const MarkId& mark, int column) const {
  if (mark.kind == MarkKind::section) {
    const auto& sections = values_.of(mark.stroke).sections;
    if (mark.index >= sections.size()) return {};
    const Section& section = sections[mark.index];
    if (column == displacement) return section.to_mm;
    if (column == force) return section.toForce_N;
    if (column == slopeAfter && section.kind == SectionKind::slope && section.to_mm != section.from_mm)
      return (section.toForce_N - section.fromForce_N) / (section.to_mm - section.from_mm);
    return {};
  }
  const auto at = placeOf(mark, state(), values_);
  if (!at) return {};
  if (column == displacement) return at->displacement_mm;
  if (column == force) return at->force_N;
  if (mark.kind != MarkKind::knot) return {};
  const std::vector<Knot>& knots = state().graph.curve(mark.stroke).knots();
  if (column == slopeBefore && mark.index > 0) return knots[mark.index].slopeBefore_N_per_mm;
  if (column == slopeAfter && mark.index + 1 < knots.size()) return knots[mark.index].slopeAfter_N_per_mm;
  return {};
}

bool ValuesModel::editable(const MarkId& mark, int column) const {
  if (column == name || !valueAt(mark, column)) return false;
  return !(isContact(mark.kind) && column != displacement);
}

Result<Button> ValuesModel::edited(const MarkId& mark, int column, double value) const {
  const Button& button = document_.history().committed();
  const std::size_t active = document_.activeState();
  if (mark.kind == MarkKind::section) {
    const Section& section = values_.of(mark.stroke).sections[mark.index];
    CurvePoint to{section.to_mm, section.toForce_N};
    if (column == displacement) to.displacement_mm = value;
    if (column == force) to.force_N = value;
    if (column == slopeAfter) to.force_N = section.fromForce_N + value * (section.to_mm - section.from_mm);
    return moveSectionEnd(button, active, mark.stroke, section, to);
  }
  if (column == slopeBefore || column == slopeAfter)
    return setMarkSlope(
        button, active,
        {column == slopeBefore ? MarkKind::slopeBefore : MarkKind::slopeAfter, mark.stroke, mark.index},
        value);
  const CurvePoint at = *placeOf(mark, state(), values_);
  return moveMark(
      button, active, {mark, at},
      column == displacement ? CurvePoint{value, at.force_N} : CurvePoint{at.displacement_mm, value});
}

QVariant ValuesModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  if (!row.mark) {
    if (index.column() == name && (role == Qt::DisplayRole || role == Qt::AccessibleTextRole))
      return row.heading;
    if (role == Qt::FontRole) {
      QFont font;
      font.setBold(true);
      return font;
    }
    return {};
  }
  if (index.column() == name) {
    if (role == Qt::AccessibleTextRole) return nameOf(*row.mark);
    if (role != Qt::DisplayRole) return {};
    if (row.mark->kind == MarkKind::section)
      return tr("%1 (%2)").arg(shortName(*row.mark),
                               sectionName(values_.of(row.mark->stroke).sections[row.mark->index].kind));
    return shortName(*row.mark);
  }
  if (role == Qt::TextAlignmentRole) return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  const auto value = valueAt(*row.mark, index.column());
  if (!value) return {};
  if (role == ValueDelegate::unitRole) return symbolOf(quantityOf(index.column()), settings_.units());
  if (role == Qt::DisplayRole)
    return readText(*value, quantityOf(index.column()), settings_.units(), readingErrorOf(document_.button()),
                    shownValueDigits);
  if (role == Qt::EditRole)
    return quantityText(*value, quantityOf(index.column()), settings_.units(), editedValueDigits);
  return {};
}

QVariant ValuesModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Horizontal && role == Qt::ToolTipRole) {
    if (section == slopeBefore) return tr("Slope left of the curve point");
    if (section == slopeAfter)
      return tr("Slope right of the curve point. For a section: mean slope from its start to its end");
  }
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  const DisplayUnits& units = settings_.units();
  switch (section) {
    case name:
      return tr("Item");
    case displacement:
      return tr("Travel") + '\n' + units.lengthSymbol();
    case force:
      return tr("Force") + '\n' + units.forceSymbol();
    case slopeBefore:
      return wordPerLine(tr("Slope before")) + '\n' + units.slopeSymbol();
    case slopeAfter:
      return wordPerLine(tr("Slope after")) + '\n' + units.slopeSymbol();
    default:
      return {};
  }
}

Qt::ItemFlags ValuesModel::flags(const QModelIndex& index) const {
  if (!index.isValid() || index.row() >= rowCount()) return Qt::NoItemFlags;
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  if (!row.mark) return Qt::ItemIsEnabled;
  Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
  if (editable(*row.mark, index.column())) flags |= Qt::ItemIsEditable;
  return flags;
}

ValuesModel::Typed ValuesModel::typed(const QModelIndex& index, const QString& text) const {
  const auto mark = markOf(index);
  if (!mark || !editable(*mark, index.column())) return {};
  if (text == data(index, Qt::EditRole).toString()) return {document_.history().committed(), {}};
  const Quantity quantity = quantityOf(index.column());
  const QuantityReading reading =
      readQuantity(text, quantity, settings_.units(), valueAt(*mark, index.column()));
  if (!reading.value) return {{}, refusalOf(reading, quantity, settings_.units())};
  Result<Button> next = edited(*mark, index.column(), *reading.value);
  if (next) next = document_.history().ruled(*next);
  if (!next) return {{}, sentenceOf(next.failure(), settings_.units())};
  return {*next, {}};
}

QString ValuesModel::doubt(const QModelIndex& index, const QString& text) const {
  const auto mark = markOf(index);
  if (!mark || text == data(index, Qt::EditRole).toString()) return {};
  const Quantity quantity = quantityOf(index.column());
  const QuantityReading reading =
      readQuantity(text, quantity, settings_.units(), valueAt(*mark, index.column()));
  return reading.value ? doubtOf(text, *reading.value, quantity, settings_.units()) : QString();
}

bool ValuesModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const auto mark = markOf(index);
  if (role != Qt::EditRole || !mark || !editable(*mark, index.column())) return false;
  if (document_.history().dragging()) return false;  // another edit holds the button
  const Typed next = typed(index, value.toString());
  if (!next.button) {
    emit refused(index, next.refusal);
    return false;
  }
  emit accepted();
  document_.history().apply(*next.button, tr("Set: %1").arg(nameOf(*mark)));
  return true;
}

std::optional<MarkId> ValuesModel::markOf(const QModelIndex& index) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  return rows_[static_cast<std::size_t>(index.row())].mark;
}

std::optional<int> ValuesModel::rowOf(MarkId mark) const {
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (rows_[i].mark == mark) return static_cast<int>(i);
  return {};
}

}  // namespace detent::editor
