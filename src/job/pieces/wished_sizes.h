// How large the pieces of a job may be: the range of sizes in which a quality card judges their balance.
#pragma once

#include <optional>

#include "core/quality/size_balance.h"
#include "job/job_file.h"

namespace tessera {

/// `pieces.scale_px`, before or after resolve_wishes. Nothing where it does not say how large each piece may be: where
/// all shapes are to fit, where they are as large as they were drawn, and where some have sizes of their own, or may
/// have them by a table of wishes that was not read.
std::optional<SizeRange> wished_sizes(const Job& job);

}  // namespace tessera
