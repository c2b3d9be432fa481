// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Time that the steps of an import take.

#include <chrono>
#include <map>

#include "importer/page/findings.h"

namespace detent::importer {

/// Per step that ran since the present import began.
using StepSeconds = std::map<ImportStep, double>;

/// Adds the time of a scope to a step's sum.
class StepClock {
 public:
  StepClock(StepSeconds& seconds, ImportStep step)
      : seconds_(seconds), step_(step), start_(std::chrono::steady_clock::now()) {}
  ~StepClock() {
    seconds_[step_] += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  StepClock(const StepClock&) = delete;
  StepClock& operator=(const StepClock&) = delete;

 private:
  StepSeconds& seconds_;
  ImportStep step_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace detent::importer
