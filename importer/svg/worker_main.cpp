// SPDX-License-Identifier: GPL-3.0-or-later
// detent-svg-worker: draws one SVG file as a PDF page. The importer starts it as a separate process, because
// librsvg cannot be interrupted and drawings may be hostile; protocol.h describes input and output.

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <unistd.h>

#include "importer/svg/draw_pdf.h"
#include "importer/svg/drawing.h"
#include "importer/svg/fonts.h"
#include "importer/svg/protocol.h"
#include "importer/svg/worker_limits.h"

namespace detent::importer::svg {
namespace {

std::string readAll(int descriptor) {
  std::string all;
  char part[65536];
  for (ssize_t n = 0; (n = read(descriptor, part, sizeof part)) > 0;)
    all.append(part, static_cast<std::size_t>(n));
  return all;
}

bool writeAll(int descriptor, const std::string& text) {
  for (std::size_t written = 0; written < text.size();) {
    const ssize_t n = write(descriptor, text.data() + written, text.size() - written);
    if (n <= 0) return false;
    written += static_cast<std::size_t>(n);
  }
  return true;
}

std::string line(const char* key, std::string value) {
  for (char& c : value)
    if (c == '\n' || c == '\r') c = ' ';
  return std::string(key) + " " + value + "\n";
}

std::string answerTo(const std::string& bytes) {
  const Drawing drawing = readDrawing(bytes, fontsHave);
  if (drawing.truncated) return line(truncatedKey, "");
  if (!drawing.problem.empty()) return line(problemKey, drawing.problem);
  if (!drawing.undrawn.empty())
    return line(problemKey, "it uses " + drawing.undrawn + ", which only browsers draw");
  const DrawnPdf drawn = drawPdf(drawing.xml, drawing.rasters);
  if (!drawn.problem.empty()) return line(problemKey, drawn.problem);
  std::string answer = line(scaleKey, std::to_string(drawn.scale));
  if (drawing.leftOut > 0) answer += line(leftOutKey, std::to_string(drawing.leftOut));
  if (!drawing.withoutFont.empty()) answer += line(noFontKey, drawing.withoutFont);
  return answer + line(pdfKey, "") + drawn.pdf;
}

int run(int argc, char** argv) {
  constexpr int arguments = 5;
  if (argc != arguments) {
    std::fprintf(stderr, "detent-svg-worker draws SVG files for detent-import, which starts it by itself.\n");
    return 2;
  }
  const auto number = [&](int i) { return std::atoi(argv[i]); };
  limitResources({number(1), number(2), number(3)});
  const std::string bytes = readAll(STDIN_FILENO);
  std::vector<int> fonts = liberationFonts(bytes);
  for (int i = 0; i < number(4); ++i) fonts.push_back(firstFont + i);
  closeTheWorld();
  if (!useFonts(fonts)) return 3;
  return writeAll(STDOUT_FILENO, answerTo(bytes)) ? 0 : 4;
}

}  // namespace
}  // namespace detent::importer::svg

/// Exits without destructors, because the system frees the libraries' memory.
int main(int argc, char** argv) { std::_Exit(detent::importer::svg::run(argc, argv)); }
