// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/program/forced_end.h"

#include <chrono>
#include <cstdlib>
#include <utility>

#include "model/result.h"
#include "model/staged_file.h"

namespace detent::importer {
namespace {

void watch(const std::future<void>& over, const std::function<bool()>& cancelled,
           std::chrono::duration<double> grace) {
  constexpr std::chrono::milliseconds checkedEvery{50};
  while (!cancelled())
    if (over.wait_for(checkedEvery) == std::future_status::ready) return;
  if (over.wait_for(grace) == std::future_status::ready) return;
  StagedFile::removeAll();
  std::_Exit(static_cast<int>(FailureCode::cancelled));
}

}  // namespace

ForcedEnd::ForcedEnd(std::function<bool()> cancelled, double grace_s)
    : watch_([over = over_.get_future(), cancelled = std::move(cancelled), grace_s] {
        watch(over, cancelled, std::chrono::duration<double>(grace_s));
      }) {}

ForcedEnd::~ForcedEnd() {
  over_.set_value();
  watch_.join();
}

}  // namespace detent::importer
