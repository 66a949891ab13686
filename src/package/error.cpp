#include "tessera/matching/error.h"

namespace tessera::matching {

Error::~Error() = default;

}  // namespace tessera::matching
