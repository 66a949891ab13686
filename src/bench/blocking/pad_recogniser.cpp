#include "bench/blocking/recogniser.h"
#include "core/recognition/recognition.h"

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

class PadRecogniser : public Recogniser {
 public:
  explicit PadRecogniser(const SilhouetteLibrary& library) : library_(library), known_(known_shapes_of(library)) {}

  std::string name() const override { return "pad"; }

  std::vector<std::uint32_t> recognise(const ClippedQuery& clipped) const override {
    QuerySettings settings;
    settings.least_sigma += float(clipped.noise_px);
    const Query query(clipped.curves, settings);
    RecognitionSettings wanted;
    wanted.most = kMostTold;
    if (clipped.size) wanted.query_per_drawn_px = float(*clipped.size);
    const auto outline_of = [&](ShapeId id) { return library_.shapes[index_of(id)].outline; };
    std::vector<std::uint32_t> found;
    for (const Recognition& r : recognised(query, known_, wanted, outline_of)) {
      found.push_back(std::uint32_t(index_of(r.shape)));
    }
    return found;
  }

 private:
  const SilhouetteLibrary& library_;
  KnownShapes known_;
};

}  // namespace

std::unique_ptr<Recogniser> make_pad_recogniser(const SilhouetteLibrary& library) {
  return std::make_unique<PadRecogniser>(library);
}

}  // namespace tessera::bench
