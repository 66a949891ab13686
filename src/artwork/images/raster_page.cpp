#include "artwork/images/raster_page.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "artwork/images/alpha.h"
#include "artwork/images/image_decoding.h"
#include "artwork/images/image_header.h"
#include "artwork/images/mask.h"
#include "artwork/images/reduced_picture.h"
#include "core/base/error.h"

namespace tessera {
namespace {

/// Sides between which finest_side_px() lies. An enlarged drawing shows nothing more, but its contour is smoothed on a
/// grid that is fine enough.
constexpr int kLeastFinestSide_px = 512;
constexpr int kMostFinestSide_px = 2048;

bool has_transparency(const cv::Mat& bgra) {
  cv::Mat alpha;
  cv::extractChannel(bgra, alpha, 3);
  double least = 255;
  cv::minMaxLoc(alpha, &least);
  return least < 255;
}

/// The picture with alpha 255, as straight BGRA.
cv::Mat opaque_page(const cv::Mat& bgr) {
  cv::Mat bgra;
  cv::cvtColor(bgr, bgra, cv::COLOR_BGR2BGRA);
  return bgra;
}

/// Straight BGRA: with the image's own transparency, or with its background cut out.
cv::Mat with_silhouette(const cv::Mat& image, const std::string& path, Background background) {
  if (image.channels() == 4 && has_transparency(image)) return image;
  cv::Mat bgr = image;
  if (image.channels() == 4) cv::cvtColor(image, bgr, cv::COLOR_BGRA2BGR);
  if (image.channels() == 1) cv::cvtColor(image, bgr, cv::COLOR_GRAY2BGR);
  if (background == Background::kept) return opaque_page(bgr);
  if (!has_plain_edge(bgr)) {
    throw InputError(path +
                     ": a photo without a plain background; cut out what it shows (a library of the elements in it: "
                     "tessera library extract)");
  }
  return cut_from_background(bgr);
}

class RasterPage : public ArtworkPage {
 public:
  RasterPage(cv::Mat premultiplied_bgra, cv::Size natural_size, bool loses_pictures)
      : image_(std::move(premultiplied_bgra)),
        natural_size_(natural_size),
        loses_pictures_(loses_pictures) {}

  cv::Size2d natural_size() const override { return natural_size_; }
  bool loses_pictures() const override { return loses_pictures_; }
  int finest_side_px() const override { return std::clamp(longest_side(), kLeastFinestSide_px, kMostFinestSide_px); }
  float source_px(int longest_side_px) const override { return float(longest_side_px) / float(longest_side()); }

  cv::Mat draw(int longest_side_px, const cv::Rect& window) const override {
    cv::Mat page;
    const int filter = longest_side_px < longest_side() ? cv::INTER_AREA : cv::INTER_LINEAR;
    cv::resize(image_, page, page_size_px(*this, longest_side_px), 0, 0, filter);
    return window.size() == page.size() ? page : page(window).clone();
  }

 private:
  int longest_side() const { return std::max(image_.cols, image_.rows); }

  cv::Mat image_;  // may be reduced
  cv::Size natural_size_;
  bool loses_pictures_;
};

}  // namespace

std::unique_ptr<ArtworkPage> open_raster_page(std::span<const std::uint8_t> bytes, const std::string& path,
                                              Background background) {
  DecodedImage image = decode_image(bytes, path, PixelBits::as_stored);
  const cv::Size stored = image.pixels.size();
  image.pixels =
      reduced_picture(image.pixels, kMostWorkedPixels);  // before turning, which needs its memory a second time
  const bool lay_down = image.orientation >= 5;
  const cv::Mat upright = seen_pixels(std::move(image));
  const cv::Size natural_size = lay_down ? cv::Size(stored.height, stored.width) : stored;
  return std::make_unique<RasterPage>(premultiplied(with_silhouette(upright, path, background)), natural_size,
                                      has_several_pictures(bytes));
}

}  // namespace tessera
