// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/library/find_switches.h"

#include <algorithm>
#include <utility>

namespace detent::importer {

Result<FoundSwitches> findSwitches(const FindRequest& request) {
  const auto store = LibraryStore::openToRead(request.database);
  if (!store) return store.failure();
  auto switches = store->switches(request.ranges);
  if (!switches) return switches.failure();

  FoundSwitches result;
  result.fitting = switches->size();
  result.found.reserve(switches->size());
  for (LibrarySwitch& each : *switches) result.found.push_back({std::move(each), {}});
  if (request.like) {
    const FeelDistance distance(*request.like);
    for (FoundSwitch& each : result.found) each.distance_labNoise = distance.to(each.entry.shape);
    std::ranges::stable_sort(result.found, {}, &FoundSwitch::distance_labNoise);
  }
  if (result.found.size() > request.limit)
    result.found.erase(result.found.begin() + static_cast<std::ptrdiff_t>(request.limit), result.found.end());
  return result;
}

}  // namespace detent::importer
