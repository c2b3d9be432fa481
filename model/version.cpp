// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/version.h"

namespace detent {

const char* version() { return DETENT_VERSION; }

}  // namespace detent
