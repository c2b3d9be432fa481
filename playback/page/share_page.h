// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Buttons as one web page that anyone can open and press: graph, figures, a pad, and the engine itself as
// WebAssembly.

#include <string>
#include <vector>

#include "model/button.h"

namespace detent::playback {

/// The page as HTML, complete in itself: no other file, no network. It renders
/// `detent-play render --standard-press` bit for bit (`window.detent.render(i)`), and its root element
/// carries data-detent="ready" once a pad can be pressed, else "failed". Names are text wherever they stand.
/// At most 9 buttons, one key each. Failure wrongUsage: none or more than 9 buttons, one that cannot be
/// prepared, a build without the browsers' engine (`hasPageEngine`). Any thread; allocates.
Result<std::string> sharePage(const std::vector<Button>& buttons);

/// Returns true if this build contains the engine for browsers; it needs clang 14 with wasi-libc and libc++
/// for wasm32 at build time.
bool hasPageEngine();

}  // namespace detent::playback
