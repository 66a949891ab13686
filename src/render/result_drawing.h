// The pictures of a result, made from the files in its folder and from the library: tessera draw, and the end of
// tessera collage.
#pragma once

#include <string>
#include <vector>

#include "render/pieces/stop_watcher.h"
#include "result/drawing_notes.h"

namespace tessera {

/// What is not given is as the result's job says.
struct PictureRequest {
  std::vector<std::string> keys;     // "output.key=value" or "colour.key=value", a later one wins
  std::string to;                    // another folder for the pictures; empty: that of the result
  std::vector<std::string> library;  // where its files are now; empty: as in the job
  bool png = false;
  bool svg = false;
  bool pdf = false;
  bool tiff = false;
};

/// Draws collage.svg, collage.png (and with it labels.png, where the job has output.labels), collage.pdf and
/// collage.tiff, as many as are wanted, into `dir`, and writes into the cards and the manifest what was drawn, and how
/// well pixels show colour.image from afar; or into PictureRequest::to, a folder that is there, and the result in `dir`
/// stays as it is. Each picture appears whole or not at all; the same result gives the same bytes. A finished and an
/// unfinished result are drawn alike. Throws InputError where `dir` holds no result, or where library or canvas are not
/// those that it was made with, or where a key is wrong; EnvironmentError; DrawingStopped (drawers.h): then the
/// pictures done so far are there.
DrawingNotes draw_result(const std::string& dir, const PictureRequest& request, DrawingObserver& observer);

}  // namespace tessera
