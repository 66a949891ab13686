// Untrusted artwork, parsed and checked, that can be drawn at any scale: an SVG page or a raster image.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

namespace tessera {

class ArtworkPage {
 public:
  virtual ~ArtworkPage() = default;

  /// The size of the page in its own px: those of the image, or 1/96 inch.
  virtual cv::Size2d natural_size() const = 0;
  /// Longest useful side of a drawing: a larger one costs memory or shows nothing more.
  virtual int finest_side_px() const = 0;
  /// The size of a pixel of the source, in px of a drawing with this longest side; 0 for vectors.
  virtual float source_px(int longest_side_px) const = 0;
  /// Whether text is not drawn, as this machine has no font.
  virtual bool loses_text() const { return false; }
  /// Whether the file has more pictures than its first one, which is drawn: an animation, or pages.
  virtual bool loses_pictures() const { return false; }
  /// The page drawn with this longest side, cut to `window` (px of that drawing, within page_size_px): CV_8UC4,
  /// premultiplied BGRA.
  virtual cv::Mat draw(int longest_side_px, const cv::Rect& window) const = 0;
};

/// The treatment of the background of an image without transparency.
enum class Background { cut_out, kept };

/// Size of the page's drawing: the longest side exactly, the other one rounded up.
cv::Size page_size_px(const ArtworkPage& page, int longest_side_px);

}  // namespace tessera
