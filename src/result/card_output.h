// Writes the quality card: how good the collage is and what it took, with the columns of the paper's Table 2.
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

/// The settings of the job that the card shows, as the job gives them.
struct CardSettings {
  float padding_px = 0;
  int trials = 0;  // ImproveSettings::trials
};

/// The text of card.json (docs/result-format.md). Units are part of the keys; shares and percentages are named so. The
/// shares of the four stages are parts of their sum. Some sections are optional: "ranks" (rank_table.h) where there were
/// workers, "deformation" (deformation_table.h) where pieces were deformed, "missing" where pieces are missing.
std::string card_json(const Quality& quality, const RunStatistics& run, const CardSettings& settings,
                      const RankStatistics& ranks = {}, const RunRecord& record = {},
                      const std::optional<DeformationFigures>& deformation = {},
                      const std::vector<MissingShape>& missing = {});

/// The text of card.txt: the same for people, as a table of two columns. Lines have less than 80 characters.
std::string card_text(const Quality& quality, const RunStatistics& run, const CardSettings& settings,
                      const std::optional<DeformationFigures>& deformation = {},
                      const std::vector<MissingShape>& missing = {});

/// The card of a picture or of pieces of unknown origin: section quality for pieces and section from_afar for a picture, as
/// far as they are known. distinct_shapes is null where shapes have no names.
std::string score_json(const std::optional<Quality>& quality, const std::optional<AfarNote>& afar = {});
std::string score_text(const std::optional<Quality>& quality, const std::optional<AfarNote>& afar = {});

}  // namespace tessera
