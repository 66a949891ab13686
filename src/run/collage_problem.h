// The problem of a run, resolved once from its job: shapes, wishes, sizes, limits. Every rank of tessera collage uses it,
// and so does tessera plan. The sizes in `job()` are those of its file, for messages and output.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/field/canvas.h"
#include "job/canvas/overlays.h"
#include "job/job_file.h"
#include "library/library_view.h"

namespace tessera {

/// The part of the problem that the canvas decides. Workers read no canvas: rank 0 sends them this.
struct CanvasFindings {
  double size_factor = 1;  // multiplies all sizes; 1 unless every shape needs a place (pieces.fit)
  double room_part = 1;    // part of the canvas that is filled; below 1 where pieces are removed
  Overlays overlays = {};
};

/// The problem, the same on every rank but for the pieces that the job starts from: only the master needs these.
class CollageProblem {
 public:
  /// Resolves the wishes of `job` by the shapes of `library`. Throws InputError as set_overlays does.
  CollageProblem(Job job, LibraryView library, CanvasFindings found);

  const Job& job() const { return job_; }
  const LibraryView& library() const { return library_; }
  const CanvasFindings& found() const { return found_; }
  /// The settings with the sizes of the first attempt. Improving is reduced to the part of the canvas that is filled.
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
  /// Reads and checks the files that the job names, before anything costs time. Throws InputError that names the file or
  /// key, what was found and what is allowed.
  explicit CanvasProblem(Job raw);

  /// The canvas to be filled. Where pieces are removed (start.remove), that is only their room and a margin around it, as
  /// wide as the gaps that no piece fits into.
  const Canvas& canvas() const { return canvas_; }
  /// The digest of the whole canvas (checkpoint_origin.h).
  std::uint64_t canvas_digest() const { return canvas_digest_; }
  /// The job's output settings. For a canvas with a size on paper they have that size (on_paper).
  const OutputSpec& output() const { return output_; }
  /// The palette for silhouettes, "#rrggbb".
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
