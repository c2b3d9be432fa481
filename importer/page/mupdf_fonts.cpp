// SPDX-License-Identifier: GPL-3.0-or-later
// Selects the fonts of MuPDF's library that the programs contain. The functions at the end replace MuPDF's
// own (mupdf/fitz/font.h): the linker takes these and leaves out the library's, with its 40 MB of fonts for
// every script ever written. Kept are the fourteen of PDF, one for Chinese, Japanese and Korean, and those of
// the scripts and symbols of datasheets. They are drawn where a page does not contain its font; reading text
// does not need them (docs/develop/decisions/0009-contents-of-the-package.md). Any thread.

#include <map>
#include <string_view>

#include <mupdf/fitz.h>
#include <mupdf/ucdn.h>

#include "importer/page/embedded_fonts.h"

// The names that MuPDF's build gives to the bytes of a font.
#define MUPDF_FONT(name, file)                                                                    \
  extern "C" const unsigned char name##Begin[] __asm__("_binary_resources_fonts_" file "_start"); \
  extern "C" const unsigned char name##End[] __asm__("_binary_resources_fonts_" file "_end");     \
  const EmbeddedFont name { name##Begin, name##End }

namespace {

struct EmbeddedFont {
  const unsigned char *begin = nullptr, *end = nullptr;

  /// The form that MuPDF expects: the first byte, or null and size 0.
  const unsigned char* bytes(int* size) const {
    *size = static_cast<int>(end - begin);
    return begin;
  }
};

MUPDF_FONT(mono, "urw_NimbusMonoPS_Regular_cff");
MUPDF_FONT(monoItalic, "urw_NimbusMonoPS_Italic_cff");
MUPDF_FONT(monoBold, "urw_NimbusMonoPS_Bold_cff");
MUPDF_FONT(monoBoldItalic, "urw_NimbusMonoPS_BoldItalic_cff");
MUPDF_FONT(sans, "urw_NimbusSans_Regular_cff");
MUPDF_FONT(sansItalic, "urw_NimbusSans_Italic_cff");
MUPDF_FONT(sansBold, "urw_NimbusSans_Bold_cff");
MUPDF_FONT(sansBoldItalic, "urw_NimbusSans_BoldItalic_cff");
MUPDF_FONT(roman, "urw_NimbusRoman_Regular_cff");
MUPDF_FONT(romanItalic, "urw_NimbusRoman_Italic_cff");
MUPDF_FONT(romanBold, "urw_NimbusRoman_Bold_cff");
MUPDF_FONT(romanBoldItalic, "urw_NimbusRoman_BoldItalic_cff");
MUPDF_FONT(standardSymbols, "urw_StandardSymbolsPS_cff");
MUPDF_FONT(dingbats, "urw_Dingbats_cff");
MUPDF_FONT(european, "noto_NotoSerif_Regular_otf");
MUPDF_FONT(arabic, "noto_NotoNaskhArabic_Regular_otf");
MUPDF_FONT(hebrew, "noto_NotoSerifHebrew_Regular_otf");
MUPDF_FONT(thai, "noto_NotoSerifThai_Regular_otf");
MUPDF_FONT(devanagari, "noto_NotoSerifDevanagari_Regular_otf");
MUPDF_FONT(mathematics, "noto_NotoSansMath_Regular_otf");
MUPDF_FONT(symbols, "noto_NotoSansSymbols_Regular_otf");
MUPDF_FONT(moreSymbols, "noto_NotoSansSymbols2_Regular_otf");
MUPDF_FONT(eastAsian, "droid_DroidSansFallback_ttf");

/// The fonts that a PDF may use without containing them.
const struct {
  std::string_view name;
  EmbeddedFont font;
} base14[] = {{"Courier", mono},
              {"Courier-Oblique", monoItalic},
              {"Courier-Bold", monoBold},
              {"Courier-BoldOblique", monoBoldItalic},
              {"Helvetica", sans},
              {"Helvetica-Oblique", sansItalic},
              {"Helvetica-Bold", sansBold},
              {"Helvetica-BoldOblique", sansBoldItalic},
              {"Times-Roman", roman},
              {"Times-Italic", romanItalic},
              {"Times-Bold", romanBold},
              {"Times-BoldItalic", romanBoldItalic},
              {"Symbol", standardSymbols},
              {"ZapfDingbats", dingbats}};

const std::map<int, EmbeddedFont> byScript{
    {UCDN_SCRIPT_LATIN, european},        {UCDN_SCRIPT_GREEK, european},
    {UCDN_SCRIPT_CYRILLIC, european},     {UCDN_SCRIPT_COMMON, european},
    {UCDN_SCRIPT_INHERITED, european},    {UCDN_SCRIPT_UNKNOWN, european},
    {UCDN_SCRIPT_HAN, eastAsian},         {UCDN_SCRIPT_HANGUL, eastAsian},
    {UCDN_SCRIPT_HIRAGANA, eastAsian},    {UCDN_SCRIPT_KATAKANA, eastAsian},
    {UCDN_SCRIPT_BOPOMOFO, eastAsian},    {UCDN_SCRIPT_ARABIC, arabic},
    {UCDN_SCRIPT_HEBREW, hebrew},         {UCDN_SCRIPT_THAI, thai},
    {UCDN_SCRIPT_DEVANAGARI, devanagari}, {UCDN_SCRIPT_BRAILLE, symbols}};

}  // namespace

const unsigned char* fz_lookup_base14_font(fz_context*, const char* name, int* size) {
  for (const auto& each : base14)
    if (each.name == name) return each.font.bytes(size);
  return EmbeddedFont{}.bytes(size);
}

/// Font by family: MuPDF calls this for HTML only, which is not read here.
const unsigned char* fz_lookup_builtin_font(fz_context*, const char*, int, int, int* size) {
  return EmbeddedFont{}.bytes(size);
}

const unsigned char* fz_lookup_cjk_font(fz_context*, int, int* size, int* subfont) {
  *subfont = 0;
  return eastAsian.bytes(size);
}

const unsigned char* fz_lookup_cjk_font_by_language(fz_context* context, const char*, int* size,
                                                    int* subfont) {
  return fz_lookup_cjk_font(context, FZ_ADOBE_GB, size, subfont);
}

const unsigned char* fz_lookup_noto_font(fz_context*, int script, int, int* size, int* subfont) {
  *subfont = 0;
  const auto font = byScript.find(script);
  return (font == byScript.end() ? EmbeddedFont{} : font->second).bytes(size);
}

const unsigned char* fz_lookup_noto_math_font(fz_context*, int* size) { return mathematics.bytes(size); }
const unsigned char* fz_lookup_noto_music_font(fz_context*, int* size) { return EmbeddedFont{}.bytes(size); }
const unsigned char* fz_lookup_noto_symbol1_font(fz_context*, int* size) { return symbols.bytes(size); }
const unsigned char* fz_lookup_noto_symbol2_font(fz_context*, int* size) { return moreSymbols.bytes(size); }
const unsigned char* fz_lookup_noto_emoji_font(fz_context*, int* size) { return EmbeddedFont{}.bytes(size); }

std::vector<std::span<const unsigned char>> detent::importer::scriptFonts() {
  std::vector<std::span<const unsigned char>> files;
  for (const EmbeddedFont& font :
       {european, arabic, hebrew, thai, devanagari, mathematics, symbols, moreSymbols, eastAsian})
    files.emplace_back(font.begin, font.end);
  return files;
}
