// SPDX-License-Identifier: GPL-3.0-or-later
// What the product makes of presses and timed presses, for press_ode_test.py: one JSON value per line in, one
// per line out.
//   {"button": {...}, "finger": {...}, "command": {...}, "close_m": x, "open_m": x} -> outcome of the press
//   {"window_s": x, "interval_s": x, "activation_sd_s": x, "aim": x, "spread": x}   -> {"error": x}
#include <iostream>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include "model/file/button_file.h"
#include "playback/performance/press_plant.h"
#include "playback/performance/timed_press.h"

namespace {

using namespace detent;
using namespace detent::playback;
using Json = nlohmann::json;

Finger fingerFrom(const Json& json) {
  Finger finger;
  finger.mass_kg = json.at("mass_kg");
  finger.pulp_N_per_m = json.at("pulp_N_per_m");
  finger.pulpDamping_Ns_per_m = json.at("pulp_damping_Ns_per_m");
  finger.muscleRise_s = json.at("muscle_rise_s");
  finger.muscleFall_s = json.at("muscle_fall_s");
  finger.extensorShare = json.at("extensor_share");
  return finger;
}

Json timeOrNull(const std::optional<double>& time_s) { return time_s ? Json(*time_s) : Json(nullptr); }

Json pressed(const Json& json) {
  const Result<Button> button = buttonFromJson(json.at("button").dump(), "the case's button");
  if (!button) throw std::runtime_error(button.failure().sentence());
  const Json& commandJson = json.at("command");
  const PressCommand command{commandJson.at("amplitude_N"), commandJson.at("duration_s"),
                             commandJson.at("lift_s")};
  const PressOutcome outcome =
      simulatePress(KeyTables(button->states().front()), ContactPoints{json.at("close_m"), json.at("open_m")},
                    fingerFrom(json.at("finger")), command);
  return {{"touch_s", timeOrNull(outcome.touch_s)},
          {"activation_s", timeOrNull(outcome.activation_s)},
          {"peak_N", outcome.peak_N},
          {"peak_s", outcome.peak_s},
          {"impulse_Ns", outcome.impulse_Ns},
          {"deepest_m", outcome.deepest_m},
          {"end_s", outcome.end_s},
          {"ended", outcome.ended},
          {"closings", outcome.closings}};
}

Json timed(const Json& json) {
  return {{"error", timedPressError(json.at("window_s"), json.at("interval_s"), json.at("activation_sd_s"),
                                    Timing{json.at("aim"), json.at("spread")})}};
}

}  // namespace

int main() try {
  for (std::string line; std::getline(std::cin, line);) {
    const Json json = Json::parse(line);
    std::cout << (json.contains("button") ? pressed(json) : timed(json)) << "\n";
  }
  return 0;
} catch (const std::exception& wrong) {
  std::cerr << "press_probe: " << wrong.what() << "\n";
  return 1;
}
