// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Public header for keys of magnetic keyboards: their settings, what they do along a movement, and tables for
// their firmware. Separate from playback/sharing.h, so that other exports do not compile with these.

#include "playback/magnetic/magnetic_key.h"
#include "playback/magnetic/magnetic_sensor.h"
#include "playback/magnetic/write_key_tables.h"
