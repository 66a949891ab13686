// Decodes or draws everything foreign: SVGs, images, thumbnails. This happens in child processes with limits on memory,
// CPU time and wall-clock time, without network and without new files (drawer_sandbox.h). A hostile file costs only its
// own drawing. The children run the small program tessera-drawer (drawer_program.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <opencv2/core.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "artwork/artwork_shape.h"
#include "artwork/images/artwork_page.h"
#include "artwork/protocol/drawer_layers.h"
#include "core/deform/warp.h"

namespace tessera {

struct SvgOutlines;  // artwork/outlines/svg_outlines.h

struct DrawerSettings {
  int processes = 1;                                       // drawings made at a time
  double seconds_per_drawing = 20;                         // of CPU time; of wall-clock time three times as much
  std::size_t bytes_per_process = std::size_t(512) << 20;  // of address space, beyond what a process needs to start
  double seconds_to_start = 60;  // on a busy machine with a cold disk, linking its libraries can take long
  std::string program = {};      // the file of tessera-drawer; empty: found by drawer_program()
};

/// Settings for the largest photo, with 16 bits a channel.
DrawerSettings photo_drawer_settings(int processes);

/// Thrown by calls that run when Drawers::stop is called, and by later calls.
class DrawingStopped : public std::runtime_error {
 public:
  DrawingStopped() : std::runtime_error("drawing was stopped") {}
};

/// Any thread may call any member at any time; a call waits for a free process. `path` is used in messages only. A call
/// throws InputError, which names `path` and the reason, where the bytes cannot be used, exceed a limit of
/// artwork_render.h, or where the process crashed or had to be ended. It throws EnvironmentError where no process can
/// be started, and DrawingStopped.
class Drawers {
 public:
  /// Starts no process yet: each starts with the first call that needs it, and again after it has died.
  explicit Drawers(const DrawerSettings& settings);
  /// Ends all processes. No call may be running.
  ~Drawers();
  Drawers(const Drawers&) = delete;
  Drawers& operator=(const Drawers&) = delete;

  /// See render_artwork (artwork_render.h): the page as straight BGRA, CV_8UC4.
  cv::Mat render(std::span<const std::uint8_t> bytes, const std::string& path, int longest_side_px,
                 Background background = Background::cut_out);

  /// The size of the page in its own units (ArtworkPage::natural_size).
  cv::Size2d natural_size(std::span<const std::uint8_t> bytes, const std::string& path);

  /// The SVG as part of another document; see svg_import.h. The page has the size natural_size().
  std::string import_svg(std::span<const std::uint8_t> bytes, const std::string& path, const std::string& scope_id);

  /// The drawing deformed by `page_warp`, a map of the page in units of natural_size; see warped_svg.h. Also throws
  /// InputError where it can only be deformed as a picture, and where the warp is invalid (warp_codec.h).
  std::string warped_svg(std::span<const std::uint8_t> bytes, const std::string& path, const std::string& scope_id,
                         const Warp& page_warp);

  /// The pixels of a PNG unchanged, without removing a background: straight BGRA, CV_8UC4. A picture larger than
  /// `longest_side_px` is shrunk to it.
  cv::Mat decode_png(std::span<const std::uint8_t> bytes, const std::string& path, int longest_side_px);

  /// See whole_picture.h: straight BGRA, CV_8UC4.
  cv::Mat whole_picture(std::span<const std::uint8_t> bytes, const std::string& path, int longest_side_px);

  /// See photo.h: CV_8UC4, opaque; CV_32SC1.
  cv::Mat photo(std::span<const std::uint8_t> bytes, const std::string& path);
  cv::Mat labels(std::span<const std::uint8_t> bytes, const std::string& path);

  /// See svg_outlines.h.
  SvgOutlines svg_outlines(std::span<const std::uint8_t> bytes, const std::string& path, double px_per_inch);

  /// See artwork_shape.h. Shape::name and Artwork::path follow from `path`.
  std::variant<ArtworkShape, SkipReason> shape(std::span<const std::uint8_t> bytes, const std::string& path,
                                               const TracingSettings& settings);

  /// A PDF file with the SVG as its only page, `width_pt` points of 1/72 inch wide. Vectors stay vectors. The same SVG
  /// gives the same bytes. See printed_svg.h; where that is too much for cairo, librsvg draws it alone.
  std::vector<std::uint8_t> pdf_of_svg(std::span<const std::uint8_t> svg, double width_pt);

  /// Ends all processes at once. Running calls and later ones throw DrawingStopped.
  void stop();

  /// The worst state of each layer of the sandbox in any process started so far.
  DrawerLayers layers() const;

 private:
  class DrawerPool;
  std::unique_ptr<DrawerPool> crew_;
};

}  // namespace tessera
