// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/feel/press_signal.h"

#include <chrono>

#include "editor/document/begun_in.h"

namespace detent::editor {
namespace {

PressSignal failed(const Failure& failure) {
  PressSignal signal;
  signal.failure = failure;
  return signal;
}

PressSignal computed(const PressSignalRequest& request) {
  const Button button = begunIn(request.button, request.firstState);
  Result<playback::PreparedProgram> prepared =
      playback::prepareProgram(button, request.profile, request.settings);
  if (!prepared) return failed(prepared.failure());
  Result<playback::LiveProgram> live =
      playback::prepareLive(*prepared, button, request.profile, request.settings);
  if (!live) return failed(live.failure());
  PressSignal signal;
  signal.firstState = request.firstState < request.button.states().size() ? request.firstState : 0;
  signal.program = std::make_shared<const playback::LiveProgram>(*std::move(live));
  signal.standard = request.press == nullptr;
  signal.press = signal.standard ? playback::standardPress(prepared->program) : *request.press;
  const Result<playback::PressedButton> felt =
      playback::asPressed(button, *prepared, signal.press, request.profile, request.settings);
  if (!felt) return failed(felt.failure());
  signal.speed_mm_per_s = felt->speed_mm_per_s;
  signal.summary = felt->prepared.summary.line();
  for (const playback::PrepareWarning& w : felt->prepared.summary.warnings)
    signal.warnings.push_back(w.message);
  playback::RenderSettings settings;
  settings.sampleRate_Hz = drawnRate_Hz;
  Result<playback::RenderedPress> rendered =
      playback::renderPress(felt->prepared.program, signal.press, settings);
  if (!rendered) return failed(rendered.failure());
  signal.samples = std::move(rendered->samples);
  signal.peak = static_cast<double>(rendered->summary.peak);
  signal.events = std::move(rendered->summary.events);
  signal.spectrogram = playback::spectrogramOf(signal.samples, drawnRate_Hz);
  return signal;
}

}  // namespace

PressSignal pressSignalOf(const PressSignalRequest& request) {
  const auto began = std::chrono::steady_clock::now();
  PressSignal signal = computed(request);
  signal.computing_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return signal;
}

}  // namespace detent::editor
