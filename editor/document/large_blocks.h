// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Memory of pages that are no longer shown goes back to the system.

namespace detent::editor {

/// Called once, first thing in main. glibc raises the size from which blocks are mapped by themselves to that
/// of the largest block ever freed; after one page picture every next one lies in the heap, whose holes stay.
/// This keeps the size at 1 MB: the import dialogue's peak went from 421 to 339 MB
/// (docs/develop/decisions/1020-memory-of-imports.md). Elsewhere it does nothing.
void giveLargeBlocksBack();

}  // namespace detent::editor
