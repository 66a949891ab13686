#include "run/recognition/recognition_search.h"

#include <algorithm>
#include <mutex>

#include "comm/encode.h"
#include "comm/heartbeat.h"
#include "core/base/error.h"
#include "core/base/rank_pool.h"
#include "recognition/library_lots.h"
#include "run/program_identity.h"

namespace tessera {
namespace {

/// The least smoothing, in pixels. It takes out the stairs of pixels.
constexpr float kLeastSigma_pixels = 1.5f;
/// Rank 0 takes a worker for lost that is silent for so long.
constexpr double kSilence_s = 300;

std::vector<Query> prepared_queries(const RecognitionQuestion& question, const PadParameters& pad) {
  std::vector<Query> queries;
  queries.reserve(question.queries.size());
  for (const AskedCurves& query : question.queries) {
    const float least_sigma = kLeastSigma_pixels * query.pixel;
    queries.emplace_back(query.curves, QuerySettings{.pad = pad, .least_sigma = least_sigma, .without_noise = true});
  }
  return queries;
}

/// Searches this rank's lots: every lot whose number modulo the number of ranks is this rank's number.
Recognitions recognised_here(const comm::Communicator& ranks, const RecognitionQuestion& question,
                             const ShapeLibrary& library, const LotProgress& progress) {
  const std::vector<Query> queries = prepared_queries(question, library.pad_parameters());
  RecognitionSettings settings{.query_per_drawn_px = {}, .most = question.most};
  if (question.query_per_drawn_px > 0) settings.query_per_drawn_px = question.query_per_drawn_px;
  std::mutex reading;  // a library is read by one thread at a time
  const OutlineOf outline_of = [&](ShapeId id) {
    const std::lock_guard lock(reading);
    return library
        .read(index_of(id), index_of(id) + 1, {.outline = true, .field = false, .levels = 0, .artwork = false})
        .front()
        .outline;
  };
  Recognitions best(queries.size());
  const std::vector<ShapeRange> lots = lots_of(library.size(), question.lot_shapes);
  for (std::size_t lot = std::size_t(ranks.rank()); lot < lots.size(); lot += std::size_t(ranks.size())) {
    progress(lot, lots.size());
    const KnownShapes shapes = read_lot(library, lots[lot]);
    parallel_for(queries.size(), [&](std::size_t q) {
      keep_best(best[q], recognised(queries[q], shapes, settings, outline_of), settings.most);
    });
  }
  progress(lots.size(), lots.size());
  return best;
}

}  // namespace

Recognitions recognised_by_all_ranks(comm::Communicator& ranks, const RecognitionQuestion& question,
                                     const ShapeLibrary& library, const LotProgress& progress) {
  announce_program(ranks, program_identity());
  ranks.broadcast(comm::encode(question));
  Recognitions best = recognised_here(ranks, question, library, [&](std::size_t done, std::size_t all) {
    ranks.check_arrivals();
    progress(done, all);
  });
  for (int worker = 1; worker < ranks.size(); ++worker) {
    const auto of_worker = comm::decode<Recognitions>(ranks.receive(worker, comm::Tag::recognitions));
    if (of_worker.size() != best.size()) comm::refuse_message();
    for (std::size_t q = 0; q < best.size(); ++q) keep_best(best[q], of_worker[q], question.most);
  }
  return best;
}

void work_on_recognition(comm::Communicator& ranks, const OpenLibrary& open) {
  check_program(ranks, program_identity());
  const comm::HeartbeatSender heart(ranks, kSilence_s);
  const auto question = comm::decode<RecognitionQuestion>(ranks.broadcast({}));
  const std::unique_ptr<const ShapeLibrary> library = open(question.library);
  if (library->content_digest() != question.library_digest) {
    throw InputError(question.library + ": is another library than on rank 0; copy the same file to every node");
  }
  const Recognitions found =
      recognised_here(ranks, question, *library, [&](std::size_t, std::size_t) { ranks.check_arrivals(); });
  ranks.send(0, comm::Tag::recognitions, comm::encode(found));
  for (;;) ranks.receive(0, comm::Tag::recognitions);  // nothing comes: JobEnded
}

}  // namespace tessera
