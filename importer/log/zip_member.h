// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One file out of a ZIP archive, as spreadsheets are kept in.

#include <cstddef>
#include <string>
#include <string_view>

#include "model/result.h"

namespace detent::importer {

/// The content of `member` in the archive `bytes`, stored or deflated. Failure unreadableInput about `subject`: no ZIP archive, no
/// such member, damaged, encrypted, or more than `most_bytes` when unpacked (whatever the archive claims). Any thread.
Result<std::string> zipMember(std::string_view bytes, std::string_view member, std::size_t most_bytes,
                              const std::string& subject);

}  // namespace detent::importer
