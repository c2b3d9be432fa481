// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The files of playback/page, embedded in the program by embed.cmake.

#include <string_view>

namespace detent::playback::page_parts {

extern const std::string_view html, style, engineScript, worklet, script;
extern const std::string_view engine;  ///< WebAssembly; empty in a build without it

}  // namespace detent::playback::page_parts
