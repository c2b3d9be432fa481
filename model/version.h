// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Version of Detent. Defined in the project() line of the top CMakeLists.txt.

namespace detent {

/// "0.3.0": output of --version. Any thread.
const char* version();

}  // namespace detent
