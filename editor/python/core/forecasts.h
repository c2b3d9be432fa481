// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Renderings and forecasts of detent-play, and the search of detent-import library, as functions. All throw
// Refusal; JSON as the programs print it. Any thread.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "editor/python/core/interruptible.h"
#include "model/button.h"

namespace detent::python {

/// Samples of a press as shares of full scale. `trace`: a press trace's file; empty: a human-like press.
/// `feel`: as --feel takes it.
std::vector<float> renderedPress(const Button& button, const std::string& traceFile, double rate_Hz,
                                 const std::string& feel, const Cancelled& cancelled);

/// A JSON array with one entry per pair; `a` and `b` are the buttons' indices, as text.
std::string confusionOf(const std::vector<Button>& buttons, const Cancelled& cancelled);

/// A JSON array with one entry per button.
std::string performanceOf(const std::vector<Button>& buttons, const std::optional<double>& operateAt_mm,
                          const Cancelled& cancelled);

/// The button at `share` of the way (empty: the perceptual middle), and a sentence that describes its
/// position.
std::pair<Button, std::string> buttonBetween(const Button& from, const Button& to,
                                             const std::optional<double>& share, const Cancelled& cancelled);

/// The output of `detent-import library find --like` for the button's first state.
std::string switchesLike(const Button& button, const std::string& database, std::size_t limit);

}  // namespace detent::python
