// A recogniser that searches a library of silhouettes with PADs (core/recognition).
#pragma once

#include "bench/blocking/recogniser.h"
#include "core/recognition/known_shapes.h"
#include "core/recognition/recognition.h"

namespace tessera::bench {

class PadRecogniser : public Recogniser {
 public:
  /// The library must outlive it.
  explicit PadRecogniser(const SilhouetteLibrary& library);

  std::string name() const override { return "pad"; }
  std::vector<std::uint32_t> recognise(const ClippedQuery& query) const override;

  /// The answer of recognise() with poses and similarities. Numbers of shapes are their indices in the library's list.
  std::vector<Recognition> recognitions(const ClippedQuery& query) const;

 private:
  const SilhouetteLibrary& library_;
  KnownShapes known_;
};

/// Prepares a query: where its noise is known, the finest smoothing is widened.
Query prepared_query(const ClippedQuery& query);

}  // namespace tessera::bench
