#include "bench/blocking/pad_recogniser.h"

namespace tessera::bench {
namespace {

KnownShapes known_shapes_of(const SilhouetteLibrary& library) {
  std::vector<ShapeModel> models;
  std::vector<float> drawn_scales_px;
  for (const KnownSilhouette& shape : library.shapes) {
    models.push_back(shape.model);
    drawn_scales_px.push_back(shape.unit_px);
  }
  return KnownShapes(ShapeId{0}, std::move(models), std::move(drawn_scales_px), PadParameters().levels);
}

}  // namespace

PadRecogniser::PadRecogniser(const SilhouetteLibrary& library) : library_(library), known_(known_shapes_of(library)) {}

Query prepared_query(const ClippedQuery& query) {
  QuerySettings settings;
  settings.least_sigma += float(query.noise_px);
  settings.without_noise = true;
  return Query(query.curves, settings);
}

std::vector<Recognition> PadRecogniser::recognitions(const ClippedQuery& query) const {
  RecognitionSettings wanted;
  wanted.most = kMostTold;
  if (query.size) wanted.query_per_drawn_px = float(*query.size);
  const auto outline_of = [&](ShapeId id) { return library_.shapes[index_of(id)].outline; };
  return recognised(prepared_query(query), known_, wanted, outline_of);
}

std::vector<std::uint32_t> PadRecogniser::recognise(const ClippedQuery& query) const {
  std::vector<std::uint32_t> found;
  for (const Recognition& r : recognitions(query)) found.push_back(std::uint32_t(index_of(r.shape)));
  return found;
}

}  // namespace tessera::bench
