// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The pages of an open document: read on request, those used last are kept.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "importer/page/document.h"
#include "importer/specs/printed_spec.h"

namespace detent::importer {

Message placeOf(int page);
Message placeOf(int page, int graph);

/// The remark on a page that could not be read.
Remark unreadablePage(int page, const Failure& why);

/// An open document with its pages. Remarks and printed specs are kept of every page read so far. One thread
/// at a time.
class KeptPages {
 public:
  /// `fileName` is used in messages and as the button's name.
  KeptPages(Document document, std::string fileName);

  const Document& document() const { return document_; }
  int count() const { return document_.pageCount(); }
  const std::string& fileName() const { return fileName_; }
  std::string stem() const;  ///< of the file's name

  /// Place of a graph in messages; without the page if there is but one.
  Message placeOfGraph(int page, int graph) const;

  /// Valid until the next call. Failure wrongUsage: there is no such page.
  Result<const Page*> page(int number, const Progress& progress);

  /// Parts of a page that could not be read; empty if the page was not read yet.
  std::vector<Remark> remarksOn(int page) const;
  std::vector<Remark> remarks() const;
  std::vector<PrintedSpec> printedSpecs() const;

  Failure failure(FailureCode code, Message place, Message problem, Remedies remedies) const;
  Failure cancelled() const { return Failure::cancelled(fileName_); }

 private:
  struct KeptPage {
    Page page;
    std::uint64_t usedAt = 0;
  };

  Document document_;
  std::string fileName_;
  std::map<int, KeptPage> pages_;                  // those used last
  std::map<int, std::vector<PrintedSpec>> specs_;  // per page read so far
  std::map<int, std::vector<Remark>> remarks_;     // per page read so far
  std::uint64_t clock_ = 0;
};

}  // namespace detent::importer
