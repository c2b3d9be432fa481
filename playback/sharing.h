// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Front door of what a button is handed on as: a page anyone can press, and a press in the formats of other
// devices; and of what others hand on in those: signals to compare with. Apart from playback/playback.h, so
// that who only plays carries neither.

#include "playback/interchange/export_press.h"
#include "playback/interchange/reference_signal.h"
#include "playback/page/share_page.h"
