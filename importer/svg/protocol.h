// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The protocol of detent-svg-worker, for worker_client.cpp and worker_main.cpp.
//
//   detent-svg-worker PROCESSOR_SECONDS MEGABYTES OUTPUT_MEGABYTES FONTS
//
// Descriptor 0 holds the drawing, descriptor 1 takes the answer, and FONTS descriptors from `firstFont` on
// hold font files. The answer is lines of a key, a blank and a value; the line `pdfKey` is followed by the
// PDF. `scaleKey` says how many units of the PDF one CSS pixel is.

namespace detent::importer::svg {

inline constexpr int firstFont = 3;  // descriptor
inline constexpr const char* scaleKey = "scale";
inline constexpr const char* leftOutKey = "left-out";     // references outside the file, a count
inline constexpr const char* noFontKey = "without-font";  // letters that no font has, UTF-8
inline constexpr const char* truncatedKey = "truncated";  // the file ends too early
inline constexpr const char* problemKey = "problem";      // why the drawing is refused
inline constexpr const char* pdfKey = "pdf";

}  // namespace detent::importer::svg
