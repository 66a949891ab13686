// The range of sizes that a job allows; a quality card judges the balance of sizes within it.
#pragma once

#include <optional>

#include "core/quality/size_balance.h"
#include "job/job_file.h"

namespace tessera {

/// `pieces.scale_px`, before or after resolve_wishes. Nullopt where it does not decide the size of each piece. That is
/// so with pieces.fit = "all", with drawn sizes, and where shapes or regions have sizes of their own. A table of wishes
/// that was not read may also give such sizes.
std::optional<SizeRange> wished_sizes(const Job& job);

}  // namespace tessera
