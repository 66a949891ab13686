// The collage without "cut and paste": every round matches all target samples again, not only those that changed.
#pragma once

#include "master/collage_loop.h"

namespace tessera::bench {

/// Like master::make_collage, but it ends only when two rounds in succession find nothing.
master::CollageResult make_collage_afresh(const Canvas& canvas, const CollageSettings& settings, Matcher& matcher,
                                          ShapeSource& shapes);

}  // namespace tessera::bench
