#include "report/result_page.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/rank_pool.h"
#include "core/geometry/contour.h"
#include "core/quality/cell_counts.h"
#include "core/quality/gap_field.h"
#include "core/quality/shared_boundary.h"
#include "report/outline_codec.h"
#include "report/picture_block.h"
#include "result/card_bounds.h"
#include "result/card_input.h"
#include "result/folder/folder_name.h"
#include "result/folder/result_file.h"
#include "text/number_text.h"

namespace tessera {
namespace {

using Json = nlohmann::ordered_json;

/// Boundaries farther apart than this are not in contact at all.
constexpr float kReach_px = 4;
/// The gaps that a page shows: no smaller ones, and no more.
constexpr float kLeastGap_px = 1.5f;
constexpr std::size_t kMostGaps = 2000;

/// Numbers of texts in the order of their first use.
class NumberedTexts {
 public:
  std::size_t number_of(const std::string& text) {
    const auto [at, is_new] = numbers_.try_emplace(text, texts_.size());
    if (is_new) texts_.push_back(text);
    return at->second;
  }
  const std::vector<std::string>& texts() const { return texts_; }

 private:
  std::map<std::string, std::size_t> numbers_;
  std::vector<std::string> texts_;
};

template <class Value>
Json column(const std::vector<ShownPiece>& pieces, Value value) {
  Json numbers = Json::array();
  for (const ShownPiece& piece : pieces) numbers.push_back(value(piece));
  return numbers;
}

/// Shapes, groups and pieces of ResultData.
void add_pieces(const PlacedResult& result, Json& data) {
  NumberedTexts shapes, groups;
  std::vector<std::string> sources;
  const auto shape_of = [&](const ShownPiece& piece) {
    const std::size_t number = shapes.number_of(piece.shape);
    if (number == sources.size()) sources.push_back(piece.source);
    return number;
  };
  const auto group_of = [&](const ShownPiece& piece) {
    return piece.group.empty() ? -1 : int(groups.number_of(piece.group));
  };
  const auto measure = [&](double ShownPiece::*member, int decimals) {
    return column(result.pieces, [&](const ShownPiece& piece) { return rounded(piece.*member, decimals); });
  };
  Json pieces;
  pieces["shape"] = column(result.pieces, shape_of);
  pieces["group"] = column(result.pieces, group_of);
  pieces["x_px"] = measure(&ShownPiece::x_px, 2);
  pieces["y_px"] = measure(&ShownPiece::y_px, 2);
  pieces["scale_px"] = measure(&ShownPiece::scale_px, 2);
  pieces["rotation_deg"] = measure(&ShownPiece::rotation_deg, 2);
  pieces["score"] = measure(&ShownPiece::score, 4);
  pieces["matched_px"] = measure(&ShownPiece::matched_px, 1);
  pieces["mirrored"] = column(result.pieces, [](const ShownPiece& piece) { return int(piece.mirrored); });
  pieces["locked"] = column(result.pieces, [](const ShownPiece& piece) { return int(piece.locked); });
  Json areas = Json::array();
  for (const JudgedPiece& piece : result.outlines) areas.push_back(rounded(piece.scale_px * piece.scale_px, 1));
  pieces["area_px2"] = areas;
  data["shapes"] = {{"name", shapes.texts()}, {"source", sources}};
  data["groups"] = groups.texts();
  data["pieces"] = pieces;
  data["colours"] = result.whole.manifest.colours;
}

Json canvas_data(const Canvas& canvas) {
  return {{"width_px", canvas.width_px},
          {"height_px", canvas.height_px},
          {"area_px2", rounded(canvas.area_px2, 1)},
          {"repeats_x", canvas.period.x_px > 0},
          {"repeats_y", canvas.period.y_px > 0}};
}

Json gaps_data(const std::vector<GapDisc>& discs) {
  Json x = Json::array(), y = Json::array(), radius = Json::array();
  for (const GapDisc& disc : discs) {
    x.push_back(rounded(disc.centre_px.x, 2));
    y.push_back(rounded(disc.centre_px.y, 2));
    radius.push_back(rounded(disc.radius_px, 2));
  }
  return {{"x_px", x}, {"y_px", y}, {"radius_px", radius}};
}

/// card.json as it is; null where there is none, or a damaged one.
Json card_data(const std::string& folder) {
  try {
    const Json card = Json::parse(read_result_json(folder, "card.json", kCardBounds), nullptr, false);
    return card.is_object() ? card : Json();
  } catch (const InputError&) {
    return {};
  }
}

/// The card's record of the coverage by time; empty lists where it has none.
Json progress_data(const Json& card) {
  const auto growth = card.is_object() ? card.find("growth") : card.end();
  if (growth != card.end() && growth->is_object() && growth->contains("s") && growth->contains("coverage_fraction")) {
    return {{"s", (*growth)["s"]}, {"coverage", (*growth)["coverage_fraction"]}};
  }
  return {{"s", Json::array()}, {"coverage", Json::array()}};
}

bool is_rectangle(const Canvas& canvas) {
  return !canvas.has_zones() && canvas.area_px2 >= double(canvas.width_px) * canvas.height_px - 0.5;
}

/// The outlines of the region to fill. The field is shifted, as contours() closes curves only at levels above 0.
std::vector<std::vector<Vec2>> region_of(const Canvas& canvas) {
  constexpr float kShift = 2;
  Grid<float> distance = canvas.distance.value;
  for (float& value : distance.data()) value = std::clamp(value, -kShift, kShift) + kShift;
  std::vector<std::vector<Vec2>> rings = contours(distance, kShift);
  for (std::vector<Vec2>& ring : rings) {
    for (Vec2& p : ring) p = p + canvas.distance.origin;
  }
  return rings;
}

void add_blocks(const PlacedResult& result, std::vector<PageBlock>& blocks) {
  const std::vector<float> distances = boundary_distances_px(result.canvas, result.outlines, kReach_px);
  PieceBlocks pieces = piece_blocks(result.outlines, distances, kReach_px);
  blocks.push_back({"outlines", std::move(pieces.outlines)});
  blocks.push_back({"contact", std::move(pieces.contact)});
  if (is_rectangle(result.canvas)) return;
  std::vector<std::uint8_t> region;
  append_outline(region_of(result.canvas), region);
  blocks.push_back({"canvas", std::move(region)});
}

}  // namespace

Page result_page(const std::string& folder, const ResultPageSettings& settings) {
  const PlacedResult result = read_placed_result(folder);
  Page page{.title = folder_name(folder), .json = {}, .blocks = {}, .warnings = {}};
  Json data;
  data["format"] = kPageFormat;
  data["kind"] = "result";
  data["name"] = page.title;
  data["folder"] = folder;
  data["program"] = made_by(folder);
  data["pieces_digest"] = result.whole.manifest.pieces_digest;
  data["finished"] = result.whole.manifest.finished;
  data["canvas"] = canvas_data(result.canvas);
  data["picture"] = picture_data(folder, result.whole, 0, settings.picture_bytes, page);
  add_pieces(result, data);
  data["gaps"] = gaps_data(
      gap_discs(gap_field(count_cells(result.canvas, result.outlines), result.canvas.period), kLeastGap_px, kMostGaps));
  data["card"] = card_data(folder);
  data["progress"] = progress_data(data["card"]);
  data["job"] = read_result_file(folder, "job.toml");
  data["served"] = settings.served;
  add_blocks(result, page.blocks);
  page.json = data.dump(-1, ' ', false, Json::error_handler_t::replace);
  return page;
}

}  // namespace tessera
