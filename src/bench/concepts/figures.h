// The figures of docs/concepts: each shows one stage of the pipeline on real data.
#pragma once

#include <string>

#include "bench/concepts/collage_stage.h"

namespace tessera::bench::concepts {

/// The smoothing levels of a shape, and the PAD of one of its points.
std::string shapes_figure(const Shape& shape, const PadParameters& pad);

/// The free region of a collage, its target curve and the samples on it.
std::string target_figure(CollageStage& stage);

/// A target sample and the PADs of the library that are most like it.
std::string pairs_figure(CollageStage& stage);

/// A docking as its PADs imply it, after refinement, and as the piece that it became: the one that moves farthest in some
/// rounds, for which this places pieces. Throws InputError where no piece comes from a pair of PADs.
std::string dockings_figure(CollageStage& stage);

/// All candidates of a round, the finalists among them, and the pieces of the batch.
std::string choice_figure(CollageStage& stage);

/// Target samples before and after a piece is merged. Places that piece.
std::string merge_figure(CollageStage& stage);

/// A window of a full collage before and after its replacement trials. Fills the stage.
std::string improving_figure(CollageStage& stage);

/// The tree of ranks, and the messages of one round, which this places a piece for.
std::string ranks_figure(CollageStage& stage);

}  // namespace tessera::bench::concepts
