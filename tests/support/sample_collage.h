// A collage of two or three pieces, made by hand, for tests of its output files.
#pragma once

#include <cmath>
#include <string>

#include "job/pieces/wished_sizes.h"
#include "result/collage_files.h"
#include "support/synthetic_shapes.h"

namespace tessera::test {

/// The canvas has 200 x 100 px, the picture twice that. Library shape 7 is a disc, shape 3 a ring; both have no artwork.
struct SampleCollage {
  SampleCollage() {
    job.path = "sample.toml";
    job.library = "/nowhere/sample.h5";
    job.quality = QualityWord::none;  // an effective job has the number instead
    report.statistics.stopped_by = StopReason::full;
    report.output.width_px = 400;
    report.output.background = "#ffe0c0";
    report.box = job.canvas;
    report.canvas = &canvas;
    report.shapes.add(ShapeId{7}, make_test_shape("disc", disc_outline()));
    report.shapes.add(ShapeId{3}, make_test_shape("ring", ring_outline()));
    place(ShapeId{7}, 40, {50, 50}, 0.5f);
    place(ShapeId{3}, 60, {140, 50}, 0);
  }
  SampleCollage(const SampleCollage&) = delete;
  SampleCollage& operator=(const SampleCollage&) = delete;

  void place(ShapeId shape, float scale, Vec2 centre, float rotation_rad) {
    const Similarity t{scale * std::cos(rotation_rad), scale * std::sin(rotation_rad), centre.x, centre.y};
    report.placements.push_back({shape, t, 0.75f, 12.5f});
  }

  ResultSource source() const {
    return {.origin = {to_toml(job), 11, 22},
            .library = job.library,
            .start = job.start.pieces,
            .start_digest = job.start.digest,
            .sizes = wished_sizes(job),
            .card = {},
            .shown_png = {}};
  }

  Job job;
  Canvas canvas = make_rectangle_canvas(200, 100);
  CollageReport report;
};

/// Gives the shape `file` as its embedded artwork, on a page of `width` x `height` units. The shape's centre lies in the middle of the
/// page, and one shape unit is `unit` page units long.
inline void embed_artwork(Shape& shape, const std::string& file, float width, float height, float unit) {
  const float px = 512 / std::max(width, height);  // 512 is the size at which library build draws
  shape.artwork.original.assign(file.begin(), file.end());
  shape.artwork.width_px = int(std::ceil(width * px));
  shape.artwork.height_px = int(std::ceil(height * px));
  shape.artwork.centroid_px = {width * px / 2, height * px / 2};
  shape.artwork.unit_px = unit * px;
}

}  // namespace tessera::test
