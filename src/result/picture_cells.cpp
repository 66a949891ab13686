#include "result/picture_cells.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/field/field_lookup.h"

namespace tessera {
namespace {

constexpr double kMostCells = 1e6;

/// A straight colour laid on white.
WeightedColour on_white(const cv::Vec4b& bgra) {
  const float alpha = float(bgra[3]) / 255;
  const auto laid = [&](int channel) { return 255 + (float(bgra[channel]) - 255) * alpha; };
  return {{laid(2), laid(1), laid(0)}, 1};
}

/// The part of each cell that lies inside the canvas, from the distance of the cell's middle to the edge.
Grid<float> inside(const Canvas& canvas, int width, int height) {
  const FieldView distance(canvas.distance);
  const Vec2 cell_px{float(canvas.width_px) / float(width), float(canvas.height_px) / float(height)};
  Grid<float> parts(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float in_px = field_value(distance, {(float(x) + 0.5f) * cell_px.x, (float(y) + 0.5f) * cell_px.y});
      parts(x, y) = std::clamp(0.5f + in_px / std::min(cell_px.x, cell_px.y), 0.f, 1.f);
    }
  }
  return parts;
}

}  // namespace

cv::Size comparison_cells(cv::Size mosaic_px) {
  const double scale = std::min(1., std::sqrt(kMostCells / (double(mosaic_px.width) * mosaic_px.height)));
  const auto cells = [&](int px) { return std::clamp(int(std::lround(px * scale)), 1, px); };
  return {cells(mosaic_px.width), cells(mosaic_px.height)};
}

MosaicCells::MosaicCells(cv::Size picture_px)
    : means_(picture_px.width, picture_px.height, comparison_cells(picture_px).width,
             comparison_cells(picture_px).height) {}

void MosaicCells::write(const cv::Mat& rows) {
  std::vector<WeightedColour> pixels(std::size_t(rows.cols));
  for (int y = 0; y < rows.rows; ++y) {
    for (int x = 0; x < rows.cols; ++x) {
      if (rows.channels() == 4) {
        pixels[std::size_t(x)] = on_white(rows.at<cv::Vec4b>(y, x));
      } else {
        const cv::Vec3b& bgr = rows.at<cv::Vec3b>(y, x);
        pixels[std::size_t(x)] = {{float(bgr[2]), float(bgr[1]), float(bgr[0])}, 1};
      }
    }
    means_.add_row(pixels.data());
  }
}

Grid<Srgb> MosaicCells::cells() const {
  const Grid<WeightedColour> cells = means_.cells();
  Grid<Srgb> colours(cells.width(), cells.height());
  std::transform(cells.data().begin(), cells.data().end(), colours.data().begin(),
                 [](const WeightedColour& cell) { return cell.colour; });
  return colours;
}

Grid<WeightedColour> cells_of_picture(const cv::Mat& straight_bgra, cv::Size cells) {
  AreaMeans means(straight_bgra.cols, straight_bgra.rows, cells.width, cells.height);
  std::vector<WeightedColour> pixels(std::size_t(straight_bgra.cols));
  for (int y = 0; y < straight_bgra.rows; ++y) {
    const cv::Vec4b* row = straight_bgra.ptr<cv::Vec4b>(y);
    std::transform(row, row + straight_bgra.cols, pixels.begin(), [](const cv::Vec4b& bgra) {
      return WeightedColour{{float(bgra[2]), float(bgra[1]), float(bgra[0])}, float(bgra[3]) / 255};
    });
    means.add_row(pixels.data());
  }
  return means.cells();
}

PicturePair picture_pair(const Grid<Srgb>& mosaic, const Grid<WeightedColour>& picture, const Canvas* canvas) {
  const int width = mosaic.width(), height = mosaic.height();
  PicturePair pair{mosaic, Grid<Srgb>(width, height),
                   canvas ? inside(*canvas, width, height) : Grid(width, height, 1.f)};
  for (std::size_t i = 0; i < picture.data().size(); ++i) {
    pair.picture.data()[i] = picture.data()[i].colour;
    pair.weight.data()[i] *= picture.data()[i].weight;
  }
  return pair;
}

double width_in_pieces(const Canvas& canvas, std::size_t pieces) {
  return canvas.area_px2 > 0 ? canvas.width_px * std::sqrt(double(pieces) / canvas.area_px2) : 0;
}

}  // namespace tessera
