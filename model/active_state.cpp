// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/active_state.h"

#include "model/sections.h"

namespace detent {
namespace {

double operatingPointOf(const ButtonState& state) {
  if (state.operatingPoint_mm) return *state.operatingPoint_mm;
  const auto points = tactilePoints(state.graph.press(), Stroke::press);
  return points.empty() ? bottomOutOf(state.graph.press()).displacement_mm : points.front().displacement_mm;
}

double resetPointOf(const ButtonState& state, double operating_mm) {
  if (state.resetPoint_mm) return *state.resetPoint_mm;
  const double releaseEnd_mm = state.graph.curve(Stroke::release).start_mm();
  return releaseEnd_mm < operating_mm ? releaseEnd_mm + 0.1 * (operating_mm - releaseEnd_mm) : releaseEnd_mm;
}

std::vector<ForceGraph> graphsOf(const Button& button) {
  std::vector<ForceGraph> graphs;
  for (const ButtonState& state : button.states()) graphs.push_back(state.graph);
  return graphs;
}

}  // namespace

ActiveState::ActiveState(const Button& button) {
  for (const ButtonState& state : button.states()) {
    const double operating_mm = operatingPointOf(state);
    states_.push_back({operating_mm, resetPointOf(state, operating_mm)});
  }
}

bool ActiveState::update(const TrackedPosition& position) {
  const Thresholds& active = states_[index_];
  if (position.stroke == Stroke::press) {
    if (!actuated_ && position.displacement_mm > active.operating_mm) {
      actuated_ = true;
      ++actuations_;
    }
    return false;
  }
  if (!actuated_ || position.displacement_mm > active.reset_mm) return false;
  actuated_ = false;
  if (states_.size() < 2) return false;
  index_ = (index_ + 1) % states_.size();
  return true;
}

ButtonTracker::ButtonTracker(const Button& button, TrackerSettings settings)
    : graphs_(graphsOf(button)), active_(button), tracker_(graphs_.front(), settings) {}

ButtonPosition ButtonTracker::update(double force_N) {
  ButtonPosition result;
  result.position = tracker_.update(force_N);
  if (result.position.stroke == Stroke::press) felt_ = active_.index();
  result.state = felt_;
  result.stateChanged = active_.update(result.position);
  if (result.stateChanged) tracker_.continueOn(graphs_[active_.index()]);
  return result;
}

}  // namespace detent
