// Collects drawings that name no unit of length, and tells the user which unit tessera nest assumes.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "products/nesting/drawings/dxf_drawings.h"
#include "products/nesting/drawings/svg_drawings.h"
#include "products/nesting/nest_input.h"

namespace tessera {

class UnknownUnits {
 public:
  /// Adds an SVG; `path` is for people. Notes SVGs without a unit, and SVGs of programs with px of their own.
  void add_svg(const std::string& path, const SvgOutlines& outlines, const std::vector<NestDrawing>& drawings);
  /// Adds a DXF without a unit.
  void add_dxf(const std::string& path, const DxfDrawings& found);

  /// Adds one note for each format, which names the first file, and sets NestInput::unit. `path`: the file or folder.
  void report(const std::string& path, NestInput& input) const;

 private:
  struct Files {
    std::size_t count = 0;
    std::string first;    // its path
    std::string size_mm;  // for people: "its page is 105.8 x 79.4 mm"
  };

  Files svgs_, dxfs_;
  std::vector<std::string> own_px_;  // notes on SVGs whose program has px of its own
};

}  // namespace tessera
