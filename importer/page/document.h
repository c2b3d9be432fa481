// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A file that holds pages: opened once, its pages and their regions read on demand.

#include <memory>
#include <string>
#include <vector>

#include "importer/page/page.h"
#include "importer/page/progress.h"
#include "model/result.h"

namespace detent::importer {

/// An open file. Pages are read on demand. One thread at a time.
class Document {
 public:
  /// Failure code unreadableInput: missing, empty, truncated, of another type than its name says, encrypted,
  /// or too large.
  static Result<Document> open(const std::string& path, const PageLimits& limits = {});
  /// The same from memory (pasted pictures, fuzzing); `name` is used in messages.
  static Result<Document> fromBytes(std::vector<unsigned char> bytes, const std::string& name,
                                    const PageLimits& limits = {});

  int pageCount() const;
  /// Page numbers count from 1.
  Result<Page> page(int number, const Progress& progress = {}) const;
  /// Region in page units. `quarterTurns`: clockwise turns by 90° that make the region upright (0..3).
  /// `levelToPage` (pictures only): maps a levelled sheet to the page; the region is then a box on that
  /// sheet, and the view's pixels are interpolated. For a photograph (a map that is not affine) uneven light
  /// is divided out.
  Result<PageView> view(const Page& page, const Box& region, int quarterTurns = 0,
                        const ViewOptions& options = {}, const Homography& levelToPage = {},
                        const Progress& progress = {}) const;

  const std::string& name() const;
  std::string sha256() const;

  Document(Document&&) noexcept;
  Document& operator=(Document&&) noexcept;
  ~Document();

 private:
  struct Impl;
  explicit Document(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace detent::importer
