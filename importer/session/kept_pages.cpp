// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/session/kept_pages.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace detent::importer {
namespace {

template <typename Value>
std::vector<Value> ofAllPages(const std::map<int, std::vector<Value>>& perPage) {
  std::vector<Value> all;
  for (const auto& onPage : perPage) all.insert(all.end(), onPage.second.begin(), onPage.second.end());
  return all;
}

}  // namespace

Message placeOf(int page) { return Message("page %1", page); }
Message placeOf(int page, int graph) { return Message("page %1, graph %2", page, graph); }

Remark unreadablePage(int page, const Failure& why) {
  return {RemarkCode::pageUnreadable, {page, why.problem}, why.remedies};
}

KeptPages::KeptPages(Document document, std::string fileName)
    : document_(std::move(document)), fileName_(std::move(fileName)) {}

std::string KeptPages::stem() const { return std::filesystem::path(fileName_).stem().string(); }

Failure KeptPages::failure(FailureCode code, Message place, Message problem, Remedies remedies) const {
  return {code, fileName_, std::move(place), std::move(problem), std::move(remedies)};
}

Message KeptPages::placeOfGraph(int page, int graph) const {
  return count() > 1 ? placeOf(page, graph) : Message("graph %1", graph);
}

Result<const Page*> KeptPages::page(int number, const Progress& progress) {
  constexpr std::size_t mostPages = 2;
  if (const auto kept = pages_.find(number); kept != pages_.end()) {
    kept->second.usedAt = ++clock_;
    return &kept->second.page;
  }
  if (number < 1 || number > count()) {
    return failure(FailureCode::wrongUsage, placeOf(number), Message("there is no such page"),
                   {{RemedyKind::choosePage, Message("1 to %1", count())}});
  }
  auto read = document_.page(number, progress);
  if (!read) {
    if (read.failure().code == FailureCode::unreadableInput)
      remarks_[number] = {unreadablePage(number, read.failure())};
    return read.failure();
  }
  remarks_[number] = read->remarks;
  specs_.insert_or_assign(number, readPrintedSpecs(*read));
  const auto used = [](const auto& a, const auto& b) { return a.second.usedAt < b.second.usedAt; };
  while (pages_.size() >= mostPages) pages_.erase(std::min_element(pages_.begin(), pages_.end(), used));
  return &pages_.emplace(number, KeptPage{std::move(read).value(), ++clock_}).first->second.page;
}

std::vector<Remark> KeptPages::remarksOn(int page) const {
  const auto found = remarks_.find(page);
  return found == remarks_.end() ? std::vector<Remark>() : found->second;
}

std::vector<Remark> KeptPages::remarks() const { return ofAllPages(remarks_); }

std::vector<PrintedSpec> KeptPages::printedSpecs() const { return ofAllPages(specs_); }

}  // namespace detent::importer
