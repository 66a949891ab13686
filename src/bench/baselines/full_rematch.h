// The collage without "cut and paste": in every round all target samples are matched again, not only those that
// changed.
#pragma once

#include "master/collage_loop.h"

namespace tessera::bench {

/// As master::make_collage, but without its stops: it ends when two rounds in succession find nothing.
master::CollageResult make_collage_afresh(const Canvas& canvas, const CollageSettings& settings, Matcher& matcher,
                                          ShapeSource& shapes);

}  // namespace tessera::bench
