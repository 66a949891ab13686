// A photo's layout on a coarse grid: which element each cell shows.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "products/texture/texture_layout.h"

namespace tessera {

// The number of a cell of the photo says what it shows: the index of an element, plus 1, or one of these.
inline constexpr int kGroundCell = 0;
inline constexpr int kCutCell = -1;

struct CellElement {
  int area = 0;      // cells
  cv::Point corner;  // of its mask
  cv::Mat mask;      // CV_8U: kElementCell, kRoomCell or 0
  cv::Point middle;  // of its box
};

// A mask's cells of the element itself, and those of the joint round it. The numbers are what it costs that another element
// lies there.
inline constexpr std::uint8_t kElementCell = 2;
inline constexpr std::uint8_t kRoomCell = 1;

// A run of cells shows one thing: ground, something cut, or an element. The number of an element's thing is its index plus
// kFirstElement.
inline constexpr int kGroundThing = 0, kCutThing = 1, kFirstElement = 2;

struct CellRun {
  int length;  // the cells from this one that show the same
  int slot;    // twice the thing, plus 1 for the joint round an element
};

struct PhotoCells {
  cv::Size2d cell_px;       // a whole number of them for each pitch of rows or columns
  double element_side = 0;  // of a mean element, cells
  cv::Mat cells;            // CV_32S
  cv::Mat rooms;            // CV_32S: of ground in the joint round an element: the element's index, plus 1; else 0
  cv::Mat runs;             // CV_32SC2: the CellRun that begins at each cell
  double ground_part = 0;   // of the photo where elements lie close together
  std::vector<CellElement> elements;
};

/// Each cell shows what lies at its middle in the photo. `photo` has elements.
PhotoCells photo_cells(const PhotoLayout& photo);

}  // namespace tessera
