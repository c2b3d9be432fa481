// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Public header for exchange with others: a button as a web page, a press in the formats of other devices,
// and signals of other programs to compare with. Separate from playback/playback.h, so that programs that
// only play do not link these.

#include "playback/interchange/export_press.h"
#include "playback/interchange/reference_signal.h"
#include "playback/page/share_page.h"
