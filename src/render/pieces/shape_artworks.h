// The drawings of the placed shapes, as pixels or vectors, and notes about drawings that failed. Artwork is foreign: a
// child process with limits reads it (drawers.h), and a bad file costs only its own drawing.
#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <opencv2/core.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "artwork/drawers/drawers.h"
#include "render/pieces/sprite.h"
#include "render/pieces/stop_watcher.h"
#include "result/collage_files.h"
#include "result/drawing_notes.h"

namespace tessera {

/// A definition in an SVG document and its place in the artwork frame.
struct SvgSymbol {
  std::string xml;
  double artwork_px_per_unit = 1;
};

/// The drawings of a report. Several threads may use it at once.
class ShapeArtworks {
 public:
  /// The arguments must outlive it.
  ShapeArtworks(const CollageReport& report, Drawers& drawers, const StopWatcher& stop);

  /// The drawing of a shape in pixels. Where the report has colours: the silhouette in any colour; whoever draws the piece
  /// colours it. Otherwise the original where it can be read, else the library's thumbnail, else (also where the drawing is
  /// bad) the silhouette in its mean colour. `slot` is the shape's in the report. The longest side of the page is at most
  /// `side_px`. Throws DrawingStopped.
  Sprite sprite(std::size_t slot, int side_px);
  /// The drawing of a shape as an SVG element with this id; the silhouette is a path.
  SvgSymbol symbol(std::size_t slot, const std::string& id);

  const Outline& clip(std::size_t slot) const { return clips_[slot]; }
  /// Throws DrawingStopped where drawing shall end, like the other members.
  void check_stop() const { stop_.check(); }
  /// The notes on all drawings that were asked for.
  DrawingNotes notes() const;

 private:
  /// The source of a drawing; empty bytes: only the silhouette.
  struct Source {
    std::vector<std::uint8_t> bytes;
    bool thumbnail = false;
  };

  /// The shape whose drawing is used: the library's shape for a deformed piece, whose drawing is warped; otherwise the shape itself.
  const Shape& original(std::size_t slot) const;
  std::size_t original_slot(std::size_t slot) const;
  Outline clip_of(std::size_t slot) const;
  Outline original_clip(std::size_t slot) const;
  SvgSymbol drawing_symbol(std::size_t slot, const Source& source, const std::string& id);
  bool may_be_paths(std::size_t slot, const Source& source) const;
  int pixels_of_piece(std::size_t slot) const;
  SvgSymbol warped_symbol(std::size_t slot, const Source& source, const std::string& id);
  Source source_of(std::size_t slot);
  cv::Mat drawn(std::size_t slot, const Source& source, int side_px);
  void note(std::size_t slot, DrawnFrom from, const std::string& reason);

  const CollageReport& report_;
  Drawers& drawers_;
  const StopWatcher& stop_;
  std::vector<Outline> clips_;
  mutable std::mutex mutex_;
  std::set<std::pair<std::size_t, int>> bad_;                       // slots and sides that are not tried again
  std::set<std::size_t> not_as_paths_;                              // originals whose paths cannot be warped
  std::map<std::size_t, std::pair<DrawnFrom, std::string>> notes_;  // by slot
};

}  // namespace tessera
