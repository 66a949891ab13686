#include "run/unplaced_pieces.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "core/base/count_text.h"
#include "core/collage/missing_pieces.h"
#include "core/collage/region_below.h"
#include "core/field/field_lookup.h"
#include "core/matching/sized_settings.h"
#include "core/matching/stances.h"
#include "core/matching/use_limits.h"
#include "job/job_tables.h"
#include "run/messages/collage_warnings.h"
#include "run/messages/place_advice.h"
#include "run/messages/written_keys.h"

namespace tessera {
namespace {

constexpr std::size_t kNamesTold = 6;
constexpr std::size_t kNamesAtATime = 4096;
constexpr LibraryParts kNamesOnly{.outline = false, .field = false, .levels = 0, .artwork = false};
constexpr LibraryParts kOutlineOnly{.outline = true, .field = false, .levels = 0, .artwork = false};

/// The settings with the smallest sizes that fit = "all" may choose.
CollageSettings smallest_sizes(const CollageSettings& first) {
  return with_sizes_times(double(least_size_factor(first.pieces)), first);
}

std::vector<std::uint32_t> all_regions(const CanvasProblem& problem) {
  std::vector<std::uint32_t> regions(std::max<std::size_t>(1, problem.canvas().regions.size()));
  std::iota(regions.begin(), regions.end(), 0);
  return regions;
}

std::vector<ShapeId> all_that_may_stand(const CanvasProblem& problem, const std::vector<std::uint32_t>& regions) {
  std::vector<ShapeId> shapes;
  const StanceTable whole(problem.settings(), std::uint32_t(problem.library().size()));
  for (const std::uint32_t region : regions) {
    const StanceTable table = whole.limited({.region = region});
    for (std::uint32_t i = 0; i < table.open_shapes(); ++i) shapes.push_back(table.open_shape(i));
  }
  std::sort(shapes.begin(), shapes.end());
  shapes.erase(std::unique(shapes.begin(), shapes.end()), shapes.end());
  return shapes;
}

std::vector<std::string> with_canvas(std::vector<std::string> advice, const CanvasProblem& problem,
                                     const WrittenKeys& keys) {
  if (problem.settings().match.tangent_dockings == 0) {
    advice.push_back("more " + keys.with_value("match", "tangent_dockings") +
                     ": without them nothing docks along straight sides");
  }
  const bool in_mm = problem.job().canvas.width_mm > 0;
  advice.push_back("a larger " + keys.with_value("canvas", in_mm ? "size_mm" : "size_px"));
  return advice;
}

/// The keys that make room. For shapes that fit alone, but not beside the other pieces.
std::vector<std::string> keys_that_make_room(const CollageSettings& settings, const WrittenKeys& keys,
                                             const UnplacedShapes& unplaced) {
  const PieceSettings& pieces = settings.pieces;
  std::vector<std::string> advice;
  if (pieces.fit_all) {
    if (!keys.is_default("pieces", "least_scale_px"))
      advice.push_back("smaller pieces, " + keys.with_value("pieces", "least_scale_px"));
  } else {
    advice.push_back("smaller pieces, " + where_sizes_stand(keys, settings.wishes, unplaced));
    if (may_fit_all(keys)) advice.push_back("pieces.fit = \"all\", which finds their sizes");
  }
  for (const char* key : {"padding_px", "apart_px"}) {
    if (!keys.is_default("pieces", key)) advice.push_back("less " + keys.with_value("pieces", key));
  }
  if (pieces.least_uses > 1) advice.push_back("fewer " + keys.with_value("pieces", "uses"));
  return advice;
}

/// The keys that keep all of these shapes out.
std::vector<std::string> what_keeps_out(const CanvasProblem& problem, const UnplacedShapes& unplaced) {
  return keys_that_keep_out(WrittenKeys(problem.job()), problem.job().canvas, smallest_sizes(problem.settings()),
                            problem.library(), problem.canvas(), unplaced);
}

std::vector<std::string> what_to_try(const CanvasProblem& problem, const UnplacedShapes& unplaced) {
  const WrittenKeys keys(problem.job());
  std::vector<std::string> advice = what_keeps_out(problem, unplaced);
  if (advice.empty()) advice = keys_that_make_room(problem.settings(), keys, unplaced);
  return with_canvas(std::move(advice), problem, keys);
}

std::string empty_warning(const CanvasProblem& problem, const std::string& folder,
                          const master::CollageResult& result) {
  const std::vector<std::uint32_t> regions = all_regions(problem);
  const UnplacedShapes all = {all_that_may_stand(problem, regions), regions};
  const bool is_full = !all.shapes.empty() && limit_that_ended(result.statistics).empty();
  return empty_result_warning(folder, WrittenKeys(problem.job()), result,
                              is_full ? what_to_try(problem, all) : std::vector<std::string>());
}

/// Whether the limit of pieces comes from refining a result that keeps its number of pieces; the user did not give it.
bool keeps_number_of_pieces(const StopSettings& stop, const RefinedResult* refined, const std::string& limit) {
  return refined != nullptr && limit == "pieces" && stop.pieces != refined->whole.job.settings.stop.pieces &&
         std::size_t(stop.pieces) == refined->whole.manifest.shapes.size();
}

std::string missing_warning(const CanvasProblem& problem, const master::CollageResult& result,
                            const std::vector<MissingShape>& missing, const RefinedResult* refined) {
  const WrittenKeys keys(problem.job());
  const PieceSettings& sizes = problem.settings().pieces;
  const std::uint64_t pieces = pieces_of(missing);
  const std::string what =
      count_text(pieces, "piece is", "pieces are") + " missing: " + missing_text(missing, kNamesTold) + "; ";
  if (const std::string limit = limit_that_ended(result.statistics); !limit.empty()) {
    if (keeps_number_of_pieces(problem.settings().stop, refined, limit))
      return what + refined->folder + " lacks them, too, and refining it like this adds no pieces";
    return what + keys.with_value("stop", limit.c_str()) + " ended the collage before they found a place";
  }
  UnplacedShapes unplaced{{}, all_regions(problem)};
  for (const MissingShape& shape : missing) unplaced.shapes.push_back(shape.id);
  const std::string tried =
      sizes.fit_all ? "no sizes down to " + keys.length_text(double(sizes.least_scale_px)) + " gave all a place"
                    : "they found no place";
  return what + tried + "; try " + joined_warnings(what_to_try(problem, unplaced));
}

/// Says for each class of shapes whether no piece of it stands, although the job gives it a size or rotation of its own and
/// wants no number of pieces.
std::vector<bool> absent_classes(const CanvasProblem& problem, const master::CollageResult& result) {
  const Wishes& wishes = problem.settings().wishes;
  const UseLimits uses(problem.settings().pieces, wishes);
  std::vector<bool> absent;
  for (const ShapeWish& wish : wishes.classes) {
    const bool has_own = !wish.poses.scale_px.empty() || !wish.poses.rotation_rad.empty();
    absent.push_back(wish.weight > 0 && has_own);
  }
  for (std::uint32_t i = 0; i < wishes.class_of_shape.size(); ++i) {
    if (uses.least(ShapeId{i}) > 0) absent[wishes.class_of_shape[i]] = false;
  }
  for (const Placement& p : result.placements) absent[wishes.class_of_shape[index_of(p.shape)]] = false;
  return absent;
}

std::string never_fitting_text(const CanvasProblem& problem, const std::vector<ShapeId>& shapes) {
  const std::vector<std::string> keys = what_keeps_out(problem, {shapes, all_regions(problem)});
  if (keys.empty()) return "";
  const std::size_t first = index_of(shapes.front());
  const std::string others = shapes.size() == 1 ? " fits" : " and " + count_text(shapes.size() - 1, "other") + " fit";
  return '"' + problem.library().read(first, first + 1, kNamesOnly).front().name + '"' + others +
         " nowhere on the canvas; try " + joined_warnings(keys);
}

std::vector<std::uint32_t> where_none(const std::vector<std::uint8_t>& has_piece) {
  std::vector<std::uint32_t> regions;
  for (std::uint32_t region = 0; region < has_piece.size(); ++region) {
    if (has_piece[region] == 0) regions.push_back(region);
  }
  return regions;
}

/// Regions in which no piece has its centre and no piece lies for the most part. Shapes are read only for the second test.
std::vector<std::uint32_t> regions_without_pieces(const CanvasProblem& problem, const master::CollageResult& result) {
  const Canvas& canvas = problem.canvas();
  std::vector<std::uint8_t> has_piece(canvas.regions.size());
  for (std::size_t region = 0; region < has_piece.size(); ++region) {
    const FieldView distance(canvas.regions[region].distance);
    has_piece[region] = std::any_of(result.placements.begin(), result.placements.end(), [&](const Placement& p) {
      return field_value(distance, p.canvas_from_shape.translation()) > 0;
    });
  }
  if (where_none(has_piece).empty()) return {};
  for (const Placement& p : result.placements) {
    const std::size_t i = index_of(p.shape);
    const Shape shape = std::move(problem.library().read(i, i + 1, kOutlineOnly).front());
    has_piece[region_below(canvas, shape.outline, p.canvas_from_shape)] = 1;
  }
  return where_none(has_piece);
}

std::string empty_region_text(const CanvasProblem& problem, const master::CollageResult& result, std::uint32_t region) {
  const WrittenKeys keys(problem.job());
  const std::string text = "nothing lies in the region \"" + rows_of(problem.job(), "regions")[region].at("name").text;
  if (const std::string limit = limit_that_ended(result.statistics); !limit.empty())
    return text + "\": " + keys.with_value("stop", limit.c_str()) + " ended the collage before it";
  const UnplacedShapes unplaced = {all_that_may_stand(problem, {region}), {region}};
  if (unplaced.shapes.empty())
    return text + "\": no shape may stand there by sizes, weights, regions and names of [[shapes]]";
  return text + "\"; try " + joined_warnings(what_to_try(problem, unplaced));
}

}  // namespace

std::string empty_regions_warning(const CanvasProblem& problem, const master::CollageResult& result) {
  constexpr std::size_t kMostTold = 4;
  const bool is_part = problem.found().room_part < 1;  // the rest of the canvas keeps its pieces
  if (result.unfinished || result.placements.empty() || problem.canvas().regions.size() < 2 || is_part) return "";
  const std::vector<std::uint32_t> empty = regions_without_pieces(problem, result);
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < std::min(empty.size(), kMostTold); ++i)
    warnings.push_back(empty_region_text(problem, result, empty[i]));
  if (empty.size() > kMostTold)
    warnings.push_back("and nothing lies in " + count_text(empty.size() - kMostTold, "other region"));
  return joined_warnings(warnings);
}

std::string never_fitting_warning(const CanvasProblem& problem, const master::CollageResult& result) {
  constexpr std::size_t kMostClasses = 8;  // each may take a tenth of a second
  const std::vector<std::uint32_t>& class_of_shape = problem.settings().wishes.class_of_shape;
  if (result.unfinished || result.placements.empty() || class_of_shape.empty()) return "";
  const std::vector<bool> absent = absent_classes(problem, result);
  std::map<std::uint32_t, std::vector<ShapeId>> shapes_of_class;
  for (const ShapeId shape : all_that_may_stand(problem, all_regions(problem))) {
    const std::uint32_t of = class_of_shape[index_of(shape)];
    if (absent[of]) shapes_of_class[of].push_back(shape);
  }
  std::size_t tried = 0;
  for (const auto& [of, shapes] : shapes_of_class) {
    if (const std::string text = never_fitting_text(problem, shapes); !text.empty()) return text;
    if (++tried == kMostClasses) break;
  }
  return "";
}

std::vector<MissingShape> missing_shapes(const CanvasProblem& problem, const master::CollageResult& result) {
  if (result.unfinished) return {};
  std::vector<MissingShape> named;
  std::vector<Shape> block;
  std::size_t begin = 0;
  for (const MissingPieces& missing :
       missing_pieces(problem.settings(), problem.library().drawings(), result.placements)) {
    const std::size_t i = index_of(missing.shape);
    if (i >= begin + block.size()) {
      begin = i / kNamesAtATime * kNamesAtATime;
      block = problem.library().read(begin, std::min(begin + kNamesAtATime, problem.library().size()), kNamesOnly);
    }
    named.push_back({missing.shape, block[i - begin].name, missing.wanted, missing.standing});
  }
  return named;
}

std::string unplaced_warning(const CollageInput& input, const master::CollageResult& result,
                             const std::vector<MissingShape>& missing, const RefinedResult* refined) {
  if (result.unfinished) return "";
  if (result.placements.empty()) return empty_warning(input.problem, input.folder, result);
  return missing.empty() ? "" : missing_warning(input.problem, result, missing, refined);
}

}  // namespace tessera
