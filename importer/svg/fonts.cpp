// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/svg/fonts.h"

#include <string>

#include <fcntl.h>
#include <fontconfig/fontconfig.h>
#include <sys/mman.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <unistd.h>

namespace detent::importer::svg {
namespace {

constexpr const char* folder = "/usr/share/fonts/truetype/liberation/";  // Debian's fonts-liberation

/// Font names that chart programs write, mapped to the font with the same widths.
constexpr const char* aliases = R"(<?xml version="1.0"?><fontconfig>
<alias binding="same"><family>sans-serif</family><prefer><family>Liberation Sans</family></prefer></alias>
<alias binding="same"><family>serif</family><prefer><family>Liberation Serif</family></prefer></alias>
<alias binding="same"><family>monospace</family><prefer><family>Liberation Mono</family></prefer></alias>
<alias binding="same"><family>Times</family><accept><family>serif</family></accept></alias>
<alias binding="same"><family>Times New Roman</family><accept><family>serif</family></accept></alias>
<alias binding="same"><family>DejaVu Serif</family><accept><family>serif</family></accept></alias>
<alias binding="same"><family>Georgia</family><accept><family>serif</family></accept></alias>
<alias binding="same"><family>Courier</family><accept><family>monospace</family></accept></alias>
<alias binding="same"><family>Courier New</family><accept><family>monospace</family></accept></alias>
<alias binding="same"><family>Consolas</family><accept><family>monospace</family></accept></alias>
<alias binding="same"><family>Menlo</family><accept><family>monospace</family></accept></alias>
<alias binding="same"><family>DejaVu Sans Mono</family><accept><family>monospace</family></accept></alias>
<match target="pattern">
<test qual="all" name="family" compare="not_eq"><string>Liberation Sans</string></test>
<test qual="all" name="family" compare="not_eq"><string>Liberation Serif</string></test>
<test qual="all" name="family" compare="not_eq"><string>Liberation Mono</string></test>
<edit name="family" mode="append_last"><string>Liberation Sans</string></edit></match>
</fontconfig>)";

/// Descriptor of a copy of the file in memory; -1 if it does not exist.
int copyInMemory(const std::string& path) {
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return -1;
  struct stat status {};
  const int copy = fstat(file, &status) == 0 ? memfd_create("font", MFD_CLOEXEC) : -1;
  off_t at = 0;
  while (copy >= 0 && at < status.st_size &&
         sendfile(copy, file, &at, static_cast<std::size_t>(status.st_size - at)) > 0) {
  }
  close(file);
  return copy;
}

}  // namespace

std::vector<int> liberationFonts(std::string_view drawing) {
  const auto mentions = [&](std::string_view word) { return drawing.find(word) != std::string_view::npos; };
  const bool isUtf16 = drawing.find('\0') != std::string_view::npos;
  if (!mentions("text") && !isUtf16) return {};
  std::vector<std::string> wanted{"Sans"};
  if (mentions("erif") || mentions("imes") || mentions("eorgia")) wanted.emplace_back("Serif");
  if (mentions("ono") || mentions("ourier") || mentions("onsolas") || mentions("enlo"))
    wanted.emplace_back("Mono");
  std::vector<int> descriptors;
  for (const std::string& family : wanted)
    for (const char* const style : {"Regular", "Bold", "Italic", "BoldItalic"}) {
      const std::string path = std::string(folder) + "Liberation" + family + "-" + style + ".ttf";
      if (const int copy = copyInMemory(path); copy >= 0) descriptors.push_back(copy);
    }
  return descriptors;
}

bool useFonts(const std::vector<int>& descriptors) {
  FcConfig* const config = FcConfigCreate();
  if (config == nullptr ||
      !FcConfigParseAndLoadFromMemory(config, reinterpret_cast<const FcChar8*>(aliases), FcTrue))
    return false;
  for (const int descriptor : descriptors) {
    const std::string path = "/proc/self/fd/" + std::to_string(descriptor);
    if (!FcConfigAppFontAddFile(config, reinterpret_cast<const FcChar8*>(path.c_str()))) return false;
  }
  return FcConfigSetCurrent(config) == FcTrue;
}

bool fontsHave(char32_t letter) {
  const FcFontSet* const fonts = FcConfigGetFonts(nullptr, FcSetApplication);
  for (int i = 0; fonts != nullptr && i < fonts->nfont; ++i) {
    FcCharSet* letters = nullptr;
    if (FcPatternGetCharSet(fonts->fonts[i], FC_CHARSET, 0, &letters) == FcResultMatch &&
        FcCharSetHasChar(letters, static_cast<FcChar32>(letter)))
      return true;
  }
  return false;
}

}  // namespace detent::importer::svg
