// SPDX-License-Identifier: GPL-3.0-or-later
// Any button shape, any readings, any blocks: the sound stays within full scale, positions within the travel.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

#include "playback/prepare/prepare_program.h"
#include "playback/realtime/haptic_engine.h"

using namespace detent;
using namespace detent::playback;

namespace {

void demand(bool condition) {
  if (!condition) std::abort();
}

/// Takes bytes from the input until it is used up, then zeros.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}
  unsigned next() {
    if (left_ == 0) return 0;
    --left_;
    return *data_++;
  }
  bool empty() const { return left_ == 0; }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

std::optional<StrokeCurve> curveFrom(Bytes& bytes) {
  std::vector<Knot> knots;
  double x = bytes.next() * 0.01;
  for (unsigned n = 2 + bytes.next() % 12; n > 0; --n) {
    const auto slope = [&] { return (static_cast<double>(bytes.next()) - 100) * 0.1; };
    knots.push_back({x, (static_cast<double>(bytes.next()) - 20) * 0.02, slope(), slope()});
    x += bytes.next() * 0.01;
  }
  Result<StrokeCurve> curve = StrokeCurve::fromKnots(knots);
  if (!curve) return {};
  return *curve;
}

std::optional<ButtonState> stateFrom(Bytes& bytes, const char* name) {
  const auto press = curveFrom(bytes);
  if (!press) return {};
  std::optional<StrokeCurve> release;
  if (bytes.next() % 2 == 1) release = curveFrom(bytes);
  Result<ForceGraph> graph = ForceGraph::fromCurves(*press, release);
  if (!graph) return {};
  return ButtonState{name, *graph, {}, {}, {}};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  std::vector<ButtonState> states;
  const unsigned count = 1 + bytes.next() % 2;
  for (unsigned i = 0; i < count; ++i) {
    const auto state = stateFrom(bytes, i == 0 ? "unlocked" : "locked");
    if (!state) return 0;
    states.push_back(*state);
  }
  const Result<Button> button = Button::fromStates("fuzz", states);
  if (!button) return 0;
  PlaybackSettings settings;
  settings.mode = static_cast<FeedbackMode>(bytes.next() % 4);
  settings.placement = static_cast<EventPlacement>(bytes.next() % 2);
  settings.grainsPerMm = bytes.next();
  const Result<PreparedProgram> prepared = prepareProgram(*button, {}, settings);
  if (!prepared) return 0;
  const auto program = std::make_unique<HapticProgram>(prepared->program);
  const auto engine = std::make_unique<HapticEngine>(8000);
  engine->use(program.get());
  std::vector<float> out(512);
  double time = 0;
  for (int i = 0; i < 400 && !bytes.empty(); ++i) {
    time += bytes.next() * 0.5;
    EngineInput input;
    const unsigned kind = bytes.next();
    input.kind = kind % 16 == 0  ? InputKind::resync
                 : kind % 4 == 1 ? InputKind::displacement
                                 : InputKind::force;
    input.time_frames = time;
    input.value = (static_cast<double>(bytes.next()) - 20) * 0.03;
    engine->push(input);
    const std::size_t n = 1 + bytes.next() * 2;
    engine->render(out.data(), n);
    for (std::size_t k = 0; k < n; ++k) demand(out[k] >= -1 && out[k] <= 1);
    const StrokePosition& at = engine->position();
    const StateProgram& state = program->states[at.state];
    demand(at.state < program->stateCount);
    demand(at.displacement_mm >= state.low_mm - 1e-9 && at.displacement_mm <= state.end_mm + 1e-9);
  }
  return 0;
}
