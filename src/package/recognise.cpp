#include "tessera/matching/recognise.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/rank_pool.h"
#include "package/forked_process.h"
#include "package/hdf5_turn.h"
#include "package/known_shape.h"
#include "package/library_state.h"
#include "package/number_in_message.h"
#include "package/prepared_curves.h"
#include "package/translated_errors.h"
#include "recognition/answer_score.h"
#include "recognition/library_lots.h"

namespace tessera::matching {

struct KnownOutlines::State {
  PadParameters pad;
  std::vector<KnownShapes> lots;           // lots_of() the outlines
  std::vector<tessera::Outline> outlines;  // shape frames
  std::vector<Similarity> shape_from_own;
  /// The unit in which the core's floats count the sizes of known outlines: 1 px of a library's drawings, or the geometric
  /// middle of the outlines' sizes.
  double unit = 1;
  std::string no_scale;  // why no scale may be given; empty where one may
};

namespace {

/// Limit of a query's scale, by the sizes of outlines (1e-100 to 1e15).
constexpr double kLargestScale = 1e120;
/// Known outlines whose sizes differ by a larger factor have no unit of length that suits floats.
constexpr double kMostSizeRatio = 1e20;
/// Prepared units for one unit of the known outlines. Beyond these limits an outline of 1e-10 to 1e10 units is much smaller
/// than a point of the query, or much larger than the query.
constexpr double kLeastPreparedUnit = 1e-12;
constexpr double kMostPreparedUnit = 1e22;

KnownShape known_shape(const std::vector<Outline>& outlines, std::size_t i) {
  try {
    return make_known_shape(outlines[i]);
  } catch (const Error& error) {
    throw Error("outline " + std::to_string(i) + ": " + error.what());
  }
}

void check_scale(double scale) {
  if (scale > 1 / kLargestScale && scale < kLargestScale) return;
  throw Error("scale: found " + number_in_message(scale) + ", allowed: above 1e-120 and below 1e120");
}

/// The sizes of outlines: own units for one unit of the shape's frame.
struct Sizes {
  std::vector<double> of_each;
  double least = 0;
  double most = 0;

  explicit Sizes(const std::vector<KnownShape>& shapes) {
    for (const KnownShape& shape : shapes) of_each.push_back(1 / shape.shape_from_own.scale());
    const auto [smallest, largest] = std::minmax_element(of_each.begin(), of_each.end());
    least = *smallest;
    most = *largest;
  }
  /// The geometric middle of the sizes: it has the same factor to the least and to the largest size.
  double unit() const { return std::sqrt(least) * std::sqrt(most); }
};

std::string why_no_scale(const Sizes& sizes) {
  if (sizes.most <= kMostSizeRatio * sizes.least) return "";
  return "scale: found known outlines of which the largest is " + number_in_message(sizes.most / sizes.least) +
         " times as large as the smallest, allowed with a scale: 1e20 times";
}

/// The curves, with the open ones in the other direction.
std::vector<tessera::Curve> turned_round(std::vector<tessera::Curve> curves) {
  for (tessera::Curve& curve : curves) {
    if (!curve.closed) std::reverse(curve.points.begin(), curve.points.end());
  }
  return curves;
}

/// The query in both directions of its open curves; only one query where all curves are closed.
std::vector<tessera::Query> prepared_queries(const PreparedCurves& prepared, const PadParameters& pad) {
  const QuerySettings settings{.pad = pad, .least_sigma = prepared.least_sigma, .without_noise = true};
  std::vector<tessera::Query> queries;
  queries.emplace_back(prepared.curves, settings);
  const std::vector<tessera::Curve> other_way = turned_round(prepared.curves);
  if (other_way != prepared.curves) queries.emplace_back(other_way, settings);
  return queries;
}

}  // namespace

KnownOutlines::KnownOutlines(const std::vector<Outline>& outlines) : state_(std::make_unique<State>()) {
  with_errors_translated([&] {
    check_threads_are_own();
    if (outlines.empty()) throw Error("no known outlines; allowed: 1 or more");
    std::vector<KnownShape> made(outlines.size());
    parallel_for(made.size(), [&](std::size_t i) { made[i] = known_shape(outlines, i); });
    const Sizes sizes(made);
    state_->no_scale = why_no_scale(sizes);
    if (state_->no_scale.empty()) state_->unit = sizes.unit();
    for (const ShapeRange& lot : lots_of(made.size(), shapes_of_lot(made.size()))) {
      std::vector<ShapeModel> models;
      std::vector<float> sizes_in_units;  // 0: unknown
      for (std::size_t i = lot.begin; i < lot.end; ++i) {
        models.push_back(std::move(made[i].model));
        sizes_in_units.push_back(state_->no_scale.empty() ? float(sizes.of_each[i] / state_->unit) : 0);
      }
      state_->lots.emplace_back(ShapeId(lot.begin), std::move(models), std::move(sizes_in_units), state_->pad.levels);
    }
    for (KnownShape& shape : made) {
      state_->outlines.push_back(std::move(shape.outline));
      state_->shape_from_own.push_back(shape.shape_from_own);
    }
  });
}

KnownOutlines::KnownOutlines(const Library& library) : state_(std::make_unique<State>()) {
  with_errors_translated([&] {
    check_threads_are_own();
    const Hdf5Turn turn;
    const LibraryFile& file = library.state_->file;
    state_->pad = file.pad_parameters();
    for (const ShapeRange& range : lots_of(file.size(), shapes_of_lot(file.size()))) {
      state_->lots.push_back(read_lot(file, range));
      const LibraryParts outlines{.outline = true, .field = false, .levels = 0, .artwork = false};
      for (Shape& shape : file.read(range.begin, range.end, outlines)) {
        state_->outlines.push_back(std::move(shape.outline));
        state_->shape_from_own.push_back({});
        if (shape.drawn_scale_px > 0) continue;
        state_->no_scale = "scale: the library does not know how large its shapes were drawn";
      }
    }
  });
}

KnownOutlines::~KnownOutlines() = default;
KnownOutlines::KnownOutlines(KnownOutlines&&) noexcept = default;
KnownOutlines& KnownOutlines::operator=(KnownOutlines&&) noexcept = default;

std::size_t KnownOutlines::size() const { return state_->outlines.size(); }

std::vector<Recognised> KnownOutlines::recognise(const Outline& query, const RecogniseSettings& settings) const {
  return with_errors_translated([&] {
    check_threads_are_own();
    const PreparedCurves prepared = prepared_curves(query);
    RecognitionSettings core_settings{.query_per_drawn_px = {}, .most = std::min(settings.most, size())};
    if (settings.scale) {
      check_scale(*settings.scale);
      if (!state_->no_scale.empty()) throw Error(state_->no_scale);
      const double unit = prepared.prepared(*settings.scale * state_->unit);
      if (!(unit > kLeastPreparedUnit && unit < kMostPreparedUnit)) return std::vector<Recognised>{};
      core_settings.query_per_drawn_px = float(unit);
    }
    const OutlineOf outline_of = [&](ShapeId id) { return state_->outlines[index_of(id)]; };
    std::vector<Recognition> best;
    for (const tessera::Query& way : prepared_queries(prepared, state_->pad)) {
      std::vector<Recognition> of_way;
      for (const KnownShapes& lot : state_->lots) {
        keep_best(of_way, recognised(way, lot, core_settings, outline_of), core_settings.most);
      }
      best.insert(best.end(), of_way.begin(), of_way.end());
    }
    best = best_of_each(std::move(best));
    best.resize(std::min(best.size(), core_settings.most));
    std::vector<Recognised> result;
    for (const Recognition& found : best) {
      const std::size_t known = index_of(found.shape);
      result.push_back(
          {known, found.similarity, answer_score(found, state_->outlines[known]),
           prepared.own_from_prepared * to_public(found.query_from_shape) * state_->shape_from_own[known]});
    }
    return result;
  });
}

}  // namespace tessera::matching
