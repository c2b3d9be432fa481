// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Front door of how people will press a button: a forecast by simulated fingers
// (docs/reference/press-forecast.md). Apart from playback/playback.h, so that who only plays carries no
// fingers.

#include "playback/performance/forecast.h"
