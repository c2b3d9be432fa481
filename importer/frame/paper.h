// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What ink is measured against.

namespace detent::importer {

enum class PaperBy {
  page,   ///< one paper: ink is what is darker than it, on dark paper what is lighter
  region  ///< papers beside each other, ink of either polarity: a white plot on a dark page, white words and black lines
          ///< on a coloured one
};

}  // namespace detent::importer
