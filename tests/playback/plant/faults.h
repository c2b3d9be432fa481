// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Faults between an encoder and the force law: each changes a sequence of correct readings.

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "playback/realtime/force_engine.h"
#include "tests/playback/plant/transport.h"

namespace detent::test {

enum class FaultKind : std::uint8_t {
  silent,     ///< no answer
  notFinite,  ///< NaN, now and then infinite
  stuck,      ///< the value of the first step, again and again
  jump,       ///< `size_mm` added from here on, for ever
  flicker,    ///< plus and minus `size_mm` in turns
  glitch,     ///< `size_mm` added while it lasts
  late        ///< every second answer is missing
};

/// A fault over steps `from` to before `to`.
struct Fault {
  FaultKind kind = FaultKind::silent;
  std::int64_t from = 0, to = 0;
  double size_mm = 0;
};

/// Puts faults into readings, step by step.
class FaultyEncoder {
 public:
  explicit FaultyEncoder(std::vector<Fault> faults = {}) : faults_(std::move(faults)) {}

  playback::ForceReading reading(std::int64_t step, double position_mm) {
    playback::ForceReading out;
    out.position_mm = position_mm;
    for (const Fault& fault : faults_) apply(fault, step, out);
    last_mm_ = out.position_mm;
    return out;
  }

 private:
  void apply(const Fault& fault, std::int64_t step, playback::ForceReading& out) {
    if (step < fault.from || (step >= fault.to && fault.kind != FaultKind::jump)) return;
    switch (fault.kind) {
      case FaultKind::silent:
        out.fresh = false;
        break;
      case FaultKind::notFinite:
        out.position_mm = step % 3 == 0 ? -std::numeric_limits<double>::infinity()
                                        : std::numeric_limits<double>::quiet_NaN();
        break;
      case FaultKind::stuck:
        if (step == fault.from) stuck_mm_ = out.position_mm;
        out.position_mm = stuck_mm_;
        break;
      case FaultKind::jump:
      case FaultKind::glitch:
        out.position_mm += fault.size_mm;
        break;
      case FaultKind::flicker:
        out.position_mm += step % 2 == 0 ? fault.size_mm : -fault.size_mm;
        break;
      case FaultKind::late:
        out.fresh = step % 2 == 0;
        break;
    }
  }

  std::vector<Fault> faults_;
  double last_mm_ = 0, stuck_mm_ = 0;
};

}  // namespace detent::test
