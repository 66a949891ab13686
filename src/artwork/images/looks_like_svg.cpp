#include "artwork/images/looks_like_svg.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>

#include "files/gunzip.h"

namespace tessera {

bool looks_like_svg(std::span<const std::uint8_t> bytes) {
  if (is_gzip(bytes)) return true;
  const auto first = std::find_if(bytes.begin(), bytes.end(), [](std::uint8_t c) { return !std::isspace(c); });
  const auto rest = bytes.subspan(std::size_t(first - bytes.begin()));
  const auto starts_with = [&](std::initializer_list<std::uint8_t> mark) {
    return rest.size() >= mark.size() && std::equal(mark.begin(), mark.end(), rest.begin());
  };
  // "<", or a byte order mark of UTF-8 or UTF-16.
  return starts_with({'<'}) || starts_with({0xef, 0xbb, 0xbf}) || starts_with({0xff, 0xfe}) ||
         starts_with({0xfe, 0xff});
}

}  // namespace tessera
