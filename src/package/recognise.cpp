#include "tessera/matching/recognise.h"

#include <algorithm>
#include <utility>

#include "core/base/rank_pool.h"
#include "core/pad/pad_index.h"
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
  std::vector<KnownShapes> lots;           // of kSegmentShapes each
  std::vector<tessera::Outline> outlines;  // shape frames
  std::vector<Similarity> shape_from_own;
  bool knows_scale = true;
};

namespace {

constexpr double kLargestScale = 1e15;

KnownShape known_shape(const std::vector<Outline>& outlines, std::size_t i) {
  try {
    return make_known_shape(outlines[i]);
  } catch (const Error& error) {
    throw Error("outline " + std::to_string(i) + ": " + error.what());
  }
}

void check_scale(double scale) {
  if (scale > 1 / kLargestScale && scale < kLargestScale) return;
  throw Error("scale: found " + number_in_message(scale) + ", allowed: above 1e-15 and below 1e15");
}

/// The curves, with the open ones in the other direction.
std::vector<tessera::Curve> turned_round(std::vector<tessera::Curve> curves) {
  for (tessera::Curve& curve : curves) {
    if (!curve.closed) std::reverse(curve.points.begin(), curve.points.end());
  }
  return curves;
}

/// The query in both directions in which its open curves may run; once, where all are closed.
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
    for (std::size_t begin = 0; begin < made.size(); begin += kSegmentShapes) {
      std::vector<ShapeModel> models;
      std::vector<float> own_units;
      for (std::size_t i = begin; i < std::min<std::size_t>(made.size(), begin + kSegmentShapes); ++i) {
        models.push_back(std::move(made[i].model));
        own_units.push_back(float(1 / made[i].shape_from_own.scale()));
      }
      state_->lots.emplace_back(ShapeId(std::uint32_t(begin)), std::move(models), std::move(own_units),
                                state_->pad.levels);
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
    for (std::size_t lot = 0; lot < number_of_lots(file, kSegmentShapes); ++lot) {
      const ShapeRange range = lot_of(file, lot, kSegmentShapes);
      state_->lots.push_back(read_lot(file, range));
      const LibraryParts outlines{.outline = true, .field = false, .levels = 0, .artwork = false};
      for (Shape& shape : file.read(range.begin, range.end, outlines)) {
        state_->outlines.push_back(std::move(shape.outline));
        state_->shape_from_own.push_back({});
        state_->knows_scale = state_->knows_scale && shape.drawn_scale_px > 0;
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
      if (!state_->knows_scale) throw Error("scale: the library does not know how large its shapes were drawn");
      core_settings.query_per_drawn_px = float(prepared.prepared(*settings.scale));
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
