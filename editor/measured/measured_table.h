// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The measured switches as a table: every figure, filtered, sorted, nearest first.

#include <map>
#include <memory>
#include <optional>
#include <QAbstractTableModel>
#include <vector>

#include "editor/document/display_units.h"
#include "editor/measured/switch_filter.h"

namespace detent::editor {

/// Contents of an open library. Immutable once it is shared.
struct MeasuredSwitches {
  std::vector<importer::LibrarySwitch> switches;
  importer::FeelMap map;  ///< position of each switch on the map
  importer::RatingsByName ratings = importer::RatingsByName({});
};

/// Index of a switch in the library. The table shows some of the switches.
using SwitchIndex = std::size_t;

/// Table whose row headers are the switches' names. GUI thread.
class MeasuredTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column {
    kindColumn,
    distanceColumn,
    forecastColumn,
    firstFigureColumn,
    licenceColumn = firstFigureColumn + static_cast<int>(keyFigureCount),
    creditColumn,
    fileColumn,
    columns
  };

  using QAbstractTableModel::QAbstractTableModel;

  /// Removes requested distances and forecasts; filter and order stay.
  void setSwitches(std::shared_ptr<const MeasuredSwitches> switches);
  void setUnits(const DisplayUnits& units);
  void setFilter(SwitchFilter filter);
  /// Computes the distances of all switches from this shape; without a shape there are none. If no column is
  /// sorted, the nearest switch comes first.
  void rankBy(const std::optional<importer::FeltShape>& like);
  /// Forecast of one switch, in a few words.
  void setForecast(SwitchIndex of, const QString& words);
  /// Sorts by a column; -1: the nearest first, or by name. Missing values come last in either order.
  void sort(int column, Qt::SortOrder order = Qt::AscendingOrder) override;

  const std::vector<importer::LibrarySwitch>& switches() const;
  const importer::FeelMap& map() const;
  /// Switches of the rows, from the top.
  const std::vector<SwitchIndex>& shown() const { return shown_; }
  std::optional<double> distanceOf(SwitchIndex of) const;
  /// Spread over all records of that switch by its laboratory.
  importer::SwitchSpread spreadOf(SwitchIndex of) const;
  /// Ratings of switches with this switch's name.
  std::vector<importer::Rating> ratingsOf(SwitchIndex of) const;
  bool ranked() const { return !distances_.empty(); }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  void arrange();
  void order();
  template <class KeyOf>
  void orderBy(KeyOf keyOf);
  QString text(const importer::LibrarySwitch& entry, SwitchIndex index, int column) const;
  QString tip(const importer::LibrarySwitch& entry, int column) const;

  std::shared_ptr<const MeasuredSwitches> all_;
  std::vector<QString> searched_;  // searched text of each switch
  std::vector<SwitchIndex> shown_;
  std::vector<double> distances_;  // distance of each switch, in lab noises; empty: no distances requested
  std::map<SwitchIndex, QString> forecasts_;
  SwitchFilter filter_;
  DisplayUnits units_;
  int sortColumn_ = -1;
  Qt::SortOrder sortOrder_ = Qt::AscendingOrder;
};

}  // namespace detent::editor
