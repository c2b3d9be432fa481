// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/log/interpret_columns.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "importer/log/form_records.h"
#include "importer/log/split_strokes.h"
#include "importer/page/quantile.h"
#include "model/text.h"
#include "model/units.h"

namespace detent::importer {
namespace {

using Columns = std::vector<std::size_t>;  // positions in DataTable::columns

constexpr double kNamed = 2;        // log-likelihood from which a column counts as named
constexpr double kPossible = -1.5;  // log-likelihood from which a column may be a force or a displacement

/// The column that the user gave by number or title; nullopt if there is none with it.
std::optional<std::size_t> columnGiven(const DataTable& data, const std::string& given) {
  const std::string wanted = lowered(trimmed(given));
  int number = 0;
  const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
  if (error == std::errc() && end == wanted.data() + wanted.size()) {
    for (std::size_t i = 0; i < data.columns.size(); ++i)
      if (data.columns[i].index + 1 == static_cast<std::size_t>(std::max(0, number))) return i;
    return {};
  }
  std::optional<std::size_t> part;
  for (std::size_t i = 0; i < data.columns.size(); ++i) {
    const DataColumn& column = data.columns[i];
    const std::string title = lowered(column.title);
    const std::string whole = column.group.empty() ? title : lowered(column.group) + ": " + title;
    for (const std::string& name : {title, whole, title + " (" + lowered(column.unit.text) + ")",
                                    whole + " (" + lowered(column.unit.text) + ")"})
      if (name == wanted) return i;
    if (!part && !title.empty() && title.find(wanted) != std::string::npos) part = i;
  }
  return part;
}

/// Returns true if b is the running maximum of the magnitude of a.
bool isPeakHold(const DataColumn& a, const DataColumn& b) {
  double most = 0, off = 0;
  std::size_t count = 0, held = 0;
  const double span = std::max(std::abs(a.high), std::abs(a.low));
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    if (std::isnan(a.values[i]) || std::isnan(b.values[i])) continue;
    most = std::max(most, std::abs(a.values[i]));
    off += std::abs(most - std::abs(b.values[i]));
    held += std::abs(a.values[i]) < most;
    ++count;
  }
  constexpr double within = 0.005;  // share of the span, on average
  return count >= 8 && held * 20 >= count && span > 0 && off / static_cast<double>(count) < within * span;
}

/// Factor k where b = k a within a thousandth of the span; 0 if there is none.
double proportionOf(const DataColumn& a, const DataColumn& b) {
  double ab = 0, aa = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    if (std::isnan(a.values[i]) != std::isnan(b.values[i])) return 0;
    if (std::isnan(a.values[i])) continue;
    ab += a.values[i] * b.values[i], aa += a.values[i] * a.values[i];
  }
  if (!(aa > 0)) return 0;
  const double k = ab / aa;
  double worst = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i)
    if (!std::isnan(a.values[i])) worst = std::max(worst, std::abs(b.values[i] - k * a.values[i]));
  constexpr double within = 0.004;  // share of the span, for the rounding of a column with few digits
  return worst <= within * (b.high - b.low) ? k : 0;
}

/// Returns true if the values of `total` are the sum of the others'.
bool isSum(const DataTable& data, std::size_t total, const Columns& others) {
  if (others.size() < 2) return false;
  // Columns under different headings belong to different switches and are no parts of one sum.
  for (const std::size_t c : others)
    if (data.columns[c].group != data.columns[total].group) return false;
  double worst = 0;
  for (std::size_t i = 0; i < data.rows(); ++i) {
    double sum = 0;
    for (const std::size_t c : others) sum += data.columns[c].values[i];
    if (std::isnan(sum) || std::isnan(data.columns[total].values[i])) continue;
    worst = std::max(worst, std::abs(sum - data.columns[total].values[i]));
  }
  constexpr double within = 0.02;  // share of the span
  const DataColumn& column = data.columns[total];
  return column.high > column.low && worst <= within * (column.high - column.low);
}

std::vector<CurvePoint> byDisplacement(std::vector<CurvePoint> stroke) {
  std::ranges::stable_sort(stroke, {}, &CurvePoint::displacement_mm);
  return stroke;
}

/// Force of a stroke that is sorted by displacement; beyond its ends the force of the nearest end.
double forceAt(const std::vector<CurvePoint>& sorted, double x) {
  const auto after = std::ranges::lower_bound(sorted, x, {}, &CurvePoint::displacement_mm);
  if (after == sorted.begin()) return sorted.front().force_N;
  if (after == sorted.end()) return sorted.back().force_N;
  const CurvePoint &a = *(after - 1), &b = *after;
  const double width = b.displacement_mm - a.displacement_mm;
  return width > 0 ? std::lerp(a.force_N, b.force_N, (x - a.displacement_mm) / width) : b.force_N;
}

class Interpreter {
 public:
  Interpreter(const Table& table, const DataTable& data, const LogHints& hints, bool eitherStroke)
      : table_(table), data_(data), hints_(hints), eitherStroke_(eitherStroke) {}

  ColumnReading read() {
    if (!takeHints()) return std::move(result_);
    chooseCandidates();
    if (result_.lack != TableLack::none) return std::move(result_);
    arrange();
    // Units are weighed first and records copied later, because a table without units has dozens of readings.
    BestFew<WeighedUnits> weighed(kKept);
    TableLack lack = TableLack::strokes;
    for (std::size_t i = 0; i < arrangements_.size(); ++i) {
      LogInterpretation& arrangement = arrangements_[i];
      if (const TableLack why = formRecords(arrangement); why != TableLack::none) {
        lack = why == TableLack::strokes ? lack : why;
        continue;
      }
      judgeStrokes(arrangement);
      for (const AssumedUnit& x : unitsOf(arrangement, false))
        for (const AssumedUnit& y : unitsOf(arrangement, true)) {
          Evidence evidence = arrangement.evidence;
          evidence.add(unitEvidence(arrangement.records.front(), x, y));
          weighed.offer({i, x, y, std::move(evidence)});
        }
    }
    std::vector<std::size_t> uses(arrangements_.size());
    for (const WeighedUnits& each : weighed.kept()) ++uses[each.arrangement];
    for (WeighedUnits& each : weighed.kept()) {
      LogInterpretation& arrangement = arrangements_[each.arrangement];
      LogInterpretation made = --uses[each.arrangement] > 0 ? arrangement : std::move(arrangement);
      made.xUnit = each.x, made.yUnit = each.y, made.evidence = std::move(each.evidence);
      scale(made.records, each.x.size, each.y.size);
      result_.best.push_back(std::move(made));
    }
    if (result_.best.empty()) result_.lack = lack;
    return std::move(result_);
  }

 private:
  static constexpr std::size_t kKept = 12;  // readings
  struct WeighedUnits {
    std::size_t arrangement = 0;
    AssumedUnit x, y;
    Evidence evidence;
  };

  const DataColumn& column(std::size_t c) const { return data_.columns[c]; }

  bool takeHints() {
    const auto take = [&](const std::string& given, std::optional<std::size_t>& place) {
      if (given.empty()) return true;
      place = columnGiven(data_, given);
      if (!place) result_.badColumn = given;
      return place.has_value();
    };
    return take(hints_.columns.displacement, givenX_) && take(hints_.columns.force, givenF_) &&
           take(hints_.columns.releaseDisplacement, givenReleaseX_) &&
           take(hints_.columns.releaseForce, givenReleaseF_) && take(hints_.columns.stroke, givenStroke_) &&
           take(hints_.columns.cycle, givenCycle_);
  }

  bool named(const Columns& all, bool force) const {
    return std::ranges::any_of(
        all, [&](std::size_t c) { return (force ? column(c).force : column(c).displacement) >= kNamed; });
  }

  /// Returns true for a force in volts or counts, as an uncalibrated load cell gives it. Compound units and
  /// pressures belong to other quantities.
  static bool isForceInOtherUnit(const DataColumn& each) {
    const std::string& unit = each.unit.text;
    return !each.isText && !each.isConstant() && each.quantity == ColumnQuantity::force &&
           each.unit.kind == ColumnUnit::Kind::other && unit.find('/') == std::string::npos &&
           unit.find("Pa") == std::string::npos && unit.find('m') == std::string::npos &&
           !each.words.has(ColumnWord::other);
  }

  bool isGiven(std::size_t c) const {
    for (const auto& given : {givenX_, givenF_, givenReleaseX_, givenReleaseF_, givenStroke_, givenCycle_})
      if (given == c) return true;
    return false;
  }

  void chooseCandidates() {
    Columns possibleX, possibleF;
    for (std::size_t c = 0; c < data_.columns.size(); ++c) {
      const DataColumn& each = column(c);
      if (each.isText || each.count < 2) continue;
      if (each.unit.kind == ColumnUnit::Kind::unknown) {
        if (each.quantity == ColumnQuantity::force && result_.unknownUnit.empty())
          result_.unknownUnit = each.unit.text, result_.unknownUnitOfForce = true;
        if (each.quantity == ColumnQuantity::displacement && result_.unknownUnit.empty())
          result_.unknownUnit = each.unit.text;
      }
      if (each.displacement >= kPossible && !(givenX_ && isGiven(c) && givenX_ != c)) possibleX.push_back(c);
      if (each.force >= kPossible && !(givenF_ && isGiven(c) && givenF_ != c)) possibleF.push_back(c);
    }
    const auto namedOf = [&](const Columns& all, bool force) {
      Columns named;
      for (const std::size_t c : all)
        if ((force ? column(c).force : column(c).displacement) >= kNamed) named.push_back(c);
      return named;
    };
    xs_ = namedOf(possibleX, false), fs_ = namedOf(possibleF, true);
    if (xs_.empty()) xs_ = possibleX;
    if (fs_.empty()) fs_ = possibleF;
    // A column such as "Force (V)" is taken if there is no other column of force. Its unit is unknown.
    if (fs_.empty() || !named(fs_, true))
      for (std::size_t c = 0; c < data_.columns.size(); ++c)
        if (isForceInOtherUnit(column(c)) && result_.unknownUnit.empty()) {
          fs_ = {c};
          result_.unknownUnit = column(c).unit.text, result_.unknownUnitOfForce = true;
        }
    if (givenX_) xs_ = {*givenX_};
    if (givenF_) fs_ = {*givenF_};
    for (const auto& [given, force] : {std::pair(givenX_, false), {givenF_, true}})
      if (given && column(*given).unit.kind == ColumnUnit::Kind::other && result_.unknownUnit.empty())
        result_.unknownUnit = column(*given).unit.text, result_.unknownUnitOfForce = force;
    // A constant column measures nothing; the failure then names this reason.
    const auto moves = [&](const Columns& all) {
      return std::ranges::any_of(all, [&](std::size_t c) { return !column(c).isConstant(); });
    };
    const auto strokesNamed = [&] {
      return std::ranges::any_of(
          data_.columns, [](const DataColumn& each) { return !each.isText && each.displacement >= kNamed; });
    };
    bool stillDisplacement = false;
    for (const DataColumn& each : data_.columns)
      stillDisplacement =
          stillDisplacement || (!each.isText && each.isConstant() && each.displacement + 15 >= kNamed);
    if (xs_.empty() && fs_.empty())
      result_.lack = TableLack::columns;
    else if (xs_.empty())
      result_.lack = stillDisplacement ? TableLack::movement : TableLack::displacement;
    else if (fs_.empty())
      result_.lack = TableLack::force;
    else if ((stillDisplacement && !strokesNamed()) || !moves(xs_))
      result_.lack = TableLack::movement;
    // One column cannot be both displacement and force.
    if (result_.lack == TableLack::none && xs_.size() == 1 && fs_ == xs_)
      result_.lack = column(xs_.front()).displacement > column(xs_.front()).force ? TableLack::force
                                                                                  : TableLack::displacement;
    if (!givenX_) dropCopies(xs_, false);
    if (!givenF_) dropCopies(fs_, true);
  }

  /// Leaves out columns that repeat another one: in another unit, as peak hold, filtered, as bounds of a
  /// mean, or as a part of a total. Axes that do not move are left out too.
  void dropCopies(Columns& all, bool force) {
    const auto strokeOf = [&](std::size_t c) { return columnStroke(c); };
    const auto erase = [&](auto is) {
      Columns kept;
      for (const std::size_t c : all)
        if (!is(c)) kept.push_back(c);
      if (!kept.empty()) all = kept;
    };
    if (all.size() < 2) return;
    const auto isSecond = [&](std::size_t c) {
      return column(c).words.has(ColumnWord::spread) || column(c).words.has(ColumnWord::copy);
    };
    const bool plain = std::ranges::any_of(all, [&](std::size_t c) { return !isSecond(c); });
    if (plain) erase(isSecond);
    if (force) {
      erase([&](std::size_t c) {
        return std::ranges::any_of(all, [&](std::size_t other) {
          return other != c && strokeOf(other) == strokeOf(c) && isPeakHold(column(other), column(c));
        });
      });
      for (const std::size_t total : Columns(all)) {
        Columns others = all;
        std::erase(others, total);
        if (isSum(data_, total, others)) {
          all = {total};
          return;
        }
      }
    }
    // Of columns with the same readings, in another unit or place, the first one is kept.
    Columns kept;
    for (const std::size_t c : all) {
      const bool copy = std::ranges::any_of(kept, [&](std::size_t other) {
        const double k = strokeOf(other) == strokeOf(c) ? proportionOf(column(other), column(c)) : 0;
        if (k == 0) return false;
        const double wanted = column(other).unit.size / column(c).unit.size;
        constexpr double within = 0.005;  // share of the ratio
        return std::abs(k / wanted - 1) < within || column(c).unit.kind != column(other).unit.kind;
      });
      if (!copy) kept.push_back(c);
    }
    all = kept;
  }

  /// The stroke that a column's words name. A word that also names a quantity ("load") counts only if no
  /// other word names a stroke.
  std::optional<Stroke> columnStroke(std::size_t c) const {
    const auto in = [](const KnownWords& known) -> std::optional<Stroke> {
      std::optional<Stroke> weak;
      for (const KnownWords::Word& word : known.words) {
        if (word.has(ColumnWord::release)) return Stroke::release;
        if (word.has(ColumnWord::press) && !word.has(ColumnWord::force) &&
            !word.has(ColumnWord::displacement))
          return Stroke::press;
        if (word.has(ColumnWord::press)) weak = Stroke::press;
      }
      return weak;
    };
    if (const auto own = in(column(c).words)) return own;
    return in(column(c).groupWords);
  }

  /// The displacement column that belongs to a force column.
  std::size_t displacementFor(std::size_t force) const {
    if (xs_.size() == 1) return xs_.front();
    const auto at = static_cast<std::size_t>(std::ranges::find(fs_, force) - fs_.begin());
    if (xs_.size() == fs_.size()) return xs_[at];
    // The nearest displacement column to the left, else the first.
    std::size_t best = xs_.front();
    for (const std::size_t x : xs_)
      if (x < force) best = x;
    return best;
  }

  std::string groupName(std::size_t force, bool withoutStroke) const {
    const auto nameOf = [&](std::size_t c) {
      return column(c).group.empty() ? column(c).title : column(c).group;
    };
    std::string name = nameOf(force);
    const KnownWords& own = column(force).words;
    const bool isQuantity =
        own.unknown == 0 && std::ranges::all_of(own.words, [](const KnownWords::Word& word) {
          return word.has(ColumnWord::force);
        });
    if (!column(force).group.empty() && !column(force).title.empty() && !isQuantity &&
        xs_.size() < fs_.size())
      name = column(force).title;
    std::string rest;
    for (std::size_t at = 0; at < name.size();) {
      // "-40 °C" has a sign.
      const bool isSigned =
          name[at] == '-' && at + 1 < name.size() && name[at + 1] >= '0' && name[at + 1] <= '9';
      const std::size_t end = std::min(name.find_first_of(" _-,:", at + (isSigned ? 1 : 0)), name.size());
      const std::string word = name.substr(at, end - at);
      const KnownWords known = knownWordsIn(word);
      const bool stroke = known.has(ColumnWord::press) || known.has(ColumnWord::release);
      const bool quantity = known.has(ColumnWord::force) || known.has(ColumnWord::displacement);
      if (!(withoutStroke && stroke) && !(quantity && column(force).group.empty()) && !word.empty())
        rest += (rest.empty() ? "" : " ") + word;
      at = end + 1;
    }
    return rest;
  }

  void offer(std::vector<ColumnGroup> groups, const Evidence& evidence) {
    LogInterpretation made;
    made.groups = std::move(groups);
    std::set<std::size_t> used;
    for (const ColumnGroup& group : made.groups) used.insert({group.displacement, group.force});
    double x = 0, f = 0;
    for (const ColumnGroup& group : made.groups)
      x += column(group.displacement).displacement, f += column(group.force).force;
    const double count = static_cast<double>(made.groups.size());
    const std::size_t firstX = made.groups.front().displacement, firstF = made.groups.front().force;
    made.evidence.add("displacement", column(firstX).label(), x / count);
    made.evidence.add("force", column(firstF).label(), f / count);
    constexpr double byHand = 3;  // log-likelihood, equal to that of a unit in the title
    if (hints_.xUnit && column(firstX).unit.kind == ColumnUnit::Kind::none)
      made.evidence.add("given", std::string(symbolOf(*hints_.xUnit)), byHand);
    if (hints_.yUnit && column(firstF).unit.kind == ColumnUnit::Kind::none)
      made.evidence.add("given", std::string(symbolOf(*hints_.yUnit)), byHand);
    made.evidence.add(evidence);
    // number of columns titled as forces that this arrangement does not use
    double left = 0;
    for (const std::size_t c : fs_)
      if (!used.contains(c) && (column(c).force >= kNamed || severalRecords_)) left += 1;
    constexpr double leftWorth = -3;  // log-likelihood of each unused column
    if (left > 0)
      made.evidence.add("left over", std::to_string(static_cast<int>(left)) + " columns of force",
                        leftWorth * left);
    arrangements_.push_back(std::move(made));
  }

  void arrange() {
    if (givenReleaseF_ || givenReleaseX_) {
      const std::size_t f = fs_.front(), x = xs_.front();
      const std::size_t releaseF = givenReleaseF_.value_or(f), releaseX = givenReleaseX_.value_or(x);
      if (!givenF_) std::erase(fs_, releaseF);
      if (fs_.empty()) fs_ = {f};
      offer({{x, fs_.front(), Stroke::press, ""}, {releaseX, releaseF, Stroke::release, ""}}, {});
      return;
    }
    // Columns that name strokes are forces, with or without a unit.
    Columns stroked;
    bool release = false;
    for (const std::size_t c : fs_)
      if (const auto stroke = columnStroke(c))
        stroked.push_back(c), release = release || stroke == Stroke::release;
    if (release && stroked.size() >= 2 && !givenF_) {
      fs_ = stroked;
      Columns others;
      for (const std::size_t x : xs_)
        if (std::ranges::find(fs_, x) == fs_.end()) others.push_back(x);
      if (!others.empty()) {
        xs_ = others;
        arrangeBeside();
        if (!arrangements_.empty()) return;
      }
    }
    findRecordColumns();
    // If there is one column of force, or none that certainly is one, its rows contain all strokes.
    if (!severalRecords_ &&
        (!std::ranges::any_of(fs_, [&](std::size_t c) { return column(c).force >= kNamed; }) ||
         fs_.size() == 1 || givenF_)) {
      for (const std::size_t x : xs_)
        for (const std::size_t f : fs_)
          if (x != f) offer({{x, f, {}, ""}}, orderEvidence(x, f));
      // Four columns without titles may be x and y of both strokes.
      if (data_.columns.size() == 4 && fs_.size() == 4 && xs_.size() == 4 && !givenX_ && !givenF_)
        offer({{0, 1, Stroke::press, ""}, {2, 3, Stroke::release, ""}}, orderEvidence(0, 1));
      return;
    }
    for (const std::size_t f : fs_)
      for (const std::size_t x : xs_)
        if (x != f && (xs_.size() == 1 || x == displacementFor(f))) offer({{x, f, {}, ""}}, {});
    arrangeBeside();
  }

  /// If no column is called a force, columns titled by conditions or specimens are the forces of one record
  /// each.
  void findRecordColumns() {
    Columns records, others;
    for (const std::size_t c : fs_)
      if (column(c).namesRecord)
        records.push_back(c);
      else if (column(c).force >= kNamed)
        return;
    for (const std::size_t c : xs_)
      if (!column(c).namesRecord) others.push_back(c);
    if (records.size() < 2 || others.empty() || givenF_) return;
    severalRecords_ = true;
    xs_ = others, fs_ = records;
  }

  /// Arranges several columns of force as strokes, records, or both.
  void arrangeBeside() {
    std::vector<ColumnGroup> groups;
    bool release = false;
    for (const std::size_t f : fs_) {
      const std::size_t x = displacementFor(f);
      if (x == f) return;
      auto stroke = columnStroke(f);
      if (!stroke && xs_.size() == fs_.size()) stroke = columnStroke(x);
      release = release || stroke == Stroke::release;
      groups.push_back({x, f, stroke, groupName(f, false)});
    }
    if (release) {
      // A column beside one that is called release holds the press.
      for (ColumnGroup& group : groups)
        if (!group.stroke) group.stroke = Stroke::press;
      if (groups.size() == 2 && groups[0].stroke != groups[1].stroke) {
        if (groups[0].stroke == Stroke::release) std::swap(groups[0], groups[1]);
        groups[0].name.clear(), groups[1].name.clear();
      } else {
        for (ColumnGroup& group : groups) group.name = groupName(group.force, true);
      }
      Evidence evidence;
      evidence.add("strokes named", column(groups.back().force).label(), 3);
      offer(groups, evidence);
      return;
    }
    for (ColumnGroup& group : groups) group.stroke.reset();
    Evidence beside;
    offer(groups, beside);
    if (groups.size() == 2 && !severalRecords_) {
      groups[0].stroke = Stroke::press, groups[1].stroke = Stroke::release;
      groups[0].name.clear(), groups[1].name.clear();
      Evidence strokes;
      strokes.add("strokes beside", "two columns of force", endsMeet(groups[0], groups[1]) ? 1 : -5);
      offer(groups, strokes);
    }
  }

  /// Returns true if two columns of force meet where the displacement is greatest, as press and release do.
  bool endsMeet(const ColumnGroup& a, const ColumnGroup& b) const {
    const auto at = [&](const ColumnGroup& g) {
      double x = -std::numeric_limits<double>::infinity(), f = 0;
      for (std::size_t i = 0; i < data_.rows(); ++i)
        if (column(g.displacement).values[i] >= x && !std::isnan(column(g.force).values[i]))
          x = column(g.displacement).values[i], f = column(g.force).values[i];
      return f;
    };
    constexpr double within = 0.02;  // share of the span
    return std::abs(at(a) - at(b)) <= within * (column(a.force).high - column(a.force).low);
  }

  /// Evidence by the order of columns without titles: displacement usually comes first and in even steps,
  /// possibly after a counter or a clock.
  Evidence orderEvidence(std::size_t x, std::size_t f) const {
    Evidence evidence;
    if (column(x).displacement >= kNamed && column(f).force >= kNamed) return evidence;
    evidence.add("order", x < f ? "displacement before force" : "force before displacement",
                 x < f ? 0.7 : -0.7);
    const auto steps = [&](std::size_t c) {
      std::vector<double> all;
      const std::vector<double>& values = column(c).values;
      for (std::size_t i = 1; i < values.size(); ++i)
        if (!std::isnan(values[i]) && !std::isnan(values[i - 1]))
          all.push_back(std::abs(values[i] - values[i - 1]));
      return all;
    };
    const auto unevenness = [&](std::size_t c) {
      std::vector<double> all = steps(c);
      if (all.size() < 16) return 1.0;
      const double middle = medianOf(all);
      if (!(middle > 0)) return 1.0;
      double off = 0;
      for (const double step : all) off += std::min(1.0, std::abs(step - middle) / middle);
      return off / static_cast<double>(all.size());
    };
    evidence.add("steps", "even displacement", 4 * (unevenness(f) - unevenness(x)));
    if (column(x).countsRows() && data_.columns.size() > 2) evidence.add("counter", column(x).label(), -4);
    return evidence;
  }

  /// The unit given by hand, the column's own, or those that it may have.
  std::vector<AssumedUnit> unitsOf(const LogInterpretation& made, bool force) const {
    const ColumnGroup& group = made.groups.front();
    const ColumnUnit& unit = column(force ? group.force : group.displacement).unit;
    const bool isOwn = unit.kind == (force ? ColumnUnit::Kind::force : ColumnUnit::Kind::displacement);
    if (force ? hints_.yUnit.has_value() : hints_.xUnit.has_value())
      return {force ? AssumedUnit{std::string(symbolOf(*hints_.yUnit)), newtonsPer(*hints_.yUnit)}
                    : AssumedUnit{std::string(symbolOf(*hints_.xUnit)), millimetresPer(*hints_.xUnit)}};
    return isOwn ? std::vector<AssumedUnit>{{unit.text, unit.size}} : possibleUnits(force);
  }

  TableLack formRecords(LogInterpretation& made) {
    RecordRequest request;
    request.table = &table_, request.data = &data_;
    request.strokeColumn = givenStroke_, request.cycleColumn = givenCycle_;
    request.swap = hints_.swapStrokes, request.eitherStroke = eitherStroke_;
    return detent::importer::formRecords(request, made);
  }

  static void scale(std::vector<LogRecord>& records, double mm, double newton) {
    for (LogRecord& record : records)
      for (std::vector<CurvePoint>* stroke : {&record.press, &record.release})
        for (CurvePoint& p : *stroke) p.displacement_mm *= mm, p.force_N *= newton;
  }

  /// Adds evidence by the shape of a button's strokes.
  static void judgeStrokes(LogInterpretation& made) {
    const LogRecord& record = made.records.front();
    const std::vector<CurvePoint>& press = record.press;
    const auto extremes = std::ranges::minmax(press, {}, &CurvePoint::force_N);
    const double lowest_N = extremes.min.force_N, highest_N = extremes.max.force_N;
    const double span_N = highest_N - lowest_N;
    if (!(span_N > 0)) return made.evidence.add("force", "never changes", -12);
    const auto share = [&](double force_N) { return (force_N - lowest_N) / span_N; };
    const double first = std::abs(press.front().force_N) / std::max(highest_N, 1e-12);
    made.evidence.add("start", "force at the start of the press",
                      first < 0.1    ? 1
                      : first < 0.35 ? 0
                      : first < 0.7  ? -1
                                     : -2.5);
    const double last = share(press.back().force_N);
    made.evidence.add("end", "force at the end of the press", last > 0.9 ? 1.5 : last > 0.5 ? 0 : -2.5);
    if (lowest_N < -0.15 * highest_N) made.evidence.add("sign", "pulls", -3);
    if (press.size() < 5) made.evidence.add("rows", "few", -1.5);
    if (record.release.size() < 2) return;
    const std::vector<CurvePoint>& release = record.release;
    const double gap = std::abs(release.front().force_N - press.back().force_N) / span_N;
    made.evidence.add("strokes meet", "where they turn", gap < 0.15 ? 0.5 : -3);
    const double finish = share(release.back().force_N);
    made.evidence.add("release", "force at its end", finish < 0.35 ? 0.5 : -3);
    double above = 0, count = 0;
    const std::vector<CurvePoint> sorted = byDisplacement(press);
    const std::size_t every = std::max<std::size_t>(1, release.size() / 100);
    for (std::size_t i = 0; i < release.size(); i += every) {
      const double x = release[i].displacement_mm;
      if (!(x > sorted.front().displacement_mm && x <= sorted.back().displacement_mm)) continue;
      above += forceAt(sorted, x) - release[i].force_N > -0.02 * span_N, count += 1;
    }
    if (count > 0)
      made.evidence.add("hysteresis", "press above release",
                        above / count > 0.7   ? 1
                        : above / count > 0.4 ? -1
                                              : -4);
  }

  const Table& table_;
  const DataTable& data_;
  const LogHints& hints_;
  bool eitherStroke_ = false;
  std::optional<std::size_t> givenX_, givenF_, givenReleaseX_, givenReleaseF_, givenStroke_, givenCycle_;
  Columns xs_, fs_;
  bool severalRecords_ = false;  // fs_ are titled by conditions or specimens
  std::vector<LogInterpretation> arrangements_;
  ColumnReading result_;
};

std::vector<double> resampled(const std::vector<CurvePoint>& stroke, const std::vector<double>& positions) {
  const std::vector<CurvePoint> sorted = byDisplacement(stroke);
  std::vector<double> forces;
  forces.reserve(positions.size());
  for (const double x : positions) forces.push_back(forceAt(sorted, x));
  return forces;
}

std::pair<double, double> rangeOf(const std::vector<CurvePoint>& stroke) {
  const auto [low, high] = std::ranges::minmax(stroke, {}, &CurvePoint::displacement_mm);
  return {low.displacement_mm, high.displacement_mm};
}

std::vector<double> positionsIn(double from, double to) {
  constexpr std::size_t count = 200;
  std::vector<double> positions;
  for (std::size_t i = 0; i <= count; ++i) positions.push_back(std::lerp(from, to, double(i) / count));
  return positions;
}

}  // namespace

std::string LogInterpretation::reading(const DataTable& data) const {
  std::string text;
  for (const ColumnGroup& group : groups) {
    if (!text.empty()) text += "; ";
    if (group.stroke) text += *group.stroke == Stroke::press ? "press " : "release ";
    text += "displacement " + data.columns[group.displacement].label() + ", force " +
            data.columns[group.force].label();
  }
  text += ", in " + xUnit.symbol + " and " + yUnit.symbol;
  if (records.size() > 1) text += ", " + std::to_string(records.size()) + " records";
  return text;
}

ColumnReading interpretColumns(const Table& table, const DataTable& data, const LogHints& hints,
                               bool eitherStroke) {
  return Interpreter(table, data, hints, eitherStroke).read();
}

std::vector<AssumedUnit> possibleUnits(bool force) {
  // Log-likelihoods of units for tables that state none, relative to the most common unit. They are cautious
  // guesses; the units were not counted.
  constexpr double seldom = -1.5, rare = -2, oddest = -2.5;
  std::vector<AssumedUnit> all;
  if (force)
    for (const auto& [unit, prior] : {std::pair(ForceUnit::newton, 0.0),
                                      {ForceUnit::gramForce, -0.3},
                                      {ForceUnit::centinewton, rare},
                                      {ForceUnit::millinewton, rare},
                                      {ForceUnit::kilogramForce, rare},
                                      {ForceUnit::poundForce, oddest},
                                      {ForceUnit::ounceForce, oddest}})
      all.push_back({std::string(symbolOf(unit)), newtonsPer(unit), prior});
  else
    for (const auto& [unit, prior] : {std::pair(LengthUnit::millimetre, 0.0),
                                      {LengthUnit::micrometre, seldom},
                                      {LengthUnit::inch, oddest},
                                      {LengthUnit::mil, oddest}})
      all.push_back({std::string(symbolOf(unit)), millimetresPer(unit), prior});
  return all;
}

Evidence unitEvidence(const LogRecord& record, const AssumedUnit& x, const AssumedUnit& y) {
  Evidence evidence;
  const auto [low, high] = std::ranges::minmax(record.press, {}, &CurvePoint::displacement_mm);
  const double highest = std::ranges::max_element(record.press, {}, &CurvePoint::force_N)->force_N;
  // From 154 presses of keyboards, tact switches, domes and industrial buttons: log-normal, with wider tails
  // than those presses had.
  constexpr double usualTravel_mm = 2.6, travelSpread = 0.8;
  constexpr double usualForce_N = 1.8, forceSpread = 1.1;  // spreads of the logarithms
  const auto judge = [&](const char* name, const char* unit, double value, double usual, double spread) {
    constexpr double least = -12;  // log-likelihood
    const double z = value > 0 ? std::log(value / usual) / spread : 0;
    char text[40];
    std::snprintf(text, sizeof text, "%.4g %s", value, unit);
    evidence.addCounted(name, text, value > 0 ? std::max(least, -0.5 * z * z) : least);
  };
  judge("travel", "mm", (high.displacement_mm - low.displacement_mm) * x.size, usualTravel_mm, travelSpread);
  judge("highest force", "N", std::max(0.0, highest) * y.size, usualForce_N, forceSpread);
  for (const AssumedUnit& unit : {x, y})
    if (unit.prior) evidence.addCounted("unit assumed", unit.symbol, *unit.prior);
  return evidence;
}

double differenceOf(const LogRecord& a, const LogRecord& b) {
  if (a.release.empty() != b.release.empty()) return 1;
  double worst = 0;
  const auto [lowest, highest] = std::ranges::minmax(a.press, {}, &CurvePoint::force_N);
  const double span_N = highest.force_N - lowest.force_N;
  for (const auto& [p, q] : {std::pair(&a.press, &b.press), std::pair(&a.release, &b.release)}) {
    if (p->size() < 2 || q->size() < 2) continue;
    const auto [low, high] = rangeOf(*p);
    const auto [otherLow, otherHigh] = rangeOf(*q);
    const double travel = high - low;
    if (!(travel > 0) || !(span_N > 0)) return 1;
    constexpr double sameTravel = 0.1;  // share of the travel
    if (std::abs(otherHigh - otherLow - travel) > sameTravel * travel) return 1;
    const std::vector<double> positions = positionsIn(std::max(low, otherLow), std::min(high, otherHigh));
    const std::vector<double> f = resampled(*p, positions), g = resampled(*q, positions);
    double sum = 0;
    for (std::size_t i = 0; i < positions.size(); ++i) sum += std::abs(f[i] - g[i]);
    worst = std::max(worst, sum / static_cast<double>(positions.size()) / span_N);
    worst = std::max(worst, std::abs(high - otherHigh) / travel / 2);
  }
  return worst;
}

LogRecord meanOf(const std::vector<LogRecord>& records) {
  LogRecord mean;
  mean.name = "mean";
  const auto average = [&](auto of) {
    std::vector<CurvePoint> stroke;
    double low = 0, high = 0;
    std::size_t most = 0;
    for (const LogRecord& each : records) {
      const std::vector<CurvePoint>& points = of(each);
      if (points.size() < 2) return std::vector<CurvePoint>{};
      const auto [from, to] = rangeOf(points);
      low += from / double(records.size()), high += to / double(records.size());
      most = std::max(most, points.size());
    }
    // Points are averaged at equal shares of the travel, so that the ends meet.
    for (std::size_t i = 0; i < most; ++i) {
      const double share = most > 1 ? double(i) / double(most - 1) : 0;
      double force = 0;
      for (const LogRecord& each : records) {
        const auto [from, to] = rangeOf(of(each));
        force += resampled(of(each), {std::lerp(from, to, share)}).front() / double(records.size());
      }
      stroke.push_back({std::lerp(low, high, share), force});
    }
    return stroke;
  };
  mean.press = average([](const LogRecord& r) -> const std::vector<CurvePoint>& { return r.press; });
  mean.release = average([](const LogRecord& r) -> const std::vector<CurvePoint>& { return r.release; });
  std::ranges::reverse(mean.release);
  return mean;
}

}  // namespace detent::importer
