// Everything foreign that is decoded or drawn: SVGs, images, thumbnails. It happens in child processes with limits on
// memory, CPU time and wall-clock time, without network and without new files (drawer_sandbox.h), so that a hostile
// file costs its own drawing and nothing else. The children run the small program tessera-drawer (drawer_program.h).
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
  int processes = 1;                                       // how many drawings are made at a time
  double seconds_per_drawing = 20;                         // of CPU time; of wall-clock time three times as much
  std::size_t bytes_per_process = std::size_t(512) << 20;  // of address space, beyond what a process starts with
  double seconds_to_start = 60;  // linking its libraries can take long on a busy machine with a cold disk
  std::string program = {};      // the file of tessera-drawer; empty: drawer_program() finds it
};

/// What drawers must be allowed for the largest photo, 16 bits a channel.
DrawerSettings photo_drawer_settings(int processes);

/// What calls throw that were under way when Drawers::stop was called, or came later.
class DrawingStopped : public std::runtime_error {
 public:
  DrawingStopped() : std::runtime_error("drawing was stopped") {}
};

/// All members may be called from several threads at once; a call waits for a free process. `path` stands in messages
/// only. A call throws InputError, which names `path` and the reason, where the bytes are of no use, break a limit of
/// artwork_render.h, or where the process crashed or had to be ended; EnvironmentError where no process can be started;
/// DrawingStopped.
class Drawers {
 public:
  /// Starts no process yet: each starts with the first call that needs it, and again after it died.
  explicit Drawers(const DrawerSettings& settings);
  /// Ends all processes. No call may be under way.
  ~Drawers();
  Drawers(const Drawers&) = delete;
  Drawers& operator=(const Drawers&) = delete;

  /// See render_artwork (artwork_render.h): the page as straight BGRA, CV_8UC4.
  cv::Mat render(std::span<const std::uint8_t> bytes, const std::string& path, int longest_side_px,
                 Background background = Background::cut_out);

  /// The size of the page in units of its own (ArtworkPage::natural_size).
  cv::Size2d natural_size(std::span<const std::uint8_t> bytes, const std::string& path);

  /// See svg_import.h; the page has the size that natural_size says.
  std::string import_svg(std::span<const std::uint8_t> bytes, const std::string& path, const std::string& scope_id);

  /// See warped_svg.h: the drawing as `page_warp` deforms it, a map of the page in units of natural_size. Throws InputError,
  /// too, where it can only be deformed as a picture, and where the warp is none (warp_codec.h).
  std::string warped_svg(std::span<const std::uint8_t> bytes, const std::string& path, const std::string& scope_id,
                         const Warp& page_warp);

  /// The pixels of a PNG as they are, nothing cut from a background: straight BGRA, CV_8UC4. One that is larger than
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

  /// A PDF file with one page, the SVG's, `width_pt` points of 1/72 inch wide. Vectors stay vectors. The same SVG gives
  /// the same bytes. See printed_svg.h; where that is too much for cairo, librsvg alone draws it.
  std::vector<std::uint8_t> pdf_of_svg(std::span<const std::uint8_t> svg, double width_pt);

  /// Ends all processes at once. Calls under way and later ones throw DrawingStopped.
  void stop();

  /// Of all processes that were started so far, the worst.
  DrawerLayers layers() const;

 private:
  class Crew;
  std::unique_ptr<Crew> crew_;
};

}  // namespace tessera
