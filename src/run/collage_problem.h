// What a run is to do, resolved once from its job: shapes, wishes, sizes, limits. Every rank of tessera collage goes by
// it, and so does tessera plan. The sizes in the job are those of its file, for messages and for what is written.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/field/canvas.h"
#include "job/canvas/overlays.h"
#include "job/job_file.h"
#include "library/library_view.h"

namespace tessera {

/// What the canvas decides about the whole problem. Workers read no canvas: rank 0 tells them this.
struct CanvasFindings {
  double size_factor = 1;  // times all sizes; 1 but where every shape is to have a place (pieces.fit)
  double room_part = 1;    // of the canvas, that is filled: less than all where pieces are removed
  Overlays overlays = {};
};

/// The same on every rank, but for the pieces that the job starts from: only who places pieces needs them.
class CollageProblem {
 public:
  /// `job`: its wishes are resolved by the shapes of `library`. Throws InputError as set_overlays does.
  CollageProblem(Job job, LibraryView library, CanvasFindings found);

  const Job& job() const { return job_; }
  const LibraryView& library() const { return library_; }
  const CanvasFindings& found() const { return found_; }
  /// The sizes are those of the first attempt, and improving takes as large a part as the room that is filled.
  const CollageSettings& settings() const { return settings_; }

 private:
  Job job_;
  LibraryView library_;
  CanvasFindings found_;
  CollageSettings settings_;
};

/// The problem with its canvas, as rank 0 and tessera plan read it.
class CanvasProblem : public CollageProblem {
 public:
  /// Reads and checks the files that the job names before anything costs time. Throws InputError that names the file or
  /// key, what was found and what is allowed.
  explicit CanvasProblem(Job raw);

  /// Where pieces are removed (start.remove) only their room is to be filled, and as far round it as a gap may be that
  /// nothing fits into.
  const Canvas& canvas() const { return canvas_; }
  /// Of the canvas as a whole (checkpoint_origin.h).
  std::uint64_t canvas_digest() const { return canvas_digest_; }
  /// The job's, of a canvas with a size on paper as large as that (on_paper).
  const OutputSpec& output() const { return output_; }
  /// Of silhouettes, "#rrggbb".
  const std::vector<std::string>& palette() const { return palette_; }

 private:
  struct Read;
  explicit CanvasProblem(Read read);

  Canvas canvas_;
  std::uint64_t canvas_digest_;
  OutputSpec output_;
  std::vector<std::string> palette_;
};

}  // namespace tessera
