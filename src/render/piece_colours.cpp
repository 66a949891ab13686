#include "render/piece_colours.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <string_view>

#include "artwork/images/colour_conversion.h"
#include "core/base/digest.h"
#include "core/colour/ciede2000.h"
#include "core/field/piece_distance.h"
#include "library/one_colour.h"

namespace tessera {
namespace {

constexpr float kBesideReach = 0.2f;     // of the smaller scale of two; a smaller gap looks closed
constexpr std::size_t kPointStride = 8;  // of the 512 points of an outline

struct Piece {
  const Shape* shape;
  Similarity canvas_from_shape;
  std::vector<Vec2> points_px;  // of its outer curve
};

Piece make_piece(const Placement& placement, const Shape& shape) {
  Piece piece{&shape, placement.canvas_from_shape, {}};
  const std::vector<Vec2>& outer = shape.outline.curves.front();
  for (std::size_t i = 0; i < outer.size(); i += kPointStride)
    piece.points_px.push_back(placement.canvas_from_shape.apply(outer[i]));
  return piece;
}

bool comes_near(const Piece& piece, const Piece& other, float reach_px) {
  const PieceDistance distance(*other.shape, other.canvas_from_shape, 0);
  return std::any_of(piece.points_px.begin(), piece.points_px.end(),
                     [&](Vec2 point) { return distance.at(point) < reach_px; });
}

/// Whether the pieces are near to each other. One may be long and bend round the other, so both are tested.
bool are_neighbours(const Piece& a, const Piece& b, float padding_px) {
  const float scale_a = a.canvas_from_shape.scale(), scale_b = b.canvas_from_shape.scale();
  const float reach_px = padding_px + kBesideReach * std::min(scale_a, scale_b);
  const float most_px = a.shape->radius * scale_a + b.shape->radius * scale_b + reach_px;
  const Vec2 apart = a.canvas_from_shape.translation() - b.canvas_from_shape.translation();
  return dot(apart, apart) < most_px * most_px && (comes_near(a, b, reach_px) || comes_near(b, a, reach_px));
}

/// The palette in a random order that depends on the piece.
std::vector<std::size_t> drawn_by_lot(const Piece& piece, std::size_t colours) {
  Digest digest;
  digest.add_all(std::span<const char>(std::string_view(piece.shape->name)));
  const Similarity& pose = piece.canvas_from_shape;
  for (const float part : {pose.a, pose.b, pose.tx, pose.ty}) digest.add(std::bit_cast<std::uint32_t>(part));
  std::vector<std::size_t> order(colours);
  std::iota(order.begin(), order.end(), std::size_t(0));
  for (std::size_t left = colours; left > 1; --left) {
    digest.add(left);
    std::swap(order[left - 1], order[std::size_t(digest.value() % left)]);
  }
  return order;
}

/// The colour of the last piece; the pieces before it have chosen theirs.
std::size_t unlike_neighbours(const std::vector<Piece>& pieces, const std::vector<std::size_t>& chosen,
                              std::size_t colours, float padding_px) {
  const Piece& piece = pieces.back();
  std::vector<int> beside(colours);
  for (std::size_t i = 0; i < chosen.size(); ++i) beside[chosen[i]] += are_neighbours(piece, pieces[i], padding_px);
  const std::vector<std::size_t> order = drawn_by_lot(piece, colours);
  return *std::min_element(order.begin(), order.end(),
                           [&](std::size_t a, std::size_t b) { return beside[a] < beside[b]; });
}

std::size_t nearest_to(const std::string& wanted, const std::vector<std::string>& palette) {
  const Lab there = lab_of(bgr_of(wanted));
  std::vector<float> differences;
  for (const std::string& colour : palette) differences.push_back(ciede2000(there, lab_of(bgr_of(colour))));
  return std::size_t(std::min_element(differences.begin(), differences.end()) - differences.begin());
}

}  // namespace

bool draws_palette(const ColourSpec& colour, const ShapeLibrary& library) {
  return colour.pieces == "palette" || (colour.pieces == "auto" && colour.image.empty() && is_of_one_colour(library));
}

std::vector<std::string> piece_colours(const CollageReport& report, const std::vector<Placement>& placements,
                                       const std::vector<std::string>& palette, float padding_px) {
  std::vector<Piece> pieces;
  std::vector<std::size_t> chosen;
  for (const Placement& placement : placements) {
    const std::string wanted = report.covered.empty() ? "" : report.covered[pieces.size()];
    pieces.push_back(make_piece(placement, report.shape(placement.shape)));
    chosen.push_back(wanted.empty() ? unlike_neighbours(pieces, chosen, palette.size(), padding_px)
                                    : nearest_to(wanted, palette));
  }
  std::vector<std::string> colours;
  for (const std::size_t c : chosen) colours.push_back(palette[c]);
  return colours;
}

}  // namespace tessera
