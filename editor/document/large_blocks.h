// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Returns the memory of hidden pages to the system.

namespace detent::editor {

/// Call once, first in main. glibc raises the size from which blocks are mapped separately to that of the
/// largest block ever freed; after one page picture all later ones lie in the heap, whose holes remain. This
/// fixes the size at 1 MB: the import dialogue's peak fell from 421 to 339 MB
/// (docs/develop/decisions/1020-memory-of-imports.md). No effect without glibc.
void giveLargeBlocksBack();

}  // namespace detent::editor
