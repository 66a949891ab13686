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
  /// Reads `image` (colour.image) as finely as the run did, which goes by the size of the smallest piece, in px;
  /// nothing where that is not known any more. The report has the pieces as they were placed, not yet deformed. Where
  /// the picture cannot be had, or is another than when the collage was made, the note says so: drawing does not need
  /// it. Throws EnvironmentError where it cannot be decoded for want of processes, DrawingStopped.
  AfarMeasure(const CollageReport& report, const std::string& image, std::optional<float> smallest_px,
              Drawers& drawers);

  /// Takes the picture's rows, beside the files that are written.
  PictureFile& rows() { return mosaic_; }
  /// After the last row.
  AfarNote note() const;

 private:
  const Canvas& canvas_;
  const std::size_t pieces_;
  MosaicCells mosaic_;
  Grid<WeightedColour> picture_;  // empty: it is not there
  std::string not_measured_;
};

}  // namespace tessera
