// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/library/find_switches.h"

#include <algorithm>
#include <utility>

#include "importer/library/wanted_button.h"

namespace detent::importer {
namespace {

Result<std::vector<NearMiss>> nearestTo(const LibraryStore& store, const FindRequest& request) {
  auto switches = store.switches();
  if (!switches) return switches.failure();
  std::vector<NearMiss> nearest;
  for (LibrarySwitch& each : *switches)
    if (const auto miss = missOf(each.figures, request.ranges)) nearest.push_back({std::move(each), *miss});
  std::ranges::stable_sort(nearest, {}, &NearMiss::miss_labNoise);
  if (nearest.size() > request.limit)
    nearest.erase(nearest.begin() + static_cast<std::ptrdiff_t>(request.limit), nearest.end());
  return nearest;
}

}  // namespace

Result<FoundSwitches> findSwitches(const FindRequest& request) {
  const auto store = LibraryStore::openToRead(request.database);
  if (!store) return store.failure();
  auto switches = store->switches(request.ranges);
  if (!switches) return switches.failure();

  FoundSwitches result;
  result.fitting = switches->size();
  result.found.reserve(switches->size());
  for (LibrarySwitch& each : *switches) result.found.push_back({std::move(each), {}, {}});
  if (request.like) {
    const FeelDistance distance(*request.like);
    for (FoundSwitch& each : result.found) each.distance_labNoise = distance.to(each.entry.shape);
    std::ranges::stable_sort(result.found, {}, &FoundSwitch::distance_labNoise);
  }
  if (result.found.size() > request.limit)
    result.found.erase(result.found.begin() + static_cast<std::ptrdiff_t>(request.limit), result.found.end());
  for (FoundSwitch& each : result.found) {
    const auto records = store->records(each.entry.name, each.entry.credit);
    if (!records) return records.failure();
    each.spread = spreadOf(*records);
  }
  if (result.fitting == 0 && !request.ranges.empty()) {
    auto nearest = nearestTo(*store, request);
    if (!nearest) return nearest.failure();
    result.nearest = std::move(*nearest);
  }
  return result;
}

}  // namespace detent::importer
