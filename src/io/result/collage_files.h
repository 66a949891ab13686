// What a run leaves in its directory: picture, pieces, quality card, effective job.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/run_statistics.h"
#include "core/collage/placement.h"
#include "core/field/canvas.h"
#include "core/ranks/rank_statistics.h"
#include "core/shape/shape.h"
#include "io/job/job_file.h"
#include "io/result/run_record.h"

namespace tessera::io {

/// All that the output files are made from. `shapes[i]` is the library shape of index `shape_index[i]`; only shapes that
/// were placed are there, read with outline, field, thumbnail and embedded original.
struct CollageReport {
  const Job* job = nullptr;
  const Canvas* canvas = nullptr;
  std::vector<Placement> placements;
  std::vector<std::uint32_t> shape_index;
  std::vector<Shape> shapes;
  RunStatistics statistics;
  RankStatistics ranks;
  RunRecord record;

  /// Where library shape `index` is in `shapes`. Throws std::out_of_range where it is not.
  std::size_t slot_of(std::uint32_t index) const;
  const Shape& shape(std::uint32_t index) const { return shapes[slot_of(index)]; }
};

/// Creates `dir` (and parents) and proves that it can be written; throws EnvironmentError. Called before the work.
void prepare_output_directory(const std::string& dir);

/// Each file is written to a temporary name and renamed. Order: pieces.geojson, card.json, card.txt, job.toml,
/// collage.svg, collage.png. `quick` draws from thumbnails only (a run that was interrupted has little time).
/// Returns the text of the card.
std::string write_collage(const std::string& dir, const CollageReport& report, bool quick);

}  // namespace tessera::io
