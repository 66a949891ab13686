#include "cli/erased_choice.h"

#include <algorithm>

#include "core/base/error.h"
#include "job/canvas/canvas_file.h"
#include "result/erased_pieces.h"
#include "result/folder/result_file.h"
#include "result/polygon_pieces.h"
#include "text/number_text.h"

namespace tessera::cli {
namespace {

/// The numbers as on the command line.
std::string text_of(const std::vector<float>& numbers) {
  std::string text;
  for (const float number : numbers) text += (text.empty() ? "" : ",") + fixed(number, 1);
  return text;
}

std::vector<int> numbered(const std::string& option, const std::vector<int>& given,
                          const std::vector<PlacedPiece>& all) {
  const std::vector<int> pieces = piece_numbers(option, given, all.size());
  for (const int i : pieces) {
    const PlacedPiece& piece = all[std::size_t(i)];
    if (!piece.locked) continue;
    throw InputError(option + ": found " + std::to_string(i) + ", \"" + piece.shape +
                     "\", which is locked; allowed: pieces without \"locked\" in pieces.geojson");
  }
  return pieces;
}

/// The pieces without locked ones, which always stay.
std::vector<int> without_locked(const std::string& option, std::vector<int> pieces,
                                const std::vector<PlacedPiece>& all) {
  const bool any = !pieces.empty();
  std::erase_if(pieces, [&](int i) { return all[std::size_t(i)].locked; });
  if (!pieces.empty()) return pieces;
  throw InputError(option + (any ? ": found locked pieces only" : ": found no piece") +
                   ", needed: one at least that is not locked");
}

std::vector<int> in_box(const std::string& option, const std::vector<float>& px, const Job& job,
                        const std::vector<PlacedPiece>& all) {
  const std::vector<int> found = pieces_in({{px[0], px[1]}, {px[0] + px[2], px[1] + px[3]}}, all);
  if (!found.empty()) return without_locked(option, found, all);
  const Canvas canvas = canvas_of(job);
  throw InputError(
      option + ": found no piece with its centre in it; the canvas is " + std::to_string(canvas.width_px) + " x " +
      std::to_string(canvas.height_px) +
      " px, and X,Y,W,H are px of the canvas, not of collage.png: \"x_px\" and \"y_px\" in pieces.geojson");
}

std::vector<int> under_mask(const std::string& mask, const std::string& folder, const Job& job) {
  constexpr double kWholly = 0.5;     // covered part of a piece
  constexpr double kNearlyAll = 0.9;  // part of all pieces
  const Canvas canvas = canvas_of(job);
  const ErasingMask marked = erasing_mask(mask, "--erase", canvas, path_in_result(folder, "collage.png"));
  const std::string file = path_in_result(folder, "pieces.geojson");
  const std::vector<JudgedPiece> pieces = read_polygon_pieces(file, canvas);
  const std::vector<int> touched = pieces_under(marked.cells, pieces, canvas);
  const std::size_t covered = pieces_under(marked.cells, pieces, canvas, kWholly).size();
  if (marked.is_opaque && covered > 1 && double(covered) >= kNearlyAll * double(pieces.size())) {
    throw InputError(
        "--erase " + mask + ": an opaque picture that covers " + std::to_string(covered) + " of " +
        std::to_string(pieces.size()) +
        " pieces; needed: marks over the pieces that are to go, on a transparent or plain page, or painted " +
        "over a copy of collage.png");
  }
  return touched;
}

}  // namespace

std::vector<int> piece_numbers(const std::string& option, std::vector<int> pieces, std::size_t count) {
  std::sort(pieces.begin(), pieces.end());
  pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());
  for (const int i : pieces) {
    if (i >= 0 && std::size_t(i) < count) continue;
    throw InputError(option + ": found " + std::to_string(i) +
                     ", allowed: " + (count > 0 ? "0 to " + std::to_string(count - 1) : "nothing") +
                     ", \"index\" of a piece in pieces.geojson");
  }
  return pieces;
}

std::vector<int> erased_pieces(const EraseArguments& arguments, const std::string& folder, const Job& job,
                               const std::vector<PlacedPiece>& all) {
  if (!arguments.pieces.empty()) return numbered("--pieces", arguments.pieces, all);
  if (!arguments.swapped.empty()) return numbered("--swap", arguments.swapped, all);
  if (!arguments.box_px.empty()) {
    return in_box("--box " + text_of(arguments.box_px), arguments.box_px, job, all);
  }
  return without_locked("--erase " + arguments.mask, under_mask(arguments.mask, folder, job), all);
}

}  // namespace tessera::cli
