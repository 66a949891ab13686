// The drawings of the shapes that were placed, as pixels or vectors, and what became of those that could not be drawn.
// Artwork is foreign: whatever reads it runs in a child process with limits (drawers.h), and a bad drawing costs that
// drawing.
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

/// A definition in an SVG document and how it lies in the artwork frame.
struct SvgSymbol {
  std::string xml;
  double artwork_px_per_unit = 1;
};

/// May be used by several threads at once.
class ShapeArtworks {
 public:
  /// The arguments must outlive it.
  ShapeArtworks(const CollageReport& report, Drawers& drawers, const StopWatcher& stop);

  /// Where the report has colours the silhouette, in whichever colour: who draws the piece gives it its own. Otherwise
  /// the original where it can be had; else the library's thumbnail; else, and where the drawing is bad, the silhouette
  /// in its mean colour. `slot` is the shape's in the report. The page's longest side is `side_px` long or less. Throws
  /// DrawingStopped.
  Sprite sprite(std::size_t slot, int side_px);
  /// The same as an SVG element with this id; the silhouette is a path.
  SvgSymbol symbol(std::size_t slot, const std::string& id);

  const Outline& clip(std::size_t slot) const { return clips_[slot]; }
  /// Throws DrawingStopped where drawing is to end, as the others do.
  void check_stop() const { stop_.check(); }
  /// The notes on all that was asked for.
  DrawingNotes notes() const;

 private:
  /// What is to be drawn; empty bytes: nothing but the silhouette.
  struct Source {
    std::vector<std::uint8_t> bytes;
    bool thumbnail = false;
  };

  /// Of a deformed piece the library's shape, whose drawing is warped; else the shape itself.
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
