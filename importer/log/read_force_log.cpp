// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <limits>

#include "importer/log/force_log.h"
#include "importer/log/log_columns.h"
#include "importer/log/recorded_switches.h"
#include "importer/log/split_strokes.h"
#include "importer/log/text_lines.h"
#include "importer/strokes/calmed_points.h"
#include "model/number_table.h"
#include "model/text.h"

namespace detent::importer {
namespace {

constexpr std::size_t sniffedLines = 400;

/// A run of samples that never takes more than a fixed amount of memory: when it is full, neighbours are
/// averaged and from then on every sample stands for twice as many rows.
class BoundedRun {
 public:
  void add(CurvePoint p) {
    sum_.displacement_mm += p.displacement_mm;
    sum_.force_N += p.force_N;
    if (++inSum_ < perSample_) return;
    flush();
    if (samples_.size() >= most) halve();
  }
  void flush() {
    if (inSum_ == 0) return;
    const double n = static_cast<double>(inSum_);
    samples_.push_back({sum_.displacement_mm / n, sum_.force_N / n});
    sum_ = {};
    inSum_ = 0;
  }
  std::vector<CurvePoint>& samples() { return samples_; }
  std::size_t rowsPerSample() const { return perSample_; }

 private:
  static constexpr std::size_t most = 1 << 20;

  void halve() {
    for (std::size_t i = 0; i + 1 < samples_.size(); i += 2) {
      const CurvePoint &a = samples_[i], &b = samples_[i + 1];
      samples_[i / 2] = {0.5 * (a.displacement_mm + b.displacement_mm), 0.5 * (a.force_N + b.force_N)};
    }
    samples_.resize(samples_.size() / 2);
    perSample_ *= 2;
  }

  std::vector<CurvePoint> samples_;
  CurvePoint sum_;
  std::size_t inSum_ = 0, perSample_ = 1;
};

/// Mean force over the last twentieth of the range of displacements, less that over the first.
double forceAtEnds_N(const std::vector<CurvePoint>& samples) {
  constexpr double endShare = 0.05;
  const auto [least, most] = std::ranges::minmax(samples, {}, &CurvePoint::displacement_mm);
  const double end_mm = endShare * (most.displacement_mm - least.displacement_mm);
  const auto mean_N = [&](double from_mm, double to_mm) {
    double sum_N = 0, count = 0;
    for (const CurvePoint& p : samples)
      if (p.displacement_mm >= from_mm && p.displacement_mm <= to_mm) sum_N += p.force_N, ++count;
    return sum_N / std::max(1.0, count);
  };
  return mean_N(most.displacement_mm - end_mm, most.displacement_mm) -
         mean_N(least.displacement_mm, least.displacement_mm + end_mm);
}

/// All numbers of a file in columns' units: one run, or press and release apart where the file says so.
struct LogRows {
  BoundedRun run, press, release;
  BoundedRun clock;  ///< times instead of forces' places: (s, as the displacements are written)
  bool isSplit = false;
  long rows = 0, skipped = 0;
  long firstSkippedLine = 0;
  std::string firstSkippedText;
};

std::string nameOf(const std::string& path) { return std::filesystem::path(path).filename().string(); }

class LogReader {
 public:
  LogReader(const std::string& path, const LogHints& hints, const Progress& progress)
      : path_(path), hints_(hints), progress_(progress) {}

  Result<ForceLog> read() {
    if (const auto failure = holdsRecordedSwitches(path_) ? readRecorded() : readRows()) return *failure;
    if (const auto failure = settleUnits()) return *failure;
    if (const auto failure = formStrokes()) return *failure;
    removePreload();
    placeContacts();
    tellSpeeds();
    noteRows();
    return std::move(log_);
  }

 private:
  Failure failure(FailureCode code, Message place, Message problem, Remedies remedies) const {
    return {code, nameOf(path_), std::move(place), std::move(problem), std::move(remedies)};
  }

  /// The one of several switches that is asked for.
  Result<const RecordedSwitch*> chosen(const std::vector<RecordedSwitch>& switches) const {
    if (switches.size() == 1 && hints_.curve.empty()) return &switches.front();
    std::string all;
    for (std::size_t i = 0; i < switches.size(); ++i) {
      if (!hints_.curve.empty() &&
          (hints_.curve == std::to_string(i + 1) || lowered(hints_.curve) == lowered(switches[i].name)))
        return &switches[i];
      all += (i > 0 ? ", " : "") + std::to_string(i + 1) +
             (switches[i].name.empty() ? "" : " \"" + switches[i].name + "\"");
    }
    return failure(hints_.curve.empty() ? FailureCode::notCertain : FailureCode::wrongUsage, "",
                   Message("it holds %1 switches: %2", switches.size(), all),
                   Message("Pass --curve NAME|N for one of them"));
  }

  std::optional<Failure> readRecorded() {
    const auto switches = recordedSwitches(path_);
    if (!switches) return switches.failure();
    const auto one = chosen(*switches);
    if (!one) return one.failure();
    const RecordedSwitch& recorded = **one;
    for (const CurvePoint& p : recorded.press) rows_.press.add(p);
    for (const CurvePoint& p : recorded.release) rows_.release.add(p);
    for (const CurvePoint& p : recorded.run) rows_.run.add(p);
    for (BoundedRun* run : {&rows_.run, &rows_.press, &rows_.release}) run->flush();
    rows_.isSplit = recorded.run.empty();
    rows_.rows = static_cast<long>(recorded.press.size() + recorded.release.size() + recorded.run.size());
    columns_.xUnit = recorded.xUnit, columns_.yUnit = recorded.yUnit;
    log_.operatingPoint_mm = recorded.operatingPoint, log_.resetPoint_mm = recorded.resetPoint;
    if (recorded.scaleDoubtful) log_.remarks.push_back({RemarkCode::forceScaleDoubtful});
    return {};
  }

  std::optional<Failure> readRows() {
    Result<LineReader> opened = LineReader::open(path_);
    if (!opened) return opened.failure();
    LineReader& reader = *opened;
    std::vector<std::string> lines;
    std::string_view line;
    while (lines.size() < sniffedLines && reader.next(line)) lines.emplace_back(line);
    format_ = formatOf(lines);
    const auto columns = columnsOf(lines, format_);
    if (!columns) {
      if (reader.isBroken())
        return failure(FailureCode::unreadableInput, "line " + std::to_string(reader.lineNumber() + 1),
                       Message("the line does not end"),
                       Message("Give a force meter's CSV file with one sample per line"));
      return failure(
          FailureCode::noForceGraph, "first " + std::to_string(lines.size()) + " lines",
          Message("no two columns of numbers were found"),
          Message(
              "Give a CSV with a displacement and a force column, for example \"displacement_mm,force_N\""));
    }
    columns_ = *columns;
    rows_.isSplit = columns_.pairs.size() == 2 || columns_.label.has_value();
    for (std::size_t i = columns_.firstRow; i < lines.size(); ++i)
      takeRow(lines[i], static_cast<long>(i + 1));
    while (reader.next(line)) {
      takeRow(line, reader.lineNumber());
      if ((reader.lineNumber() & 0xFFFF) != 0) continue;
      if (progress_.report) progress_.report(0.5 * reader.fractionRead(), ImportStep::read);
      if (progress_.isCancelled()) return Failure::cancelled(nameOf(path_));
    }
    if (reader.isBroken())
      return failure(FailureCode::unreadableInput, "line " + std::to_string(reader.lineNumber() + 1),
                     Message("the file cannot be read further"), "Export the measurement again");
    for (BoundedRun* run : {&rows_.run, &rows_.press, &rows_.release, &rows_.clock}) run->flush();
    return {};
  }

  void takeRow(std::string_view line, long number) {
    splitCells(line, format_.delimiter, cells_);
    if (std::all_of(cells_.begin(), cells_.end(), [](std::string_view c) { return c.empty(); })) return;
    bool taken = false;
    for (std::size_t i = 0; i < columns_.pairs.size(); ++i) {
      const ColumnPair& pair = columns_.pairs[i];
      const auto x = numberAt(pair.displacement), f = numberAt(pair.force);
      if (!x || !f) continue;
      BoundedRun* run = runFor(pair);
      if (!run) continue;
      run->add({*x, *f});
      if (const auto time = columns_.time ? numberAt(*columns_.time) : std::nullopt; time && !taken)
        rows_.clock.add({*time * columns_.secondsPerTime, *x});
      taken = true;
    }
    ++rows_.rows;
    if (taken) return;
    if (rows_.skipped++ == 0) {
      rows_.firstSkippedLine = number;
      rows_.firstSkippedText = std::string(line.substr(0, 40));
    }
  }

  std::optional<double> numberAt(std::size_t column) const {
    if (column >= cells_.size()) return std::nullopt;
    const auto value = wholeNumberIn(cells_[column], format_.decimalSign);
    return value && std::isfinite(*value) ? value : std::nullopt;
  }

  BoundedRun* runFor(const ColumnPair& pair) {
    if (!rows_.isSplit) return &rows_.run;
    const auto stroke =
        columns_.label
            ? (*columns_.label < cells_.size() ? strokeNamed(cells_[*columns_.label]) : std::nullopt)
            : pair.stroke;
    if (!stroke) return nullptr;
    return *stroke == Stroke::press ? &rows_.press : &rows_.release;
  }

  std::optional<Failure> settleUnits() {
    const std::size_t samples =
        rows_.run.samples().size() + rows_.press.samples().size() + rows_.release.samples().size();
    if (samples == 0)
      return failure(FailureCode::noForceGraph, skippedPlace(),
                     Message("no row holds a finite displacement and force"),
                     Message("Check the export: each row needs two numbers"));
    LengthUnit xUnit = LengthUnit::millimetre;
    if (hints_.xUnit)
      xUnit = *hints_.xUnit;
    else if (columns_.xUnit)
      xUnit = *columns_.xUnit;
    else
      log_.remarks.push_back({RemarkCode::displacementUnitAssumed,
                              {symbolOf(xUnit)},
                              {{RemedyKind::giveXUnit, "if it is another"}}});
    ForceUnit yUnit = ForceUnit::newton;
    if (hints_.yUnit) {
      yUnit = *hints_.yUnit;
    } else if (columns_.yUnit) {
      yUnit = *columns_.yUnit;
    } else {
      // Buttons press with 0.1 to 10 N; written in gf the same forces are 10 to 1000.
      yUnit = greatestForce() > 12 ? ForceUnit::gramForce : ForceUnit::newton;
      log_.remarks.push_back(
          {RemarkCode::forceUnitAssumed, {symbolOf(yUnit)}, {{RemedyKind::giveYUnit, "if it is another"}}});
    }
    log_.xUnit = symbolOf(xUnit);
    log_.yUnit = symbolOf(yUnit);
    const double mm = millimetresPer(xUnit), newton = newtonsPer(yUnit);
    for (BoundedRun* run : {&rows_.run, &rows_.press, &rows_.release})
      for (CurvePoint& p : run->samples()) p.displacement_mm *= mm, p.force_N *= newton;
    for (CurvePoint& p : rows_.clock.samples()) p.force_N *= mm;
    for (std::optional<double>* contact_mm : {&log_.operatingPoint_mm, &log_.resetPoint_mm})
      if (*contact_mm) **contact_mm *= mm;
    return {};
  }

  double greatestForce() {
    double greatest = 0;
    for (BoundedRun* run : {&rows_.run, &rows_.press, &rows_.release})
      for (const CurvePoint& p : run->samples()) greatest = std::max(greatest, std::abs(p.force_N));
    return greatest;
  }

  std::string skippedPlace() const {
    return rows_.skipped > 0 ? "line " + std::to_string(rows_.firstSkippedLine) : std::string();
  }

  std::optional<Failure> formStrokes() {
    settleSigns();
    std::vector<CurvePoint> press, release;
    if (rows_.isSplit) {
      press = std::move(rows_.press.samples());
      release = std::move(rows_.release.samples());
    } else if (auto fault = splitRun(press, release)) {
      return fault;
    }
    if (hints_.swapStrokes) std::swap(press, release);
    if (auto fault = faultOf(press, "press")) return fault;
    if (!release.empty())
      if (auto fault = faultOf(release, "release")) return fault;
    orient(press, Stroke::press);
    orient(release, Stroke::release);
    estimateNoise(press, release);
    endBeforeDwell(press, log_.noise_mm, log_.noise_N);
    startAtZero(press, release);
    log_.strokes.press.points = bridged(press);
    if (!release.empty()) log_.strokes.release = StrokePoints{bridged(release), {}, false};
    return {};
  }

  std::optional<Failure> faultOf(const std::vector<CurvePoint>& stroke, const std::string& name) const {
    if (stroke.size() < 2)
      return failure(FailureCode::noForceGraph, name + " stroke",
                     stroke.empty() ? Message("it has no sample") : Message("it has one sample"),
                     Message("A stroke needs at least two samples at different displacements; check the rows "
                             "and the split"));
    const auto [least, most] = std::minmax_element(
        stroke.begin(), stroke.end(),
        [](const CurvePoint& a, const CurvePoint& b) { return a.displacement_mm < b.displacement_mm; });
    if (!(most->displacement_mm > least->displacement_mm))
      return failure(FailureCode::noForceGraph, name + " stroke", Message("its displacement never changes"),
                     Message("Check which column holds the displacement"));
    return {};
  }

  /// Compression counts up and pushes with positive force, whatever the instrument's signs are. Single wild samples have no say.
  void settleSigns() {
    std::vector<CurvePoint> calm;
    // A table of a handful of rows was written by hand or thinned out: each of them counts.
    constexpr std::size_t handful = 16;
    for (BoundedRun* run : {&rows_.run, &rows_.press, &rows_.release}) {
      const std::vector<CurvePoint>& samples = run->samples();
      std::ranges::copy(samples.size() < handful ? samples : calmed(samples), std::back_inserter(calm));
    }
    const auto [lowest, highest] = std::ranges::minmax(calm, {}, &CurvePoint::force_N);
    const bool turned = -lowest.force_N > 1.5 * std::max(highest.force_N, 0.0);
    if (turned) log_.remarks.push_back({RemarkCode::forcesTurned});
    CurvePoint mean;
    const double n = static_cast<double>(calm.size());
    for (const CurvePoint& p : calm)
      mean.displacement_mm += p.displacement_mm / n, mean.force_N += p.force_N / n;
    double together = 0;
    for (const CurvePoint& p : calm)
      together += (p.displacement_mm - mean.displacement_mm) * (p.force_N - mean.force_N);
    const double sign = turned ? -1 : 1;
    // A dome that collapses has most of its force in the first half of its travel: only what ends softer than it began runs backwards.
    const bool reversed = sign * together < 0 && sign * forceAtEnds_N(calm) < 0;
    if (reversed) log_.remarks.push_back({RemarkCode::displacementTurned});
    for (std::optional<double>* contact_mm : {&log_.operatingPoint_mm, &log_.resetPoint_mm})
      if (reversed && *contact_mm) **contact_mm = -**contact_mm;
    for (BoundedRun* run : {&rows_.run, &rows_.press, &rows_.release})
      for (CurvePoint& p : run->samples()) {
        if (turned) p.force_N = -p.force_N;
        if (reversed) p.displacement_mm = -p.displacement_mm;
      }
    for (CurvePoint& p : rows_.clock.samples())
      if (reversed) p.force_N = -p.force_N;
  }

  std::optional<Failure> splitRun(std::vector<CurvePoint>& press, std::vector<CurvePoint>& release) {
    const std::vector<CurvePoint>& samples = rows_.run.samples();
    if (auto fault = faultOf(samples, "only")) return fault;
    std::vector<double> x;
    x.reserve(samples.size());
    for (const CurvePoint& p : samples) x.push_back(p.displacement_mm);
    const auto [least, most] = std::minmax_element(x.begin(), x.end());
    const double range = *most - *least;
    const std::vector<StrokeSpan> spans =
        spansOf(samples, std::max(0.05 * range, std::min(0.3 * range, 8 * noiseOf(x))));
    const FirstCycle cycle = firstCycleOf(spans, samples);
    const auto copy = [&](const StrokeSpan& span) {
      return std::vector<CurvePoint>(samples.begin() + static_cast<std::ptrdiff_t>(span.from),
                                     samples.begin() + static_cast<std::ptrdiff_t>(span.to) + 1);
    };
    if (!cycle.press && hints_.swapStrokes && !spans.empty()) {
      release = copy(spans.front());
      return {};
    }
    if (!cycle.press)
      return failure(FailureCode::noForceGraph, "", Message("it holds a release stroke but no press"),
                     {{RemedyKind::swapStrokes, "if this is one"},
                      {RemedyKind::advice, Message("Else record the press too")}});
    press = copy(*cycle.press);
    if (cycle.release) release = copy(*cycle.release);
    if (cycle.cycles > 1) log_.remarks.push_back({RemarkCode::severalPresses, {cycle.cycles}});
    return {};
  }

  static void orient(std::vector<CurvePoint>& stroke, Stroke kind) {
    if (stroke.empty()) return;
    const bool grows = stroke.back().displacement_mm >= stroke.front().displacement_mm;
    if (grows != (kind == Stroke::press)) std::reverse(stroke.begin(), stroke.end());
  }

  void estimateNoise(const std::vector<CurvePoint>& press, const std::vector<CurvePoint>& release) {
    double greatest = 0;
    for (const std::vector<CurvePoint>* stroke : {&press, &release}) {
      std::vector<double> x, f;
      for (const CurvePoint& p : *stroke) {
        x.push_back(p.displacement_mm), f.push_back(p.force_N);
        greatest = std::max(greatest, std::abs(p.force_N));
      }
      log_.noise_mm = std::max(log_.noise_mm, noiseOf(x));
      log_.noise_N = std::max(log_.noise_N, noiseOf(f));
    }
    // A log without visible noise (computed, or flat) still needs a yardstick; a millionth of the span is far
    // below any.
    const double travel = std::abs(press.back().displacement_mm - press.front().displacement_mm);
    constexpr double least = std::numeric_limits<double>::min();
    log_.noise_mm = std::max({log_.noise_mm, 1e-6 * travel, least});
    log_.noise_N = std::max({log_.noise_N, 1e-6 * greatest, least});
  }

  void startAtZero(std::vector<CurvePoint>& press, std::vector<CurvePoint>& release) {
    double least = std::numeric_limits<double>::infinity();
    for (const CurvePoint& p : press) least = std::min(least, p.displacement_mm);
    if (least >= 0) return;
    for (std::vector<CurvePoint>* stroke : {&press, &release})
      for (CurvePoint& p : *stroke) p.displacement_mm -= least;
    for (std::optional<double>* contact_mm : {&log_.operatingPoint_mm, &log_.resetPoint_mm})
      if (*contact_mm) **contact_mm -= least;
    log_.remarks.push_back({RemarkCode::displacementShifted, {{least, Measure::displacement_mm}}});
  }

  void removePreload() {
    std::vector<CurvePoint>& press = log_.strokes.press.points;
    const auto offset = forceBeforeContact(press, log_.noise_N);
    if (!offset || std::abs(*offset) < log_.noise_N) return;
    log_.preload_N = *offset;
    for (CurvePoint& p : press) p.force_N -= *offset;
    if (log_.strokes.release)
      for (CurvePoint& p : log_.strokes.release->points) p.force_N -= *offset;
    log_.remarks.push_back({RemarkCode::preloadTakenOff, {{*offset, Measure::force_N}}});
  }

  /// A contact outside of its stroke's travel is none.
  void placeContacts() {
    const auto keepWithin = [](std::optional<double>& contact_mm, const std::vector<CurvePoint>& stroke) {
      const auto [least, most] = std::ranges::minmax(stroke, {}, &CurvePoint::displacement_mm);
      if (contact_mm && !(*contact_mm >= least.displacement_mm && *contact_mm <= most.displacement_mm))
        contact_mm.reset();
    };
    keepWithin(log_.operatingPoint_mm, log_.strokes.press.points);
    keepWithin(log_.resetPoint_mm,
               log_.strokes.release ? log_.strokes.release->points : log_.strokes.press.points);
  }

  /// From the first way down that is complete, and the way back after it.
  void tellSpeeds() {
    const std::vector<CurvePoint>& clock = rows_.clock.samples();
    if (clock.size() < 8) return;
    const auto [least, most] = std::ranges::minmax(clock, {}, &CurvePoint::force_N);
    const double range_mm = most.force_N - least.force_N;
    if (!(range_mm > 0)) return;
    constexpr double endShare = 0.1;  // of the travel, at each end: there a stroke begins and stops
    const double low_mm = least.force_N + endShare * range_mm, middle_mm = least.force_N + 0.5 * range_mm,
                 high_mm = most.force_N - endShare * range_mm;
    // When a place is passed, straight between samples; from `at` on.
    const auto passes = [&](double place_mm, bool down, std::size_t& at) -> std::optional<double> {
      for (at = std::max<std::size_t>(at, 1); at < clock.size(); ++at) {
        const CurvePoint &a = clock[at - 1], &b = clock[at];
        if (down ? a.force_N < place_mm && b.force_N >= place_mm
                 : a.force_N > place_mm && b.force_N <= place_mm)
          return std::lerp(a.displacement_mm, b.displacement_mm,
                           (place_mm - a.force_N) / (b.force_N - a.force_N));
      }
      return {};
    };
    std::size_t at = 1;
    const auto stroke = [&](bool down) -> std::optional<StrokeSpeed> {
      const auto begun_s = passes(down ? low_mm : high_mm, down, at);
      const auto half_s = passes(middle_mm, down, at), ended_s = passes(down ? high_mm : low_mm, down, at);
      if (!begun_s || !half_s || !ended_s || !(*half_s > *begun_s) || !(*ended_s > *half_s)) return {};
      const double first_s = *half_s - *begun_s, second_s = *ended_s - *half_s;
      return StrokeSpeed{(high_mm - low_mm) / (*ended_s - *begun_s),
                         std::max(first_s / second_s, second_s / first_s)};
    };
    log_.pressSpeed = stroke(true);
    if (log_.pressSpeed) log_.releaseSpeed = stroke(false);
  }

  void noteRows() {
    log_.rowsRead = rows_.rows;
    log_.rowsSkipped = rows_.skipped;
    const std::size_t together =
        std::max({rows_.run.rowsPerSample(), rows_.press.rowsPerSample(), rows_.release.rowsPerSample()});
    if (together > 1) log_.remarks.push_back({RemarkCode::rowsAveraged, {together}});
    if (rows_.skipped > 0)
      log_.remarks.push_back({RemarkCode::rowsLeftOut,
                              {rows_.skipped, rows_.rows, rows_.firstSkippedLine, rows_.firstSkippedText}});
    if (!log_.strokes.release) log_.remarks.push_back({RemarkCode::noRelease});
  }

  const std::string& path_;
  const LogHints& hints_;
  const Progress& progress_;
  TableFormat format_;
  LogColumns columns_;
  LogRows rows_;
  std::vector<std::string_view> cells_;
  ForceLog log_;
};

}  // namespace

bool isForceLogPath(const std::string& path) {
  return holdsRecordedSwitches(path) || lowered(std::filesystem::path(path).extension().string()) == ".csv";
}

Result<ForceLog> readForceLog(const std::string& path, const LogHints& hints, const Progress& progress) {
  return LogReader(path, hints, progress).read();
}

}  // namespace detent::importer
