// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/magnetic/magnetic_sensor.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "model/number_table.h"

namespace detent::playback {

namespace {

constexpr std::size_t largestTable_bytes = std::size_t{4} << 20;
constexpr double mostNoise = 1e6;

constexpr double magnetRadius_mm = 1.5, magnetLength_mm = 2, gap_mm = 1.2;
constexpr double restReading = 2048,
                 // counts of 4096: rest is at half of the scale, and a part of the upper half is used
    swingReading = 1900;
constexpr int assumedPieces = 64;

/// Field of a cylinder magnet on its axis, `distance_mm` in front of its face, as a share of its material's
/// remanence.
double fieldAt(double distance_mm) {
  const auto end = [](double z_mm) { return z_mm / std::hypot(z_mm, magnetRadius_mm); };
  return 0.5 * (end(distance_mm + magnetLength_mm) - end(distance_mm));
}

Failure unusable(const std::string& subject, Message place, Message problem, Remedies remedies) {
  return {FailureCode::unreadableInput, subject, std::move(place), std::move(problem), std::move(remedies)};
}

/// The two pairs around a value, or the last two if it lies beyond them.
template <typename Less>
std::size_t pieceOf(const std::vector<SensorPair>& pairs, Less isBelow) {
  const auto above = std::partition_point(pairs.begin(), pairs.end(), isBelow);
  const auto index = static_cast<std::size_t>(above - pairs.begin());
  return std::clamp<std::size_t>(index, 1, pairs.size() - 1) - 1;
}

}  // namespace

Result<MagneticSensor> MagneticSensor::fromPairs(std::vector<SensorPair> pairs, double noise,
                                                 const std::string& subject) {
  if (!(noise >= 0 && noise <= mostNoise))
    return Failure{FailureCode::wrongUsage, Subject::option("--noise"), "",
                   Message("the noise must lie between 0 and 1000000 counts"),
                   Message("Give the standard deviation of the readings at rest")};
  if (pairs.size() < 2)
    return unusable(subject, "", Message("the file has fewer than two pairs of displacement and reading"),
                    Message("Measure readings at several places of the travel"));
  const bool rises = pairs[1].reading > pairs[0].reading;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto place = Message("pair %1", i + 1);
    if (!std::isfinite(pairs[i].displacement_mm) || !std::isfinite(pairs[i].reading))
      return unusable(subject, place, Message("one of the two values is not a usable number"),
                      Message("Remove or correct the value"));
    if (i == 0) continue;
    if (!(pairs[i].displacement_mm > pairs[i - 1].displacement_mm))
      return unusable(subject, place, Message("this pair is not deeper than the previous one"),
                      Message("Sort the pairs by displacement"));
    if (pairs[i].reading == pairs[i - 1].reading || (pairs[i].reading > pairs[i - 1].reading) != rises)
      return unusable(
          subject, place,
          Message("readings must all rise or all fall, but this one stays the same or turns back"),
          Message("Leave out the part of the travel where the reading of the sensor stays the "
                  "same or turns back"));
  }
  return MagneticSensor(std::move(pairs), noise, false);
}

Result<MagneticSensor> MagneticSensor::fromCsv(const std::string& file, double noise) {
  const Remedies remedies = Message("Give a CSV with the header displacement_mm,reading");
  Result<std::string> text = readTable(file, largestTable_bytes, remedies);
  if (!text) return text.failure();
  NumberTable table(*text);
  if (!table.next()) return unusable(file, "", Message("the file is empty"), remedies);
  const auto columns = table.columns({"displacement_mm", "reading"});
  if (!columns)
    return unusable(file, table.place(), Message("the file has no columns displacement_mm and reading"),
                    remedies);
  std::vector<SensorPair> pairs;
  while (table.next()) {
    const auto displacement_mm = table.finite((*columns)[0]), reading = table.finite((*columns)[1]);
    if (!displacement_mm || !reading)
      return unusable(file, table.place(), Message("this line does not hold two usable numbers"),
                      Message("Remove or correct the value"));
    pairs.push_back({*displacement_mm, *reading});
  }
  return fromPairs(std::move(pairs), noise, file);
}

MagneticSensor MagneticSensor::assumed(double travel_mm, double noise) {
  std::vector<SensorPair> pairs;
  for (int i = 0; i <= assumedPieces; ++i) {
    const double displacement_mm = travel_mm * i / assumedPieces;
    pairs.push_back(
        {displacement_mm,
         restReading + swingReading * fieldAt(gap_mm + travel_mm - displacement_mm) / fieldAt(gap_mm)});
  }
  return MagneticSensor(std::move(pairs), noise, true);
}

double MagneticSensor::reading(double displacement_mm) const {
  const std::size_t i =
      pieceOf(pairs_, [&](const SensorPair& p) { return p.displacement_mm < displacement_mm; });
  const SensorPair &a = pairs_[i], &b = pairs_[i + 1];
  return a.reading + (displacement_mm - a.displacement_mm) / (b.displacement_mm - a.displacement_mm) *
                         (b.reading - a.reading);
}

double MagneticSensor::displacement_mm(double reading) const {
  const bool rises = pairs_[1].reading > pairs_[0].reading;
  const std::size_t i =
      pieceOf(pairs_, [&](const SensorPair& p) { return rises ? p.reading < reading : p.reading > reading; });
  const SensorPair &a = pairs_[i], &b = pairs_[i + 1];
  return a.displacement_mm +
         (reading - a.reading) / (b.reading - a.reading) * (b.displacement_mm - a.displacement_mm);
}

}  // namespace detent::playback
