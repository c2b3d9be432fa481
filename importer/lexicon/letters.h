// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Letters of labels: case, accents and scripts.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace detent::importer {

/// Small letters; Latin and Greek ones without their accents, which people and text engines leave out.
std::string folded(std::string_view utf8);

/// A text's letters as code points. A byte that is not well-formed UTF-8 becomes a code point of its own.
std::u32string codePoints(std::string_view utf8);

/// The UTF-8 of code points.
std::string utf8Of(std::u32string_view letters);

/// Words of a text as `folded` writes them, in order. All bytes above ASCII count as letters.
std::vector<std::string> wordsOf(std::string_view utf8);

/// Number of code points.
std::size_t letterCount(std::string_view utf8);

/// Returns true if a word is written in a script that sets no blanks between words or joins particles to
/// them: Chinese, Japanese, Korean, Thai, Arabic, Hebrew, Devanagari.
bool isWrittenTogether(std::string_view utf8);

/// Returns true if a text has a Cyrillic letter.
bool hasCyrillic(std::string_view utf8);

}  // namespace detent::importer
