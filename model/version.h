// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Which Detent this is. The number stands in the project() line of the top CMakeLists.txt and nowhere else.

namespace detent {

/// "0.2.0": what every program answers to --version. Any thread.
const char* version();

}  // namespace detent
