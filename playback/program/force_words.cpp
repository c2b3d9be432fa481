// SPDX-License-Identifier: GPL-3.0-or-later
#include "playback/program/force_words.h"

#include <cmath>
#include <cstdio>

namespace detent::playback {

namespace {

template <class... Values>
std::string worded(const char* format, Values... values) {
  char text[240];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

}  // namespace

std::string sentenceOf(const ForceRemark& r, const Button& button) {
  std::string where =
      button.selfLocking() ? "state " + stateName(button, static_cast<std::uint32_t>(r.state)) + ": " : "";
  switch (r.kind) {
    case ForceRemarkKind::bottomOutSoftened:
      return where +
             worded("a rise at %.2f mm: %.3g N/mm is steeper than the device renders; %.3g N/mm is felt",
                    r.at_mm, r.value, r.limit);
    case ForceRemarkKind::fallSoftened:
      return where +
             worded(
                 "the force falls by %.3g N/mm at %.2f mm, faster than the device renders; %.3g N/mm is felt",
                 r.value, r.at_mm, r.limit);
    case ForceRemarkKind::forceClipped:
      return where + worded("%.3g N is more than the device gives; %.3g N is felt", r.value, r.limit);
    case ForceRemarkKind::strokesCross:
      return where + worded(
                         "the release lies up to %.3g N above the press at %.2f mm, which would make energy; "
                         "both are felt "
                         "as the release there",
                         r.value, r.at_mm);
    case ForceRemarkKind::dampingLimited:
      return where +
             worded("damping of %.3g N·s/mm at %.2f mm is more than the device renders; %.3g N·s/mm is felt",
                    r.value, r.at_mm, r.limit);
    case ForceRemarkKind::speedsCross:
      return where +
             worded(
                 "a release lies up to %.3g N above the press of another speed at %.2f mm, which would make "
                 "energy; the press is felt as that release there",
                 r.value, r.at_mm);
    case ForceRemarkKind::speedLimited:
      return where + worded("the force %s with speed by %.2g N·s/mm at %.2f mm; %.2g N·s/mm is felt",
                            r.value > 0 ? "damps" : "drives", std::abs(r.value), r.at_mm, std::abs(r.limit));
    case ForceRemarkKind::wideReturn:
      return where + worded(
                         "from press to release would take %.3g mm on this device; it is cut to %.3g mm and "
                         "may be unsteady",
                         2 * r.value, 2 * r.limit);
  }
  return where;
}

std::string codeOf(ForceRemarkKind kind) {
  switch (kind) {
    case ForceRemarkKind::bottomOutSoftened:
      return "wall_softened";
    case ForceRemarkKind::fallSoftened:
      return "fall_softened";
    case ForceRemarkKind::forceClipped:
      return "force_clipped";
    case ForceRemarkKind::strokesCross:
      return "strokes_cross";
    case ForceRemarkKind::dampingLimited:
      return "damping_limited";
    case ForceRemarkKind::speedsCross:
      return "speeds_cross";
    case ForceRemarkKind::speedLimited:
      return "speed_limited";
    case ForceRemarkKind::wideReturn:
      return "wide_return";
  }
  return "";
}

std::string sentenceOf(const UnstableStretch& u, const Button& button) {
  const char* bears = u.worst.bound == StabilityBound::damping ? "its damping bears"
                      : u.worst.bound == StabilityBound::quantisation
                          ? "its friction bears with its encoder steps"
                          : "it may be asked for";
  const std::string where =
      button.selfLocking() ? "state " + stateName(button, static_cast<std::uint32_t>(u.state)) + ": " : "";
  return where +
         worded("the %s from %.2f to %.2f mm has %.3g N/mm, the device allows %.3g N/mm: more than %s",
                u.falling ? "falling jump" : "rise", u.from_mm, u.to_mm, u.worst.slope_N_per_mm,
                u.worst.allowed_N_per_mm, bears);
}

std::string codeOf(ForceHalt halt) {
  switch (halt) {
    case ForceHalt::stopped:
      return "emergency_stop";
    case ForceHalt::displaced:
      return "place_lost";
    case ForceHalt::notHeld:
      return "not_held";
    case ForceHalt::reversed:
      return "reversed_polarity";
    case ForceHalt::unmoved:
      return "handle_not_moving";
    case ForceHalt::deadCount:
      return "encoder_dead";
    case ForceHalt::runaway:
      return "runaway";
    case ForceHalt::dropOuts:
      return "repeated_drop_outs";
    case ForceHalt::none:
      break;
  }
  return "none";
}

std::string sentenceOf(ForceHalt halt) {
  switch (halt) {
    case ForceHalt::none:
    case ForceHalt::stopped:
    case ForceHalt::notHeld:
      break;
    case ForceHalt::displaced:
      return "place lost: the position jumped, the device was away or reset, or this program paused and the "
             "handle is beyond the travel. Let the handle rest at 0, then press a";
    case ForceHalt::reversed:
      return "reversed polarity: the handle moves against the force. Swap the motor's two wires or the "
             "encoder's A and B (of an ODrive: calibrate motor and encoder anew)";
    case ForceHalt::unmoved:
      return "the handle does not follow a small push. Let go of it and see that it moves freely; turn it by "
             "hand: a position that "
             "stays the same means a dead encoder. Then press a";
    case ForceHalt::deadCount:
      return "encoder dead, place lost: it did not count one step under force. Check the encoder and its "
             "wires, let the handle rest "
             "at 0, then press a";
    case ForceHalt::runaway:
      return "runaway: the handle ran on against the whole force. It was pressed harder than --max-N, or "
             "motor or encoder are "
             "reversed (reversed polarity). Let go, then press a";
    case ForceHalt::dropOuts:
      return "repeated drop-outs: the readings failed again and again, and the force came and went. Check "
             "the cable and what else runs on this computer, then press a";
  }
  return {};
}

std::string codeOf(StabilityBound bound) {
  switch (bound) {
    case StabilityBound::damping:
      return "damping";
    case StabilityBound::quantisation:
      return "quantisation";
    case StabilityBound::device:
      return "device";
  }
  return "";
}

std::string stateName(const Button& button, std::uint32_t state) {
  const std::string& name = button.states()[state % button.states().size()].name;
  return name.empty() ? "momentary" : name;
}

}  // namespace detent::playback
