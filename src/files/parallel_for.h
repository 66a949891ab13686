// Moved: kept for run/nesting/nest_chains.cpp alone.
#pragma once

#include "core/base/rank_pool.h"
