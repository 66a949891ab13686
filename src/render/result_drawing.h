// Draws the pictures of a result from the files in its folder and from the library, for tessera draw and the end of tessera
// collage.
#pragma once

#include <string>
#include <vector>

#include "render/pieces/stop_watcher.h"
#include "result/drawing_notes.h"

namespace tessera {

/// The pictures to draw. What is not given here is as in the result's job.
struct PictureRequest {
  std::vector<std::string> keys;     // "output.key=value" or "colour.key=value"; later ones win
  std::string to;                    // another folder for the pictures; empty: the result's
  std::vector<std::string> library;  // the present paths of its files; empty: as in the job
  bool png = false;
  bool svg = false;
  bool pdf = false;
  bool tiff = false;
};

/// Draws the wanted ones of collage.svg, collage.png (with labels.png where the job has output.labels), collage.pdf and
/// collage.tiff into `dir`. Then it writes into the cards and the manifest what was drawn, and how well pixels show
/// colour.image from afar. With PictureRequest::to, an existing folder, it draws there, and the result in `dir` stays
/// unchanged. Each picture appears whole or not at all. The same result gives the same bytes. Unfinished results are drawn
/// like finished ones. Throws InputError where `dir` holds no result, library or canvas have changed since, or a key is
/// wrong; EnvironmentError; and DrawingStopped (drawers.h), after which the pictures done so far are there.
DrawingNotes draw_result(const std::string& dir, const PictureRequest& request, DrawingObserver& observer);

}  // namespace tessera
