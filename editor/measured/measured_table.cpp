// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/measured/measured_table.h"

#include <algorithm>
#include <QFileInfo>

#include "editor/document/number_text.h"
#include "editor/measured/measured_words.h"
#include "editor/panels/key_figures_model.h"

namespace detent::editor {
namespace {

constexpr int distanceDecimals = 2;

std::optional<KeyFigure> figureOf(int column) {
  if (column < MeasuredTable::firstFigureColumn || column >= MeasuredTable::licenceColumn) return {};
  return static_cast<KeyFigure>(column - MeasuredTable::firstFigureColumn);
}

bool isMissing(const std::optional<double>& key) { return !key; }
bool isMissing(const QString& key) { return key.isEmpty(); }

}  // namespace

const std::vector<importer::LibrarySwitch>& MeasuredTable::switches() const {
  static const std::vector<importer::LibrarySwitch> none;
  return all_ ? all_->switches : none;
}

const importer::FeelMap& MeasuredTable::map() const {
  static const importer::FeelMap none;
  return all_ ? all_->map : none;
}

void MeasuredTable::setSwitches(std::shared_ptr<const MeasuredSwitches> switches) {
  beginResetModel();
  all_ = std::move(switches);
  distances_.clear();
  forecasts_.clear();
  searched_.clear();
  for (const importer::LibrarySwitch& each : this->switches()) searched_.push_back(searchedText(each));
  arrange();
  endResetModel();
}

void MeasuredTable::setUnits(const DisplayUnits& units) {
  units_ = units;
  if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, columns - 1));
  emit headerDataChanged(Qt::Horizontal, 0, columns - 1);
}

void MeasuredTable::setFilter(SwitchFilter filter) {
  beginResetModel();
  filter_ = std::move(filter);
  arrange();
  endResetModel();
}

void MeasuredTable::rankBy(const std::optional<importer::FeltShape>& like) {
  beginResetModel();
  distances_.clear();
  forecasts_.clear();
  if (like) {
    const importer::FeelDistance distance(*like);
    for (const importer::LibrarySwitch& each : switches()) distances_.push_back(distance.to(each.shape));
  }
  arrange();
  endResetModel();
}

void MeasuredTable::setForecast(SwitchIndex of, const QString& words) {
  forecasts_[of] = words;
  const auto at = std::ranges::find(shown_, of);
  if (at == shown_.end()) return;
  const QModelIndex changed = index(static_cast<int>(at - shown_.begin()), forecastColumn);
  emit dataChanged(changed, changed);
}

void MeasuredTable::sort(int column, Qt::SortOrder order) {
  beginResetModel();
  sortColumn_ = column;
  sortOrder_ = order;
  arrange();
  endResetModel();
}

std::optional<double> MeasuredTable::distanceOf(SwitchIndex of) const {
  return ranked() ? std::optional(distances_[of]) : std::nullopt;
}

importer::SwitchSpread MeasuredTable::spreadOf(SwitchIndex of) const {
  const importer::LibrarySwitch& entry = switches()[of];
  std::vector<importer::UnitRecord> records;
  for (const importer::LibrarySwitch& each : switches())
    if (each.name == entry.name && each.credit == entry.credit) records.push_back({each.unit, each.figures});
  return importer::spreadOf(records);
}

std::vector<importer::Rating> MeasuredTable::ratingsOf(SwitchIndex of) const {
  return all_->ratings.of(switches()[of].name);
}

void MeasuredTable::arrange() {
  shown_.clear();
  const auto& entries = switches();
  for (SwitchIndex i = 0; i < entries.size(); ++i)
    if (keeps(filter_, entries[i], searched_[i])) shown_.push_back(i);
  order();
}

template <class KeyOf>
void MeasuredTable::orderBy(KeyOf keyOf) {
  using Key = decltype(keyOf(SwitchIndex{}));
  std::vector<std::pair<Key, SwitchIndex>> keyed;
  keyed.reserve(shown_.size());
  for (const SwitchIndex each : shown_) keyed.emplace_back(keyOf(each), each);
  const bool down = sortOrder_ == Qt::DescendingOrder;
  std::ranges::stable_sort(keyed, [down](const auto& a, const auto& b) {
    const bool missing = isMissing(a.first);
    if (missing || isMissing(b.first)) return !missing && isMissing(b.first);
    return down ? b.first < a.first : a.first < b.first;
  });
  for (std::size_t i = 0; i < keyed.size(); ++i) shown_[i] = keyed[i].second;
}

void MeasuredTable::order() {
  const auto& entries = switches();
  if (sortColumn_ < 0 && ranked()) {  // independent of the last column's order
    std::ranges::stable_sort(shown_, {}, [&](SwitchIndex each) { return distances_[each]; });
    return;
  }
  if (sortColumn_ < 0) return;  // without a sorted column: the library's order, by name
  if (const auto figure = figureOf(sortColumn_))
    return orderBy([&](SwitchIndex each) { return entries[each].figures[*figure]; });
  if (sortColumn_ == distanceColumn) return orderBy([&](SwitchIndex each) { return distanceOf(each); });
  orderBy([&](SwitchIndex each) { return text(entries[each], each, sortColumn_).toLower(); });
}

int MeasuredTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(shown_.size());
}

int MeasuredTable::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : columns; }

QString MeasuredTable::text(const importer::LibrarySwitch& entry, SwitchIndex index, int column) const {
  if (const auto figure = figureOf(column)) {
    const auto& value = entry.figures[*figure];
    if (!value) return {};
    return withError(figureText(*value, *figure, units_), entry.sigmas[*figure], *figure, units_);
  }
  switch (column) {
    case kindColumn:
      return kindWords(importer::kindOf(entry.figures));
    case distanceColumn:
      return ranked() ? fixedText(distances_[index], distanceDecimals) : QString();
    case forecastColumn: {
      const auto at = forecasts_.find(index);
      return at == forecasts_.end() ? QString() : at->second;
    }
    case licenceColumn:
      return licenceWords(entry);
    case creditColumn:
      return creditWords(entry);
    case fileColumn:
      return QFileInfo(QString::fromStdString(entry.source)).fileName();
    default:
      return {};
  }
}

QString MeasuredTable::tip(const importer::LibrarySwitch& entry, int column) const {
  if (column == fileColumn) return QString::fromStdString(entry.source);
  return entry.scaleDoubtful ? creditedTitle(entry) + '\n' + doubtfulScaleWords() : creditedTitle(entry);
}

QVariant MeasuredTable::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const SwitchIndex which = shown_[static_cast<std::size_t>(index.row())];
  const importer::LibrarySwitch& entry = switches()[which];
  if (role == Qt::DisplayRole) return text(entry, which, index.column());
  if (role == Qt::ToolTipRole) return tip(entry, index.column());
  if (role == Qt::TextAlignmentRole && (figureOf(index.column()) || index.column() == distanceColumn))
    return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
  return {};
}

QVariant MeasuredTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Vertical) {
    if (section >= rowCount()) return {};
    const importer::LibrarySwitch& entry = switches()[shown_[static_cast<std::size_t>(section)]];
    if (role == Qt::DisplayRole || role == Qt::ToolTipRole) return titleOf(entry);
    return role == Qt::TextAlignmentRole ? QVariant(static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter))
                                         : QVariant();
  }
  if (const auto figure = figureOf(section)) {
    if (role == Qt::ToolTipRole)
      return tr("%1\nThe value after ± is the standard error from the meter's noise and resolution; "
                "calibration errors are not included")
          .arg(definitionOf(*figure));
    return role == Qt::DisplayRole ? figureTitle(*figure, units_) : QVariant();
  }
  const bool asTip = role == Qt::ToolTipRole;
  if (!asTip && role != Qt::DisplayRole) return {};
  switch (section) {
    case kindColumn:
      return asTip ? tr("By the tactile drop: linear below 5 gf, tactile above 8 gf, otherwise intermediate")
                   : tr("Kind");
    case distanceColumn:
      return asTip ? tr("Distance from the reference switch. 1 is the usual difference between two "
                        "laboratories that measure the same switch; below 1, both may be the same switch")
                   : tr("Distance");
    case forecastColumn:
      return asTip
                 ? tr("Predicted difference in feel from the reference switch; only for the nearest switches")
                 : tr("Prediction");
    case licenceColumn:
      return asTip ? tr("Licence of the measurements, from their folder") : tr("Licence");
    case creditColumn:
      return asTip ? tr("Author of the measurements") : tr("Credit");
    case fileColumn:
      return asTip ? tr("The file the switch was read from") : tr("File");
    default:
      return {};
  }
}

}  // namespace detent::editor
