// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Reference for a pixel's darkness: one colour of paper for the picture, or the colour around each pixel.

namespace detent::importer {

enum class PaperBy {
  page,   ///< one paper: darkness is contrast to it, darker or, on dark paper, lighter
  region  ///< several papers, contrast of either sign: a white plot on a dark page, white words and black
          ///< lines on a coloured one
};

}  // namespace detent::importer
