// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The files of playback/study/station, embedded in the program by playback/page/embed.cmake.

#include <string_view>

namespace detent::playback::station_parts {

extern const std::string_view html, words, style, worklet, script;
extern const std::string_view engine;  ///< WebAssembly; empty in a build without it

}  // namespace detent::playback::station_parts
