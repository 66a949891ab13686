// Measures the pixels of a collage, while they are drawn, against the picture that its pieces show (colour.image).
#pragma once

#include <optional>
#include <string>

#include "artwork/drawers/drawers.h"
#include "result/afar_section.h"
#include "result/collage_files.h"
#include "result/picture_cells.h"

namespace tessera {

class AfarMeasure {
 public:
  /// Reads `image` (colour.image) with the resolution of the run, which depends on the size of the smallest piece,
  /// `smallest_px`; empty: that size is no longer known. The report has the pieces as they were placed, not yet deformed.
  /// Where the picture cannot be read or has changed since the collage was made, the note says so, because drawing does not
  /// need it. Throws EnvironmentError where the system has no process left for decoding, and DrawingStopped.
  AfarMeasure(const CollageReport& report, const std::string& image, std::optional<float> smallest_px,
              Drawers& drawers);

  /// Takes the picture's rows, like the files that are written.
  PictureFile& rows() { return mosaic_; }
  /// The figures; to be called after the last row.
  AfarNote note() const;

 private:
  const Canvas& canvas_;
  const std::size_t pieces_;
  MosaicCells mosaic_;
  Grid<WeightedColour> picture_;  // empty: there is none
  std::string not_measured_;
};

}  // namespace tessera
