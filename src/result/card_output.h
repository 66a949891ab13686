// The quality card: how good the collage is and what it took, with the columns of the paper's Table 2.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/run_statistics.h"
#include "core/quality/quality.h"
#include "core/ranks/rank_statistics.h"
#include "result/afar_section.h"
#include "result/deformed_collage.h"
#include "result/folder/run_record.h"
#include "result/missing_shape.h"

namespace tessera {

/// What of the job's settings stands in the card, as the job says it.
struct CardSettings {
  float padding_px = 0;
  int trials = 0;  // ImproveSettings::trials
};

/// card.json (docs/result-format.md). Units stand in the keys; shares and percentages say so. Stage shares are of the
/// four stages' sum. Section "ranks" (rank_table.h) is there where there were workers, "deformation"
/// (deformation_table.h) where pieces were deformed, "missing" where pieces are.
std::string card_json(const Quality& quality, const RunStatistics& run, const CardSettings& settings,
                      const RankStatistics& ranks = {}, const RunRecord& record = {},
                      const std::optional<DeformationFigures>& deformation = {},
                      const std::vector<MissingShape>& missing = {});

/// The same for people: a table of two columns, lines of less than 80 characters.
std::string card_text(const Quality& quality, const RunStatistics& run, const CardSettings& settings,
                      const std::optional<DeformationFigures>& deformation = {},
                      const std::vector<MissingShape>& missing = {});

/// Of what nobody says how it was made: the sections quality, of pieces, and from_afar, of a picture, as far as they
/// are known. distinct_shapes is null where shapes have no names.
std::string score_json(const std::optional<Quality>& quality, const std::optional<AfarNote>& afar = {});
std::string score_text(const std::optional<Quality>& quality, const std::optional<AfarNote>& afar = {});

}  // namespace tessera
