// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/axes/read_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include <opencv2/imgproc.hpp>
#include <tesseract/baseapi.h>
#include <tesseract/resultiterator.h>

#include "importer/axes/light_model.h"
#include "importer/frame/darkness.h"

/// Function of libgomp, which Debian's Tesseract uses; <omp.h> is not available for every compiler.
extern "C" void omp_set_max_active_levels(int levels);

namespace detent::importer {
namespace {

constexpr double readHeight_px =
    32;  // height of a text line for which the recogniser was trained (Tesseract 5 LSTM: 36 with margins)
constexpr int margin_px = 10;
// largest confidence of recognised text; 1 is reserved for the document's own text
constexpr double mostSure = 0.995;
constexpr double sureReading = 0.75;  // digits in good print score above 0.9

/// Variants of presenting a crop to the recogniser.
struct Rendering {
  double height_px = readHeight_px;
  bool thinned = false;  ///< strokes one pixel thinner on either side
};

/// Tesseract's model: from the folder that the user has set, else from the usual folders of distributions.
std::optional<LightModel> installedModel() {
  std::vector<std::string> folders;
  if (const char* said = std::getenv("TESSDATA_PREFIX")) folders = {said, std::string(said) + "/tessdata"};
  folders.insert(folders.end(), {"/usr/share/tesseract-ocr/5/tessdata", "/usr/share/tessdata",
                                 "/usr/local/share/tessdata", "/opt/homebrew/share/tessdata"});
  for (const std::string& folder : folders) {
    std::ifstream file(folder + "/eng.traineddata", std::ios::binary | std::ios::ate);
    if (!file) continue;
    std::string bytes(static_cast<std::size_t>(std::max<std::streamoff>(0, file.tellg())), '\0');
    file.seekg(0).read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return LightModel::from(bytes);
  }
  return {};
}

/// Letters that may occur in a line of this kind; empty: any.
std::string lettersOf(TextKind kind) {
  switch (kind) {
    case TextKind::number:
      return "0123456789.,-";
    case TextKind::unit:  // includes the Latin letters that resemble Cyrillic ones
      return "mcMCNdkKgGfFoOzZlLbinhuesrpH()[]/,.";
    case TextKind::words:
      break;
  }
  return {};
}

/// Put in place of a first letter that is wider than the line is high. No letter is that wide: the engine has
/// read "荷重 [gf]" as "a [gf]".
constexpr std::string_view unreadableSign = "\xEF\xBF\xBD";

bool beginsWithSingleLetter(std::string_view text) {
  const auto isLatin = [&](std::size_t i) {
    return i < text.size() && std::isalpha(static_cast<unsigned char>(text[i])) != 0;
  };
  return isLatin(0) && !isLatin(1);
}

/// One engine per thread. LSTM only; dictionaries would turn "gf" into "of".
class Engine {
 public:
  Engine() : model_(installedModel()) {
    api_ = std::make_unique<tesseract::TessBaseAPI>();
    const std::vector<std::string> keys{"load_system_dawg", "load_freq_dawg", "debug_file",
                                        "tessedit_do_invert"};
    const std::vector<std::string> values{"0", "0", "/dev/null", "0"};
    if (model_ && api_->Init(model_->bytes().data(), static_cast<int>(model_->bytes().size()), "eng",
                             tesseract::OEM_LSTM_ONLY, nullptr, 0, &keys, &values, false, nullptr) == 0)
      return;
    model_.reset();  // the model has another layout; the regular, slower start handles it
    if (api_->Init(nullptr, "eng", tesseract::OEM_LSTM_ONLY, nullptr, 0, &keys, &values, false) != 0)
      api_.reset();
  }
  bool ready() const { return api_ != nullptr; }

  /// Dark text on white, 8-bit and continuous. Equal pixels are read once, because the searches for
  /// labels, titles and legends of a plot and of its neighbours meet the same lines.
  SeenText line(const cv::Mat& grey, TextKind kind) {
    constexpr std::size_t most = 256;  // lines of several plots
    const std::tuple key(kind, grey.cols, std::string(grey.datastart, grey.dataend));
    if (const auto read = known_.find(key); read != known_.end()) return read->second;
    if (known_.size() >= most) known_.clear();
    return known_.emplace(key, recognised(grey, kind)).first->second;
  }

 private:
  SeenText recognised(const cv::Mat& grey, TextKind kind) {
    SeenText seen;
    if (!api_) return seen;
    // Threads within a single line cost more than they gain (they spin), and they take the other cores from a
    // batch.
    omp_set_max_active_levels(0);
    api_->SetPageSegMode(tesseract::PSM_SINGLE_LINE);
    const std::string letters = lettersOf(kind), requested = model_ ? model_->renamed(letters) : letters;
    api_->SetVariable("tessedit_char_whitelist", requested.c_str());
    api_->SetImage(grey.data, grey.cols, grey.rows, 1, static_cast<int>(grey.step));
    api_->SetSourceResolution(200);
    if (api_->Recognize(nullptr) != 0) return seen;
    const std::unique_ptr<char[]> text(api_->GetUTF8Text());
    if (text) seen.utf8 = model_ ? model_->original(text.get()) : text.get();
    while (!seen.utf8.empty() && (seen.utf8.back() == '\n' || seen.utf8.back() == ' ')) seen.utf8.pop_back();
    if (kind == TextKind::words && beginsWithSingleLetter(seen.utf8) &&
        firstSignWidth_px() > grey.rows - 2 * margin_px)
      seen.utf8.replace(0, 1, unreadableSign);
    seen.confidence = seen.utf8.empty() ? 0 : std::clamp(api_->MeanTextConf() / 100.0, 0.0, mostSure);
    return seen;
  }

  /// Width of the line's first sign as the engine sees it; 0 without any.
  int firstSignWidth_px() const {
    const std::unique_ptr<tesseract::ResultIterator> at(api_->GetIterator());
    int left = 0, top = 0, right = 0, bottom = 0;
    return at && at->BoundingBox(tesseract::RIL_SYMBOL, &left, &top, &right, &bottom) ? right - left : 0;
  }

  std::optional<LightModel> model_;  // empty: the engine names letters as they are
  std::unique_ptr<tesseract::TessBaseAPI> api_;
  std::map<std::tuple<TextKind, int, std::string>, SeenText> known_;  // by kind, width and pixels
};

Engine& engineOfThread() {
  thread_local Engine engine;
  return engine;
}

/// The crop as black on white, text upright, at about the requested height, with a white margin.
cv::Mat crop(const Raster& raster, const Box& box, double angle_deg, const Rendering& rendering) {
  const int x0 = std::clamp(static_cast<int>(std::floor(box.x0 + 0.5)) - 1, 0, raster.width_px);
  const int x1 = std::clamp(static_cast<int>(std::ceil(box.x1 + 0.5)) + 1, 0, raster.width_px);
  const int y0 = std::clamp(static_cast<int>(std::floor(box.y0 + 0.5)) - 1, 0, raster.height_px);
  const int y1 = std::clamp(static_cast<int>(std::ceil(box.y1 + 0.5)) + 1, 0, raster.height_px);
  if (x1 - x0 < 3 || y1 - y0 < 3) return {};
  const cv::Mat rgb(raster.height_px, raster.width_px, CV_8UC3, const_cast<std::uint8_t*>(raster.rgb.data()));
  cv::Mat grey;
  cv::cvtColor(rgb(cv::Rect(x0, y0, x1 - x0, y1 - y0)), grey, cv::COLOR_RGB2GRAY);
  const int quarter = ((static_cast<int>(std::lround(angle_deg / 90)) % 4) + 4) % 4;
  if (quarter == 1) cv::rotate(grey, grey, cv::ROTATE_90_CLOCKWISE);
  if (quarter == 2) cv::rotate(grey, grey, cv::ROTATE_180);
  if (quarter == 3) cv::rotate(grey, grey, cv::ROTATE_90_COUNTERCLOCKWISE);
  double low = 0, high = 0;
  cv::minMaxLoc(grey, &low, &high);
  if (high - low < 24) return {};
  // The paper's colour is the one that most of the margin has.
  const double rim = 0.5 * (cv::mean(grey.row(0))[0] + cv::mean(grey.row(grey.rows - 1))[0]);
  const bool inverted = rim < 0.5 * (low + high);
  grey.convertTo(grey, CV_8U, (inverted ? -1 : 1) * 255.0 / (high - low),
                 inverted ? 255.0 * high / (high - low) : -255.0 * low / (high - low));
  const double scale = std::clamp(rendering.height_px / std::max(1, grey.rows - 2), 0.2, 6.0);
  cv::resize(grey, grey, cv::Size(), scale, scale, scale > 1 ? cv::INTER_CUBIC : cv::INTER_AREA);
  if (rendering.thinned) cv::dilate(grey, grey, cv::getStructuringElement(cv::MORPH_RECT, {3, 3}));
  cv::copyMakeBorder(grey, grey, margin_px, margin_px, margin_px, margin_px, cv::BORDER_CONSTANT,
                     cv::Scalar(255));
  return grey;
}

}  // namespace

TextReader::TextReader(const PageView& view) : view_(view) {}

bool TextReader::available() { return engineOfThread().ready(); }

namespace {

SeenText readRendering(const Raster& raster, const Box& box, TextKind kind, double angle_deg,
                       const Rendering& rendering) {
  const cv::Mat grey = crop(raster, box, angle_deg, rendering);
  SeenText seen;
  if (!grey.empty()) seen = engineOfThread().line(grey, kind);
  seen.box = box;
  seen.angle_deg = angle_deg;
  return seen;
}

}  // namespace

SeenText TextReader::readLine(const Box& box, TextKind kind, double angle_deg) {
  return readRendering(view_.raster, box, kind, angle_deg, {});
}

SeenText TextReader::readLineCarefully(const Box& box, TextKind kind, double angle_deg) {
  SeenText best = readLine(box, kind, angle_deg);
  for (const Rendering& other : {Rendering{1.5 * readHeight_px, true}, Rendering{readHeight_px, true},
                                 Rendering{0.75 * readHeight_px, false}}) {
    if (best.confidence >= sureReading) break;
    SeenText again = readRendering(view_.raster, box, kind, angle_deg, other);
    if (again.confidence > best.confidence) best = std::move(again);
  }
  return best;
}

std::vector<SeenText> TextReader::readLineOtherwise(const Box& box, double angle_deg) {
  std::vector<SeenText> seen;
  for (const double larger : {1.5, 1.25, 0.75})
    seen.push_back(
        readRendering(view_.raster, box, TextKind::words, angle_deg, {larger * readHeight_px, false}));
  std::erase_if(seen, [](const SeenText& t) { return t.utf8.empty(); });
  return seen;
}

}  // namespace detent::importer
