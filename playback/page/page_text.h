// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Text of a web page from a template and data. Any thread.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace detent::playback {

std::string base64(std::string_view bytes);
/// The numbers as little-endian doubles, in base64.
std::string base64(const std::vector<double>& numbers);

/// JSON escaped so that it cannot end its script element.
std::string insideScript(std::string_view json);
/// Text escaped so that it cannot begin an element.
std::string insideElement(std::string_view text);

/// The template with every @NAME@ replaced, in one pass: inserted text is not searched.
std::string filled(std::string_view html, const std::vector<std::pair<std::string_view, std::string>>& parts);

}  // namespace detent::playback
