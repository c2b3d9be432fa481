// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/library/find_switches.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

#include "importer/library/wanted_button.h"
#include "model/text.h"

namespace detent::importer {
namespace {

/// A row with its distance, and its position in the order.
struct Ranked {
  SwitchId id = 0;
  double by = 0;
};

/// The `limit` rows with the smallest distance, and any further ones with the same distance as the last of
/// them.
std::vector<Ranked> nearestOf(std::vector<Ranked> all, std::size_t limit) {
  if (all.size() <= limit) return all;
  if (limit == 0) return {};
  const auto last = all.begin() + static_cast<std::ptrdiff_t>(limit - 1);
  std::ranges::nth_element(all, last, {}, &Ranked::by);
  std::erase_if(all, [most = last->by](const Ranked& each) { return each.by > most; });
  return all;
}

/// The nearest `limit` > 0 switches, all that are as far as the last of these, and some that are farther.
/// Starts from the most similar travel, so that most curves need not be read.
Result<std::vector<Ranked>> rankedByFeel(const LibraryStore& store, const FeelDistance& distance,
                                         const std::vector<std::pair<SwitchId, double>>& travels_mm,
                                         std::size_t limit) {
  std::vector<Ranked> atLeast;
  for (const auto& [id, travel_mm] : travels_mm) atLeast.push_back({id, distance.leastTo(travel_mm)});
  std::ranges::sort(atLeast, {}, &Ranked::by);
  std::vector<SwitchId> ids;
  for (const Ranked& each : atLeast) ids.push_back(each.id);
  std::vector<Ranked> ranked;
  std::priority_queue<double> nearest;  // at most `limit` distances, the largest on top
  const auto atMost = [&] {
    return nearest.size() < limit ? std::numeric_limits<double>::infinity() : nearest.top();
  };
  std::size_t seen = 0;
  const auto done = store.shapesOf(ids, [&](SwitchId id, const FeltShape& shape) {
    const double by = distance.to(shape, atMost());
    if (by <= atMost()) {
      ranked.push_back({id, by});
      nearest.push(by);
      if (nearest.size() > limit) nearest.pop();
    }
    ++seen;
    return seen < atLeast.size() && atLeast[seen].by <= atMost();
  });
  if (!done) return done.failure();
  return ranked;
}

/// The rows of these ids: by distance, then by name.
Result<std::vector<std::pair<LibrarySwitch, double>>> distanceRows(const LibraryStore& store,
                                                                   std::vector<Ranked> ranked,
                                                                   std::size_t limit) {
  ranked = nearestOf(std::move(ranked), limit);
  std::vector<SwitchId> ids;
  for (const Ranked& each : ranked) ids.push_back(each.id);
  auto switches = store.switchesOf(ids);
  if (!switches) return switches.failure();
  std::vector<std::pair<LibrarySwitch, double>> rows;
  for (std::size_t i = 0; i < ranked.size(); ++i) rows.emplace_back(std::move((*switches)[i]), ranked[i].by);
  std::ranges::sort(rows, [](const auto& a, const auto& b) {
    return a.second != b.second ? a.second < b.second : byName(a.first, b.first);
  });
  rows.resize(std::min(rows.size(), limit));
  return rows;
}

/// Ids of the switches with the requested name and kind, ascending; empty if none were requested, which means
/// all.
using Wanted = std::optional<std::vector<SwitchId>>;

Result<Wanted> wantedIn(const LibraryStore& store, const FindRequest& request) {
  if (request.name.empty() && !request.kind) return Wanted{};
  const auto names = store.names();
  if (!names) return names.failure();
  const std::string part = lowered(request.name);
  std::vector<SwitchId> ids;
  for (const auto& [id, name] : *names)
    if (lowered(name).find(part) != std::string::npos) ids.push_back(id);
  std::ranges::sort(ids);
  if (!request.kind) return Wanted(std::move(ids));
  const auto figures = store.figures();
  if (!figures) return figures.failure();
  std::vector<SwitchId> ofKind;
  for (const auto& [id, each] : *figures)
    if (kindOf(each) == *request.kind && std::ranges::binary_search(ids, id)) ofKind.push_back(id);
  std::ranges::sort(ofKind);
  return Wanted(std::move(ofKind));
}

bool holds(const Wanted& wanted, SwitchId id) { return !wanted || std::ranges::binary_search(*wanted, id); }

Result<std::vector<NearMiss>> nearestTo(const LibraryStore& store, const FindRequest& request,
                                        const Wanted& wanted) {
  const auto all = store.figures();
  if (!all) return all.failure();
  std::vector<Ranked> ranked;
  for (const auto& [id, figures] : *all)
    if (const auto miss = missOf(figures, request.ranges); miss && holds(wanted, id))
      ranked.push_back({id, *miss});
  auto rows = distanceRows(store, std::move(ranked), request.limit);
  if (!rows) return rows.failure();
  std::vector<NearMiss> nearest;
  for (auto& [entry, miss] : *rows) nearest.push_back({std::move(entry), miss});
  return nearest;
}

/// Switches within the ranges: nearest first if there is a reference, else by name. `fitting`: their number.
Result<std::vector<FoundSwitch>> foundIn(const LibraryStore& store, const FindRequest& request,
                                         const Wanted& wanted, std::size_t& fitting) {
  std::vector<Ranked> ranked;
  if (request.like) {
    auto travels_mm = store.travels_mm(request.ranges);
    if (!travels_mm) return travels_mm.failure();
    std::erase_if(*travels_mm, [&](const auto& each) { return !holds(wanted, each.first); });
    fitting = travels_mm->size();
    if (request.limit == 0) return std::vector<FoundSwitch>{};
    auto nearest = rankedByFeel(store, FeelDistance(*request.like), *travels_mm, request.limit);
    if (!nearest) return nearest.failure();
    ranked = std::move(*nearest);
  } else {
    const auto ids = store.idsByName(request.ranges);
    if (!ids) return ids.failure();
    for (const SwitchId id : *ids)
      if (holds(wanted, id)) ranked.push_back({id, double(ranked.size())});
    fitting = ranked.size();
  }
  auto rows = distanceRows(store, std::move(ranked), request.limit);
  if (!rows) return rows.failure();
  std::vector<FoundSwitch> found;
  for (auto& [entry, by] : *rows)
    found.push_back({std::move(entry), request.like ? std::optional(by) : std::nullopt, {}});
  return found;
}

}  // namespace

Result<FoundSwitches> findSwitches(const FindRequest& request) {
  const auto store = LibraryStore::openToRead(request.database);
  if (!store) return store.failure();
  FoundSwitches result;
  const auto wanted = wantedIn(*store, request);
  if (!wanted) return wanted.failure();
  auto found = foundIn(*store, request, *wanted, result.fitting);
  if (!found) return found.failure();
  result.found = std::move(*found);
  const auto ratings = store->ratings();
  if (!ratings) return ratings.failure();
  const RatingsByName rated(*ratings);
  for (FoundSwitch& each : result.found) {
    each.ratings = rated.of(each.entry.name);
    const auto records = store->records(each.entry.name, each.entry.credit);
    if (!records) return records.failure();
    each.spread = spreadOf(*records);
  }
  if (result.fitting == 0 && !request.ranges.empty()) {
    auto nearest = nearestTo(*store, request, *wanted);
    if (!nearest) return nearest.failure();
    result.nearest = std::move(*nearest);
  }
  return result;
}

}  // namespace detent::importer
