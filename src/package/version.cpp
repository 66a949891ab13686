#include "tessera/matching/version.h"

#include "core/base/version.h"

namespace tessera::matching {

const char* version() { return program_version(); }

}  // namespace tessera::matching
