// sawn_pieces FOLDER NEW_FOLDER PX SCALE: makes pieces of a puzzle (PNGs with transparency) look sawn and scanned. They lose PX px all
// round, then are scaled by SCALE.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <opencv2/imgproc.hpp>

#include "support/images.h"

namespace fs = std::filesystem;

int main(int argc, char** argv) {
  if (argc != 5) {
    std::fprintf(stderr, "sawn_pieces FOLDER NEW_FOLDER PX SCALE\n");
    return 2;
  }
  const int lost_px = std::atoi(argv[3]);
  const double scale = std::atof(argv[4]);
  fs::create_directories(argv[2]);
  for (const fs::directory_entry& entry : fs::directory_iterator(argv[1])) {
    cv::Mat piece = tessera::test::read_image(entry.path().string()), alpha;
    if (piece.type() != CV_8UC4) return 1;
    cv::extractChannel(piece, alpha, 3);
    const cv::Mat disc = cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * lost_px + 1, 2 * lost_px + 1});
    cv::erode(alpha, alpha, disc, {-1, -1}, 1, cv::BORDER_CONSTANT, 0);
    cv::insertChannel(alpha, piece, 3);
    cv::resize(piece, piece, {}, scale, scale, cv::INTER_AREA);
    if (!tessera::test::write_image((fs::path(argv[2]) / entry.path().filename()).string(), piece)) return 1;
  }
}
