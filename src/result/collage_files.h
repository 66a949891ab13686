// Writes the files of a run into its folder: pieces, quality card, effective job, manifest. The pictures are made from
// these.
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

/// Changes of a piece's colours: a patch is laid over the piece, then its hues are turned.
struct Tone {
  TonePatch patch;   // tone_patch.h
  int turn_deg = 0;  // hue_turns.h
};

/// All data from which pieces.geojson and the pictures are made. The shapes have outline, field, thumbnail and, for
/// pictures, the embedded original.
struct CollageReport {
  OutputSpec output;  // of the pictures (on_paper)
  CanvasSpec box;     // for pictures: the canvas' bounding box in px and on paper (shrink_box_to_page)
  const Canvas* canvas = nullptr;
  CanvasEdge canvas_edge;   // for pictures
  KeepOutDrawing keep_out;  // for pictures; mostly none
  GroundTile ground;        // for pictures; mostly none
  GroundTile overlay;       // for pictures, over everything else, with overlay_opacity; mostly none
  double overlay_opacity = 0;
  std::vector<Placement> placements;
  PlacedShapes shapes;
  std::vector<std::string> groups;          // of the placements (shape_groups), "" for none; empty: no groups
  std::vector<bool> locked;                 // of the placements, for good (GivenPiece::for_good); empty: none
  std::optional<DeformedCollage> deformed;  // then each piece has its own shape (deformed_collage.h)
  std::vector<std::string> colours;         // of the placements, "#rrggbb": draws silhouettes; empty: draws the artwork
  std::vector<std::string> covered;         // of the placements: covered_colours (tones.h); empty: no picture is shown
  std::vector<Tone> tones;                  // of the placements; empty: the colours of the drawings
  double shift = 0;                         // largest difference of a tone from the drawing, CIEDE2000
  std::vector<StyleFeatures> styles;        // of the placements' drawings; empty: unknown
  std::optional<Harmony> harmony;           // the harmony of the turned hues
  std::vector<MissingShape> missing;        // of a finished collage
  RunStatistics statistics;
  RankStatistics ranks;
  RunRecord record;

  /// The shape of a placed piece. Throws std::out_of_range where the shape was not placed.
  const Shape& shape(ShapeId id) const { return shapes[shapes.slot_of(id)]; }
};

/// The job that a result comes from.
struct ResultSource {
  CheckpointOrigin origin;
  std::string library;             // library_text
  std::string start;               // start_file; empty: it began without a result
  std::uint64_t start_digest = 0;  // StartSpec::digest
  std::optional<SizeRange> sizes;  // wished_sizes
  CardSettings card;
  std::shared_ptr<const std::vector<std::uint8_t>> shown_png;  // Job::shown_png
};

/// Creates `dir` and proves that files can be written there. To be called before the work. Throws EnvironmentError.
void prepare_output_directory(const std::string& dir);

/// Throws EnvironmentError where a file of a result cannot be written in `dir`, for example because a folder has its name.
void check_can_be_published(const std::string& dir);

/// Throws InputError where `dir` holds files with names of a result's files that no run of this program left there, or the
/// job file that is about to be run. A result would replace them.
void check_nothing_foreign_is_replaced(const std::string& dir, const std::string& job_file);

/// Makes the run's placements the result in `dir`. After a crash at any moment the folder holds either its checkpoints or a
/// whole result. First it removes the manifest of the run before, and its pictures. Then it writes pieces.geojson,
/// job.toml, card.json and card.txt, each under a temporary name that is then renamed. It writes manifest.json last, when
/// the others are on the disk. For an unfinished result the manifest comes before the cards: measuring for the cards takes
/// a second on a large canvas, and mpirun kills two seconds after Ctrl-C. It draws nothing (result_drawing.h). Where the
/// work must not be lost, there must be a checkpoint before the call. Returns the text of the card. Throws
/// EnvironmentError.
std::string publish_result(const std::string& dir, const CollageReport& report, const ResultSource& source,
                           bool finished);

}  // namespace tessera
