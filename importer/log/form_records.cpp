// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/log/form_records.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include "importer/log/split_strokes.h"
#include "importer/page/quantile.h"
#include "importer/strokes/calmed_points.h"
#include "model/text.h"

namespace detent::importer {
namespace {

/// One row of the chosen columns.
struct Sample {
  CurvePoint point;
  std::size_t row = 0;  ///< data row
};

struct FoundStroke {
  Stroke stroke = Stroke::press;
  std::vector<CurvePoint> points;  ///< in the order travelled
  std::string name;
  double travel = 0;
  bool cutBefore = false;  ///< not joined to the stroke before it in the file
};

/// Cuts between the rows of a column, and names of the parts.
struct Cuts {
  std::map<std::size_t, std::string> at;           ///< data row: name of the part that begins there
  std::vector<std::optional<Stroke>> strokeOfRow;  ///< empty: no row names a stroke
};

class RecordFormer {
 public:
  RecordFormer(const RecordRequest& request, LogInterpretation& made)
      : table_(*request.table), data_(*request.data), request_(request), made_(made) {}

  TableLack form() {
    std::vector<std::vector<Sample>> runs;
    for (const ColumnGroup& group : made_.groups) {
      runs.push_back(samplesOf(group));
      if (runs.back().size() < 2) return TableLack::strokes;
    }
    for (const auto& run : runs)
      if (!moves(run)) return TableLack::movement;
    settleSigns(runs);
    const bool strokesBeside = made_.groups.front().stroke.has_value();
    if (strokesBeside) {
      joinBeside(runs);
    } else {
      const Cuts cuts = findCuts(runs.front());
      made_.fromRun = true;
      for (std::size_t i = 0; i < runs.size(); ++i) {
        if (holdsSortedLoop(pointsOf(runs[i]))) return TableLack::sortedLoop;
        const std::size_t before = made_.records.size();
        joinRun(strokesOf(runs[i], cuts));
        for (std::size_t k = before; k < made_.records.size(); ++k) {
          LogRecord& record = made_.records[k];
          if (record.name.empty() || runs.size() > 1)
            record.name = made_.groups[i].name +
                          (record.name.empty() || made_.groups[i].name.empty() ? "" : " ") + record.name;
        }
      }
    }
    for (LogRecord& record : made_.records) {
      if (request_.swap || (request_.eitherStroke && record.press.empty()))
        std::swap(record.press, record.release);
      orient(record.press, true), orient(record.release, false);
      if (record.release.size() < 2) record.release.clear();
    }
    std::erase_if(made_.records, [](const LogRecord& each) { return each.press.size() < 2; });
    return made_.records.empty() ? TableLack::strokes : TableLack::none;
  }

 private:
  static std::vector<CurvePoint> pointsOf(const std::vector<Sample>& run) {
    std::vector<CurvePoint> points;
    points.reserve(run.size());
    for (const Sample& each : run) points.push_back(each.point);
    return points;
  }

  std::vector<Sample> samplesOf(const ColumnGroup& group) const {
    std::vector<Sample> run;
    const std::vector<double>&x = data_.columns[group.displacement].values,
          &f = data_.columns[group.force].values;
    run.reserve(x.size());
    for (std::size_t row = 0; row < data_.rows(); ++row)
      if (!std::isnan(x[row]) && !std::isnan(f[row])) run.push_back({{x[row], f[row]}, row});
    return run;
  }

  /// Returns false if the displacement changes by noise only.
  static bool moves(const std::vector<Sample>& run) {
    std::vector<double> x;
    for (const Sample& each : run) x.push_back(each.point.displacement_mm);
    const auto [low, high] = std::ranges::minmax(x);
    constexpr double trembles = 8;  // noises
    constexpr std::size_t enough = 30;
    if (x.size() >= enough && high - low < trembles * noiseOf(x)) return false;
    return high > low;
  }

  /// Turns signs so that displacement grows on a press and pressing forces are positive, whatever signs the
  /// instrument uses. Single outliers have no effect.
  void settleSigns(std::vector<std::vector<Sample>>& runs) {
    std::vector<CurvePoint> calm;
    // below this number every row counts: it was written by hand or thinned
    constexpr std::size_t handful = 16;
    for (const auto& run : runs) {
      constexpr std::size_t enough = 4096;  // points
      const std::size_t every = run.size() / enough + 1;
      std::vector<CurvePoint> points;
      for (std::size_t i = 0; i < run.size(); i += every) points.push_back(run[i].point);
      std::ranges::copy(points.size() < handful ? points : calmed(points), std::back_inserter(calm));
    }
    const auto [lowest, highest] = std::ranges::minmax(calm, {}, &CurvePoint::force_N);
    made_.forcesTurned = -lowest.force_N > 1.5 * std::max(highest.force_N, 0.0);
    CurvePoint mean;
    const double n = static_cast<double>(calm.size());
    for (const CurvePoint& p : calm)
      mean.displacement_mm += p.displacement_mm / n, mean.force_N += p.force_N / n;
    double together = 0;
    for (const CurvePoint& p : calm)
      together += (p.displacement_mm - mean.displacement_mm) * (p.force_N - mean.force_N);
    const double sign = made_.forcesTurned ? -1 : 1;
    // The displacement is turned only if the press also ends softer than it began, because a dome that
    // collapses has most of its force in the first half of its travel.
    made_.displacementTurned = sign * together < 0 && sign * forceAtEnds(calm) < 0;
    for (auto& run : runs)
      for (Sample& each : run) {
        if (made_.forcesTurned) each.point.force_N = -each.point.force_N;
        if (made_.displacementTurned) each.point.displacement_mm = -each.point.displacement_mm;
      }
  }

  /// Mean force over the last twentieth of the displacement range, minus that over the first twentieth.
  static double forceAtEnds(const std::vector<CurvePoint>& samples) {
    constexpr double endShare = 0.05;
    const auto [least, most] = std::ranges::minmax(samples, {}, &CurvePoint::displacement_mm);
    const double end = endShare * (most.displacement_mm - least.displacement_mm);
    const auto meanForce = [&](double from, double to) {
      double sum = 0, count = 0;
      for (const CurvePoint& p : samples)
        if (p.displacement_mm >= from && p.displacement_mm <= to) sum += p.force_N, ++count;
      return sum / std::max(1.0, count);
    };
    return meanForce(most.displacement_mm - end, most.displacement_mm) -
           meanForce(least.displacement_mm, least.displacement_mm + end);
  }

  static void orient(std::vector<CurvePoint>& stroke, bool rises) {
    if (stroke.empty()) return;
    if ((stroke.back().displacement_mm >= stroke.front().displacement_mm) != rises)
      std::ranges::reverse(stroke);
  }

  /// Joins columns of presses with columns of releases beside them, by name if there are several switches.
  void joinBeside(const std::vector<std::vector<Sample>>& runs) {
    for (std::size_t i = 0; i < runs.size(); ++i)
      if (made_.groups[i].stroke == Stroke::press)
        made_.records.push_back({made_.groups[i].name, pointsOf(runs[i]), {}});
    std::size_t next = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (made_.groups[i].stroke != Stroke::release) continue;
      const std::string& name = made_.groups[i].name;
      auto record = std::ranges::find_if(made_.records, [&](const LogRecord& each) {
        return each.release.empty() && lowered(each.name) == lowered(name);
      });
      if (record == made_.records.end()) {
        record =
            std::ranges::find_if(made_.records, [](const LogRecord& each) { return each.release.empty(); });
        if (next++ > 0 || record == made_.records.end()) continue;
      }
      record->release = pointsOf(runs[i]);
    }
    if (made_.records.empty() && (request_.swap || request_.eitherStroke))
      for (std::size_t i = 0; i < runs.size(); ++i)
        made_.records.push_back({made_.groups[i].name, {}, pointsOf(runs[i])});
  }

  // -- where a run is cut -----------------------------------------------------------------------------------

  std::string_view cellOf(std::size_t column, std::size_t row) const {
    return table_.cell(data_.rowOf[row], data_.columns[column].index);
  }

  Cuts findCuts(const std::vector<Sample>& run) {
    Cuts cuts;
    labelRows(cuts, run);
    nameRows(cuts);
    for (const DataBreak& each : data_.breaks) {
      if (each.text.empty()) continue;
      // Repeated headings, as on every page of a printout, cut nothing. If the displacement jumps back there,
      // that cuts.
      const std::string first = each.text.substr(0, each.text.find('\n'));
      const KnownWords named = knownWordsIn(first);
      const bool isTitle = named.has(ColumnWord::displacement) && named.has(ColumnWord::force);
      const bool names = named.has(ColumnWord::record) || named.has(ColumnWord::cycle) ||
                         named.has(ColumnWord::press) || named.has(ColumnWord::release);
      if (isTitle || !names) continue;
      cuts.at[each.row] = first;
      if (const auto stroke = strokeNamedIn(first);
          stroke && !named.has(ColumnWord::record) && !named.has(ColumnWord::cycle)) {
        if (cuts.strokeOfRow.empty()) cuts.strokeOfRow.resize(data_.rows());
        std::size_t end = data_.rows();
        for (const DataBreak& next : data_.breaks)
          if (next.row > each.row) end = std::min(end, next.row);
        for (std::size_t row = each.row; row < end; ++row) cuts.strokeOfRow[row] = stroke;
        cuts.at[each.row].clear();
      }
    }
    // The line above the first block names it, as the lines in the breaks name the other blocks.
    if (!data_.breaks.empty() && !cuts.at.empty() && !data_.captions.empty()) {
      const std::string& caption = data_.captions.back();
      const KnownWords named = knownWordsIn(caption);
      const bool isHeading = named.has(ColumnWord::displacement) && named.has(ColumnWord::force);
      if (!isHeading && (named.has(ColumnWord::record) || named.has(ColumnWord::cycle))) cuts.at[0] = caption;
      if (const auto stroke = strokeNamedIn(caption); stroke && !isHeading && !cuts.strokeOfRow.empty())
        for (std::size_t row = 0; row < data_.breaks.front().row; ++row)
          if (!cuts.strokeOfRow[row]) cuts.strokeOfRow[row] = stroke;
    }
    return cuts;
  }

  /// Labels rows by a column whose cells state press or release, in words or by two numbers of which each
  /// stands for one direction of travel.
  void labelRows(Cuts& cuts, const std::vector<Sample>& run) {
    for (std::size_t c = 0; c < data_.columns.size(); ++c) {
      const DataColumn& column = data_.columns[c];
      if (request_.strokeColumn ? c != *request_.strokeColumn : isUsed(c)) continue;
      if (column.isText) {
        std::map<std::string, std::optional<Stroke>, std::less<>> known;
        bool all = true;
        std::size_t filled = 0;
        constexpr std::size_t mostLabels = 8;
        for (std::size_t row = 0; row < data_.rows() && all; ++row) {
          const std::string_view cell = cellOf(c, row);
          if (cell.empty()) continue;
          ++filled;
          if (const auto place = known.find(cell); place != known.end()) continue;
          const auto stroke = strokeNamedIn(cell);
          all = stroke.has_value() && known.size() < mostLabels && knownWordsIn(cell).unknown == 0;
          known.emplace(cell, stroke);
        }
        if (!all || filled * 10 < data_.rows() * 8) continue;
        cuts.strokeOfRow.resize(data_.rows());
        for (std::size_t row = 0; row < data_.rows(); ++row)
          if (const auto place = known.find(cellOf(c, row)); place != known.end())
            cuts.strokeOfRow[row] = place->second;
        made_.evidence.add("stroke column", column.label(), 2);
        return;
      }
      const bool named = column.words.has(ColumnWord::direction) ||
                         column.quantity == ColumnQuantity::displacementWeak || request_.strokeColumn == c;
      if (named && labelByNumbers(c, cuts, run)) return;
    }
  }

  bool isUsed(std::size_t c) const {
    return std::ranges::any_of(made_.groups,
                               [&](const ColumnGroup& g) { return g.displacement == c || g.force == c; });
  }

  bool labelByNumbers(std::size_t c, Cuts& cuts, const std::vector<Sample>& run) {
    const DataColumn& column = data_.columns[c];
    std::set<double> values;
    for (const double v : column.values)
      if (!std::isnan(v) && values.insert(v).second && values.size() > 2) return false;
    if (values.size() != 2) return false;
    // distance travelled while the column has each value
    std::map<double, double> up, down;
    for (std::size_t i = 1; i < run.size(); ++i) {
      const double v = column.values[run[i].row], before = column.values[run[i - 1].row];
      if (std::isnan(v) || v != before) continue;
      const double step = run[i].point.displacement_mm - run[i - 1].point.displacement_mm;
      (step > 0 ? up : down)[v] += std::abs(step);
    }
    const double a = column.values[run.front().row],
                 b = *values.begin() == a ? *values.rbegin() : *values.begin();
    const auto direction = [&](double v) { return up[v] > 4 * down[v] ? 1 : down[v] > 4 * up[v] ? -1 : 0; };
    if (direction(a) == 0 || direction(b) == 0) return false;
    const double press = direction(a) == direction(b) || direction(a) > 0 ? a : b;
    cuts.strokeOfRow.resize(data_.rows());
    for (std::size_t row = 0; row < data_.rows(); ++row)
      if (!std::isnan(column.values[row]))
        cuts.strokeOfRow[row] = column.values[row] == press ? Stroke::press : Stroke::release;
    made_.evidence.add("stroke column", column.label(), 1);
    return true;
  }

  /// Names rows by a column that numbers or names cycles or specimens.
  void nameRows(Cuts& cuts) {
    for (std::size_t c = 0; c < data_.columns.size(); ++c) {
      const DataColumn& column = data_.columns[c];
      if (request_.cycleColumn ? c != *request_.cycleColumn : isUsed(c)) continue;
      const bool named = column.words.has(ColumnWord::cycle) || column.words.has(ColumnWord::record);
      if (!named && request_.cycleColumn != c) continue;
      if (!column.isText && !column.isInteger) continue;
      std::map<std::size_t, std::string> at;
      std::string_view before;
      bool contiguous = true;
      for (std::size_t row = 0; row < data_.rows() && contiguous; ++row) {
        const std::string_view cell = cellOf(c, row);
        if (cell.empty() || cell == before) continue;
        constexpr std::size_t fewestRows = 4;
        contiguous = at.empty() || row - at.rbegin()->first >= fewestRows;
        at[row] = column.isText ? std::string(cell) : column.title + " " + std::string(cell);
        before = cell;
      }
      if (!contiguous || at.size() < 2) continue;
      for (const auto& [row, name] : at) cuts.at[row] = name;
      return;
    }
  }

  /// The strokes of a run, divided at cuts and turning points.
  std::vector<FoundStroke> strokesOf(const std::vector<Sample>& run, const Cuts& cuts) const {
    const std::vector<CurvePoint> all = pointsOf(run);
    const auto [least, most] = std::ranges::minmax(all, {}, &CurvePoint::displacement_mm);
    const double range = most.displacement_mm - least.displacement_mm;
    std::vector<double> x;
    for (const CurvePoint& p : all) x.push_back(p.displacement_mm);
    const double turn = std::max(0.05 * range, std::min(0.3 * range, 8 * noiseOf(x)));
    const auto labelOf = [&](std::size_t i) {
      return cuts.strokeOfRow.empty() ? std::nullopt : cuts.strokeOfRow[run[i].row];
    };
    // A column of row numbers does not mark records. A jump against the direction of travel before and after
    // it begins a new record.
    const auto isJump = [&](std::size_t i) {
      constexpr double leastShare = 0.5;
      const double step = x[i] - x[i - 1];
      if (std::abs(step) < leastShare * range || i < 2 || i + 1 >= x.size()) return false;
      const double before = x[i - 1] - x[i > 5 ? i - 5 : 0], after = x[std::min(i + 4, x.size() - 1)] - x[i];
      return step * before < 0 && step * after < 0;
    };
    std::vector<FoundStroke> strokes;
    std::string name;
    auto nextCut = cuts.at.begin();
    std::size_t from = 0;
    bool cutBefore = true;
    const auto take = [&](std::size_t to, bool cutAfter) {
      const std::vector<CurvePoint> part(all.begin() + static_cast<std::ptrdiff_t>(from),
                                         all.begin() + static_cast<std::ptrdiff_t>(to));
      addPart(part, labelOf(from), name, turn, cutBefore, strokes);
      from = to, cutBefore = cutAfter;
    };
    for (std::size_t i = 0; i < run.size(); ++i) {
      bool cut = false;
      std::string newName = name;
      while (nextCut != cuts.at.end() && nextCut->first <= run[i].row)
        cut = true, newName = nextCut->second, ++nextCut;
      if (i == 0) {
        name = newName;
        continue;
      }
      const bool jump = isJump(i), relabelled = labelOf(i) != labelOf(i - 1);
      if (!cut && !jump && !relabelled) continue;
      take(i, cut || jump);
      name = newName;
    }
    take(run.size(), true);
    return strokes;
  }

  static void addPart(const std::vector<CurvePoint>& part, std::optional<Stroke> label,
                      const std::string& name, double turn, bool cutBefore,
                      std::vector<FoundStroke>& strokes) {
    if (part.size() < 2) return;
    const auto add = [&](std::vector<CurvePoint> points, Stroke stroke, bool cut) {
      FoundStroke found{stroke, std::move(points), name, 0, cut};
      const auto [low, high] = std::ranges::minmax(found.points, {}, &CurvePoint::displacement_mm);
      found.travel = high.displacement_mm - low.displacement_mm;
      if (found.travel > 0) strokes.push_back(std::move(found));
    };
    if (label) {
      std::vector<CurvePoint> points = part;
      orient(points, *label == Stroke::press);
      return add(std::move(points), *label, cutBefore);
    }
    bool first = true;
    for (const StrokeSpan& span : spansOf(part, turn)) {
      // After a turning point, the first rows may still be at the same displacement; they belong to the
      // previous stroke.
      std::size_t from = span.from;
      while (from + 2 < span.to && part[from + 1].displacement_mm <= part[from].displacement_mm &&
             span.stroke == Stroke::press)
        ++from;
      add({part.begin() + static_cast<std::ptrdiff_t>(from),
           part.begin() + static_cast<std::ptrdiff_t>(span.to) + 1},
          span.stroke, first && cutBefore);
      first = false;
    }
  }

  // -- strokes joined to records ----------------------------------------------------------------------------

  static constexpr double kWhole = 0.6;          // share of the longest press; a shorter press was aborted
  static constexpr double kLeastRelease = 0.12;  // share of the longest press; shorter releases are twitches
  // share of the longest press; a press that begins this close to the beginning of the aborted one does not
  // continue it
  static constexpr double kMoved = 0.03;

  void joinRun(const std::vector<FoundStroke>& strokes) {
    double longest = 0;
    for (const FoundStroke& each : strokes)
      if (each.stroke == Stroke::press) longest = std::max(longest, each.travel);
    if (longest == 0)
      for (const FoundStroke& each : strokes) longest = std::max(longest, each.travel);
    std::optional<std::size_t> open;  // record that waits for its release
    const FoundStroke* aborted = nullptr;
    std::vector<CurvePoint> firstRelease;
    bool resumed = false;
    for (const FoundStroke& each : strokes) {
      if (each.stroke == Stroke::press) {
        if (each.travel < kWhole * longest) {
          const bool twitch = each.travel < 0.3 * longest && open && !made_.records[*open].release.empty();
          resumed = twitch;
          if (!twitch) {
            if (!aborted) aborted = &each;
            open.reset();
          }
          continue;
        }
        LogRecord record{each.name, each.points, {}};
        if (aborted && !each.cutBefore && aborted->name == each.name) joinAborted(*aborted, longest, record);
        aborted = nullptr;
        resumed = false;
        made_.records.push_back(std::move(record));
        open = made_.records.size() - 1;
        continue;
      }
      if (open && made_.records[*open].release.empty() && each.travel >= kLeastRelease * longest) {
        made_.records[*open].release = each.points;
      } else if (open && resumed) {
        // The stage paused during the release. The part after the pause is appended.
        std::vector<CurvePoint>& release = made_.records[*open].release;
        const double reached = release.back().displacement_mm;
        for (const CurvePoint& p : each.points)
          if (p.displacement_mm < reached) release.push_back(p);
        resumed = false;
      } else if (made_.records.empty() && firstRelease.empty() && each.travel >= kWhole * longest) {
        firstRelease = each.points;
      }
    }
    // A run that begins with a release, whose press comes later.
    if (firstRelease.empty()) return;
    for (LogRecord& record : made_.records)
      if (record.release.empty()) {
        record.release = std::move(firstRelease);
        return;
      }
    if (made_.records.empty() && (request_.swap || request_.eitherStroke))
      made_.records.push_back({"", {}, std::move(firstRelease)});
  }

  /// Puts the beginning of an aborted press in front of the press that continued it.
  void joinAborted(const FoundStroke& aborted, double longest, LogRecord& record) {
    const double from = aborted.points.front().displacement_mm,
                 reached = aborted.points.back().displacement_mm;
    if (record.press.front().displacement_mm - from < kMoved * longest) return;
    std::vector<CurvePoint> joined = aborted.points;
    for (const CurvePoint& p : record.press)
      if (p.displacement_mm > reached) joined.push_back(p);
    record.press = std::move(joined);
    made_.joined = true;
  }

  const Table& table_;
  const DataTable& data_;
  const RecordRequest& request_;
  LogInterpretation& made_;
};

}  // namespace

std::optional<Stroke> strokeNamedIn(std::string_view text) {
  const KnownWords known = knownWordsIn(text);
  const bool press = known.has(ColumnWord::press), release = known.has(ColumnWord::release);
  if (press == release) return {};
  return press ? Stroke::press : Stroke::release;
}

StrokeName strokeNameOf(std::string_view name) {
  StrokeName split{"", strokeNamedIn(name)};
  const auto isLetter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           static_cast<unsigned char>(c) >= 0x80;
  };
  for (auto from = name.begin(); from != name.end();) {
    const auto to = std::find_if_not(from, name.end(), isLetter);
    std::string word(from, to);
    const KnownWords known = knownWordsIn(word);
    if (known.has(ColumnWord::press) || known.has(ColumnWord::release))
      std::erase_if(word, [](char c) { return c < '0' || c > '9'; });
    if (!word.empty()) split.rest += (split.rest.empty() ? "" : " ") + word;
    from = to == name.end() ? to : to + 1;
  }
  return split;
}

TableLack formRecords(const RecordRequest& request, LogInterpretation& made) {
  return RecordFormer(request, made).form();
}

namespace {

/// Returns true if all points have nearly the same distance from their local line, as on two curves. The
/// distances of noise vary.
bool liesOnTwoCurves(const std::vector<CurvePoint>& points) {
  constexpr std::size_t window = 8;  // points
  double sum = 0, windows = 0;
  for (std::size_t from = 0; from + window <= points.size(); from += window) {
    double x = 0, f = 0, xx = 0, xf = 0, size = 0, square = 0;
    for (std::size_t i = from; i < from + window; ++i)
      x += points[i].displacement_mm / window, f += points[i].force_N / window;
    for (std::size_t i = from; i < from + window; ++i) {
      xx += (points[i].displacement_mm - x) * (points[i].displacement_mm - x);
      xf += (points[i].displacement_mm - x) * (points[i].force_N - f);
    }
    if (!(xx > 0)) continue;
    for (std::size_t i = from; i < from + window; ++i) {
      const double off = points[i].force_N - f - xf / xx * (points[i].displacement_mm - x);
      size += std::abs(off) / window, square += off * off / window;
    }
    if (square > 0) sum += size * size / square, windows += 1;
  }
  constexpr double likeTwoValues = 0.76;  // 1: two values, 0.64: a normal distribution
  return windows > 0 && sum / windows > likeTwoValues;
}

}  // namespace

bool holdsSortedLoop(const std::vector<CurvePoint>& points) {
  constexpr std::size_t fewest = 12;
  constexpr double mostTurns = 0.4;  // share of all points; a traced stroke has a handful
  if (points.size() < fewest) return false;
  const auto [low, high] = std::ranges::minmax(points, {}, &CurvePoint::force_N);
  const double least = 0.01 * (high.force_N - low.force_N);
  std::size_t turns = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    if (points[i + 1].displacement_mm < points[i].displacement_mm) return false;
    const double before = points[i].force_N - points[i - 1].force_N,
                 after = points[i + 1].force_N - points[i].force_N;
    if (before * after < 0 && std::min(std::abs(before), std::abs(after)) > least) ++turns;
  }
  return static_cast<double>(turns) > mostTurns * static_cast<double>(points.size()) &&
         liesOnTwoCurves(points);
}

}  // namespace detent::importer
