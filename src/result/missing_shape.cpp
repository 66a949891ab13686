#include "result/missing_shape.h"

#include <algorithm>

#include "core/base/count_text.h"
#include "text/utf8_text.h"

namespace tessera {

std::string missing_text(const std::vector<MissingShape>& missing, std::size_t most) {
  std::string text;
  for (std::size_t i = 0; i < std::min(missing.size(), most); ++i) {
    const MissingShape& m = missing[i];
    text += (i == 0 ? "" : ", ") + printable_utf8(m.name) + " (" + std::to_string(m.standing) + " of " +
            std::to_string(m.wanted) + ")";
  }
  if (missing.size() <= most) return text;
  const std::size_t more = missing.size() - most;
  return text + " and " + count_text(more, "more shape");
}

}  // namespace tessera
