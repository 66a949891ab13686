#include "result/deformation_table.h"

#include <nlohmann/json.hpp>

#include "result/card_lines.h"
#include "text/number_text.h"

namespace tessera {

nlohmann::ordered_json deformation_json(const DeformationFigures& f) {
  return {{"coverage_before_fraction", rounded(f.coverage_before, 6)},
          {"overlap_before_fraction", rounded(f.overlap_before, 6)},
          {"pieces", f.pieces},
          {"median_pad_distance", rounded(f.median_pad_distance, 6)},
          {"largest_pad_distance", rounded(f.largest_pad_distance, 6)},
          {"median_area_change_fraction", rounded(f.median_area_change, 6)},
          {"largest_area_change_fraction", rounded(f.largest_area_change, 6)},
          {"farthest_px", rounded(f.farthest_px, 3)},
          {"least_jacobian", rounded(f.least_jacobian, 3)},
          {"seconds", rounded(f.seconds, 3)}};
}

std::string deformation_text(const DeformationFigures& f) {
  return "Deformation\n" +
         card_line("before it",
                   percent_text(f.coverage_before, 2) + " covered, overlap " + percent_text(f.overlap_before, 3)) +
         card_line("pieces deformed", std::to_string(f.pieces) + ", by " + fixed(f.farthest_px, 1) +
                                          " px at most, in " + fixed(f.seconds, 1) + " s") +
         card_line("PAD distance", fixed(f.median_pad_distance, 3) + "  (to the shapes before, median; at most " +
                                       fixed(f.largest_pad_distance, 3) + ")") +
         card_line("change of area", percent_text(f.median_area_change, 1) + "  (median; at most " +
                                         percent_text(f.largest_area_change, 1) + ")") +
         card_line("smallest Jacobian", fixed(f.least_jacobian, 2) + "  (above 0: no drawing is folded)");
}

}  // namespace tessera
