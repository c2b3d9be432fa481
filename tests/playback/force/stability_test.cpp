// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/prepare/stability.h"

#include <catch2/catch.hpp>

#include "tests/playback/force/sample_files.h"

namespace {

using namespace detent;
using namespace detent::playback;
using namespace detent::test;

}  // namespace

TEST_CASE("stability: a bottom-out breaks the margin where it stands, a soft spring does not") {
  const StabilityMargin steep = stabilityOf(sampleButton("A"), falconDevice(), 1000);
  REQUIRE_FALSE(steep.stable());
  CHECK(steep.unstable.back().from_mm > 3.9);
  CHECK_FALSE(steep.unstable.back().falling);
  CHECK(steep.least.bound == StabilityBound::device);
  CHECK(steep.least.allowed_N_per_mm == 2);
  const Button soft = buttonOf("soft", {stateOf("", {{0, 0}, {4, 1}}, {})});
  CHECK(stabilityOf(soft, falconDevice(), 1000).stable());
  CHECK(nearestStable(soft, falconDevice(), 1000)->changes.empty());
  CHECK(nearestStable(soft, falconDevice(), 1000)->button == soft);
}

TEST_CASE("stability: later forces and less damping bear less, whatever the law leads away") {
  ForceDeviceProfile device = falconDevice();
  device.largestSlope_N_per_mm = 500;
  device.friction_N = 1e6;
  const auto allowed = [&] { return stabilityOf(sampleButton("A"), device, 1000).least; };
  const MarginPoint quick = allowed();
  CHECK(quick.bound == StabilityBound::damping);
  device.delay_s += 0.002;
  const MarginPoint late = allowed();
  CHECK(late.allowed_N_per_mm < 0.5 * quick.allowed_N_per_mm);
  device.damping_Ns_per_mm *= 0.5;
  CHECK(allowed().allowed_N_per_mm < late.allowed_N_per_mm);
  device.damping_Ns_per_mm = 0;
  CHECK(allowed().allowed_N_per_mm < 0.1 * late.allowed_N_per_mm);
}

TEST_CASE("stability: friction and encoder steps bound it too") {
  ForceDeviceProfile device = falconDevice();
  device.friction_N = 0.001;
  const StabilityMargin margin = stabilityOf(sampleButton("B"), device, 1000);
  CHECK(margin.least.bound == StabilityBound::quantisation);
  CHECK(margin.least.allowed_N_per_mm == Approx(1.4 * 0.001 / 0.038));
  device.friction_N = 0;
  CHECK_FALSE(nearestStable(sampleButton("B"), device, 1000));
}

TEST_CASE("stability: the nearest stable button is stable and says what was changed") {
  for (const std::string& name : sampleNames()) {
    for (const ForceDeviceProfile& device : {simulatedDevice(), falconDevice(), voiceCoilRig()}) {
      const Button button = sampleButton(name);
      const Result<StableButton> stable = nearestStable(button, device, 1000);
      INFO(name << " on " << device.name);
      REQUIRE(stable);
      const StabilityMargin after = stabilityOf(stable->button, device, 1000);
      CHECK(after.least.margin_N_per_mm() >= -0.02 * after.least.allowed_N_per_mm);
      CHECK(stable->changes.empty() == stabilityOf(button, device, 1000).stable());
      CHECK(stable->button.states().front().graph.travel_mm() == button.states().front().graph.travel_mm());
    }
  }
}
