// SPDX-License-Identifier: GPL-3.0-or-later
#include "importer/overlay/encode_png.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "model/check.h"

namespace detent::importer {

std::string pngBytes(const Raster& picture) {
  DETENT_CHECK(!picture.empty(), "a picture to encode has pixels");
  const cv::Mat rgb(picture.height_px, picture.width_px, CV_8UC3,
                    const_cast<std::uint8_t*>(picture.rgb.data()));
  cv::Mat bgr;
  cv::cvtColor(rgb, bgr, cv::COLOR_RGB2BGR);
  std::vector<unsigned char> bytes;
  DETENT_CHECK(cv::imencode(".png", bgr, bytes), "a picture in memory can be encoded");
  return {bytes.begin(), bytes.end()};
}

}  // namespace detent::importer
