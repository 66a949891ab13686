#include "core/colour/seen_from_afar.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/colour/ciede2000.h"
#include "core/colour/ssim.h"

namespace tessera {
namespace {

Grid<WeightedColour> reduced(const Grid<Srgb>& picture, const Grid<float>& weight, int width, int height) {
  AreaMeans means(picture.width(), picture.height(), width, height);
  std::vector<WeightedColour> row(std::size_t(picture.width()));
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) row[std::size_t(x)] = {picture(x, y), weight(x, y)};
    means.add_row(row.data());
  }
  return means.cells();
}

Grid<float> greys_of(const Grid<WeightedColour>& cells) {
  Grid<float> greys(cells.width(), cells.height());
  std::transform(cells.data().begin(), cells.data().end(), greys.data().begin(),
                 [](const WeightedColour& cell) { return grey_of(cell.colour); });
  return greys;
}

Grid<float> weights_of(const Grid<WeightedColour>& cells) {
  Grid<float> weights(cells.width(), cells.height());
  std::transform(cells.data().begin(), cells.data().end(), weights.data().begin(),
                 [](const WeightedColour& cell) { return cell.weight; });
  return weights;
}

/// The weighted mean colour difference; NaN if no cell has weight.
double mean_difference(const Grid<WeightedColour>& mosaic, const Grid<WeightedColour>& picture) {
  double sum = 0, weights = 0;
  for (std::size_t i = 0; i < mosaic.data().size(); ++i) {
    const double weight = double(mosaic.data()[i].weight);
    if (!(weight > 0)) continue;
    const Lab seen = lab_from_srgb(mosaic.data()[i].colour), wanted = lab_from_srgb(picture.data()[i].colour);
    sum += weight * double(ciede2000(seen, wanted));
    weights += weight;
  }
  return sum / weights;
}

}  // namespace

std::optional<AfarFigures> figures_from_afar(const PicturePair& pair, int width_px) {
  AfarFigures figures;
  const int cells_width = pair.mosaic.width(), cells_height = pair.mosaic.height();
  figures.width_px = std::clamp(width_px, 1, cells_width);
  const double height_px = double(cells_height) * figures.width_px / cells_width;
  figures.height_px = std::clamp(int(std::lround(height_px)), 1, cells_height);
  const Grid<WeightedColour> mosaic = reduced(pair.mosaic, pair.weight, figures.width_px, figures.height_px);
  const Grid<WeightedColour> picture = reduced(pair.picture, pair.weight, figures.width_px, figures.height_px);
  figures.colour_difference = mean_difference(mosaic, picture);
  if (std::isnan(figures.colour_difference)) return {};
  figures.structure = ssim(greys_of(mosaic), greys_of(picture), weights_of(picture));
  return figures;
}

std::optional<SeenFromAfar> seen_from_afar(const PicturePair& pair, double width_in_pieces) {
  const auto at_100_px = figures_from_afar(pair, kAfarWidth_px);
  if (!at_100_px) return {};
  SeenFromAfar seen{*at_100_px, {}};
  if (width_in_pieces > 0) {
    const double most = double(pair.mosaic.width());
    seen.at_piece_size = figures_from_afar(pair, int(std::lround(std::min(width_in_pieces, most))));
  }
  return seen;
}

}  // namespace tessera
