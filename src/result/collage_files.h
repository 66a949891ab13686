// What a run leaves in its directory: pieces, quality card, effective job, manifest. The pictures are made from these.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "checkpoint/checkpoint_origin.h"
#include "core/base/run_statistics.h"
#include "core/collage/placement.h"
#include "core/colour/harmony.h"
#include "core/field/canvas.h"
#include "core/quality/size_balance.h"
#include "core/ranks/rank_statistics.h"
#include "job/canvas/canvas_edge.h"
#include "job/job_file.h"
#include "layers/ground_tile.h"
#include "layers/keep_out_drawing.h"
#include "layers/tone_patch.h"
#include "result/card_output.h"
#include "result/deformed_collage.h"
#include "result/folder/run_record.h"
#include "result/missing_shape.h"
#include "result/placed_shapes.h"

namespace tessera {

/// What is done to the colours of a piece: a patch is laid over it, then hues are turned.
struct Tone {
  TonePatch patch;   // tone_patch.h
  int turn_deg = 0;  // hue_turns.h
};

/// All that pieces.geojson and the pictures are made from. The shapes have outline, field, thumbnail and, for pictures,
/// the embedded original.
struct CollageReport {
  OutputSpec output;  // of the pictures (on_paper)
  CanvasSpec box;     // for pictures: the canvas' box in px and on paper (shrink_box_to_page)
  const Canvas* canvas = nullptr;
  CanvasEdge canvas_edge;   // for pictures
  KeepOutDrawing keep_out;  // for pictures; mostly none
  GroundTile ground;        // for pictures; mostly none
  GroundTile overlay;       // for pictures, laid over all else with overlay_opacity; mostly none
  double overlay_opacity = 0;
  std::vector<Placement> placements;
  PlacedShapes shapes;
  std::vector<std::string> groups;          // of the placements (shape_groups), "" for none; empty: there are no groups
  std::vector<bool> locked;                 // of the placements: for good (GivenPiece::for_good); empty: none is
  std::optional<DeformedCollage> deformed;  // deformed_collage.h: then each piece has a shape of its own
  std::vector<std::string> colours;   // of the placements, "#rrggbb": silhouettes are drawn; empty: the artwork is
  std::vector<std::string> covered;   // of the placements: covered_colours (tones.h); empty: no picture is shown
  std::vector<Tone> tones;            // of the placements; empty: the drawings' own
  double shift = 0;                   // so far a tone may be from the drawing's, CIEDE2000
  std::vector<StyleFeatures> styles;  // of the placements' drawings; empty: unknown
  std::optional<Harmony> harmony;     // that the hues of `tones` make
  std::vector<MissingShape> missing;  // of a finished collage
  RunStatistics statistics;
  RankStatistics ranks;
  RunRecord record;

  /// Throws std::out_of_range where it was not placed.
  const Shape& shape(ShapeId id) const { return shapes[shapes.slot_of(id)]; }
};

/// What a result says of the job that it comes from.
struct ResultSource {
  CheckpointOrigin origin;
  std::string library;             // library_text
  std::string start;               // start_file; empty: it began from no result
  std::uint64_t start_digest = 0;  // StartSpec::digest
  std::optional<SizeRange> sizes;  // wished_sizes
  CardSettings card;
  std::shared_ptr<const std::vector<std::uint8_t>> shown_png;  // Job::shown_png
};

/// Creates `dir` and proves that it can be written; throws EnvironmentError. Called before the work.
void prepare_output_directory(const std::string& dir);

/// Throws EnvironmentError where a file of a result cannot be written in `dir`, as where a folder has its name.
void check_can_be_published(const std::string& dir);

/// Throws InputError where `dir` holds files with the names of a result's that no run of this program left there, or
/// the job file that is about to be run: a result would replace them.
void check_nothing_foreign_is_replaced(const std::string& dir, const std::string& job_file);

/// Makes the run's placements the result in `dir`, so that a crash at any moment leaves either what the folder's
/// checkpoints hold or a result that is whole: the manifest of the run before goes first, and its pictures with it;
/// then come pieces.geojson, job.toml, card.json and card.txt, each to a temporary name and renamed; and manifest.json
/// last, when they are on the disk. Of an unfinished result it comes before the cards, whose measuring takes a second
/// on a large canvas: mpirun kills two seconds after Ctrl-C. Nothing is drawn (result_drawing.h). Before the call there
/// must be a checkpoint where the work must not be lost. Returns the text of the card. Throws EnvironmentError.
std::string publish_result(const std::string& dir, const CollageReport& report, const ResultSource& source,
                           bool finished);

}  // namespace tessera
