// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/page/broken_images.h"

#include <array>
#include <cstddef>
#include <string>

#include <mupdf/pdf.h>

namespace detent::importer {
namespace {

constexpr std::size_t mostObjects = 4096;

/// The forms, patterns and images of a page, each visited once. MuPDF throws by longjmp, so everything here
/// is plain data; what throws does so inside guardedCall.
struct ObjectSearch {
  fz_context* context = nullptr;
  pdf_document* document = nullptr;
  std::array<int, mostObjects> seen{};
  std::size_t count = 0;
  int leftOut = 0;
};

bool firstVisit(ObjectSearch& search, pdf_obj* object) {
  const int number = pdf_to_num(search.context, object);
  if (number == 0) return true;  // a direct object cannot be reached twice or be part of a cycle
  for (std::size_t i = 0; i < search.count; ++i)
    if (search.seen[i] == number) return false;
  if (search.count == mostObjects) return false;
  search.seen[search.count++] = number;
  return true;
}

bool loads(ObjectSearch& search, pdf_obj* object) {
  std::string ignored;
  return guarded(search.context, ignored, [&] {
    fz_image* image = pdf_load_image(search.context, search.document, object);
    fz_drop_image(search.context, image);
  });
}

/// Marks an image so that MuPDF skips it: like every viewer it ignores objects of the kind PS (PostScript for
/// printers).
void leaveOut(ObjectSearch& search, pdf_obj* object) {
  std::string ignored;
  if (guarded(search.context, ignored, [&] {
        pdf_dict_put_drop(search.context, object, PDF_NAME(Subtype), pdf_new_name(search.context, "PS"));
      }))
    ++search.leftOut;
}

void visitResources(ObjectSearch& search, pdf_obj* resources, int depth);

void visit(ObjectSearch& search, pdf_obj* object, int depth) {
  if (!firstVisit(search, object)) return;
  fz_context* context = search.context;
  if (pdf_name_eq(context, pdf_dict_get(context, object, PDF_NAME(Subtype)), PDF_NAME(Image))) {
    if (!loads(search, object)) leaveOut(search, object);
    return;
  }
  visitResources(search, pdf_dict_get(context, object, PDF_NAME(Resources)), depth + 1);
}

void visitValues(ObjectSearch& search, pdf_obj* dictionary, int depth) {
  const int length = pdf_dict_len(search.context, dictionary);
  for (int i = 0; i < length; ++i) visit(search, pdf_dict_get_val(search.context, dictionary, i), depth);
}

void visitResources(ObjectSearch& search, pdf_obj* resources, int depth) {
  constexpr int deepest = 32;
  if (!resources || depth > deepest) return;
  visitValues(search, pdf_dict_get(search.context, resources, PDF_NAME(XObject)), depth);
  visitValues(search, pdf_dict_get(search.context, resources, PDF_NAME(Pattern)), depth);
}

}  // namespace

int leaveOutBrokenImages(fz_context* context, fz_page* page) {
  std::string ignored;
  ObjectSearch search;
  search.context = context;
  guarded(context, ignored, [&] {
    pdf_page* pdf = pdf_page_from_fz_page(context, page);
    if (!pdf) return;
    search.document = pdf->doc;
    visitResources(search, pdf_page_resources(context, pdf), 0);
  });
  return search.leftOut;
}

}  // namespace detent::importer
