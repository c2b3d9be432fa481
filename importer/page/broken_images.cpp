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
struct Walk {
  fz_context* context = nullptr;
  pdf_document* document = nullptr;
  std::array<int, mostObjects> seen{};
  std::size_t count = 0;
  int leftOut = 0;
};

bool firstVisit(Walk& walk, pdf_obj* object) {
  const int number = pdf_to_num(walk.context, object);
  if (number == 0) return true;  // a direct object cannot be reached twice, nor lie in a circle
  for (std::size_t i = 0; i < walk.count; ++i)
    if (walk.seen[i] == number) return false;
  if (walk.count == mostObjects) return false;
  walk.seen[walk.count++] = number;
  return true;
}

bool loads(Walk& walk, pdf_obj* object) {
  std::string ignored;
  return guarded(walk.context, ignored, [&] {
    fz_image* image = pdf_load_image(walk.context, walk.document, object);
    fz_drop_image(walk.context, image);
  });
}

/// MuPDF passes over objects of the kind PS (PostScript for printers), as every viewer does.
void leaveOut(Walk& walk, pdf_obj* object) {
  std::string ignored;
  if (guarded(walk.context, ignored, [&] {
        pdf_dict_put_drop(walk.context, object, PDF_NAME(Subtype), pdf_new_name(walk.context, "PS"));
      }))
    ++walk.leftOut;
}

void visitResources(Walk& walk, pdf_obj* resources, int depth);

void visit(Walk& walk, pdf_obj* object, int depth) {
  if (!firstVisit(walk, object)) return;
  fz_context* context = walk.context;
  if (pdf_name_eq(context, pdf_dict_get(context, object, PDF_NAME(Subtype)), PDF_NAME(Image))) {
    if (!loads(walk, object)) leaveOut(walk, object);
    return;
  }
  visitResources(walk, pdf_dict_get(context, object, PDF_NAME(Resources)), depth + 1);
}

void visitValues(Walk& walk, pdf_obj* dictionary, int depth) {
  const int length = pdf_dict_len(walk.context, dictionary);
  for (int i = 0; i < length; ++i) visit(walk, pdf_dict_get_val(walk.context, dictionary, i), depth);
}

void visitResources(Walk& walk, pdf_obj* resources, int depth) {
  constexpr int deepest = 32;
  if (!resources || depth > deepest) return;
  visitValues(walk, pdf_dict_get(walk.context, resources, PDF_NAME(XObject)), depth);
  visitValues(walk, pdf_dict_get(walk.context, resources, PDF_NAME(Pattern)), depth);
}

}  // namespace

int leaveOutBrokenImages(fz_context* context, fz_page* page) {
  std::string ignored;
  Walk walk;
  walk.context = context;
  guarded(context, ignored, [&] {
    pdf_page* pdf = pdf_page_from_fz_page(context, page);
    if (!pdf) return;
    walk.document = pdf->doc;
    visitResources(walk, pdf_page_resources(context, pdf), 0);
  });
  return walk.leftOut;
}

}  // namespace detent::importer
