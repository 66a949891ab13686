/// @file
/// Includes all headers of the library Tessera::matching.
#pragma once

#include "tessera/matching/descriptor.h"
#include "tessera/matching/drawing.h"
#include "tessera/matching/error.h"
#include "tessera/matching/library.h"
#include "tessera/matching/match.h"
#include "tessera/matching/outline.h"
#include "tessera/matching/pad.h"
#include "tessera/matching/recognise.h"
#include "tessera/matching/similarity.h"
#include "tessera/matching/version.h"
