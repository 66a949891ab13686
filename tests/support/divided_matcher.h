// The plain C++ matcher over a library that is divided into parts, as among ranks.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/matching/composite_matcher.h"
#include "core/matching/reference_matcher.h"
#include "support/synthetic_library.h"

namespace tessera::test {

/// Divides the library at each of `cuts`, which must be in ascending order; the last part ends at the library's end.
inline CompositeMatcher divided_matcher(const std::vector<Shape>& library, const MatchingContext& context,
                                        std::vector<std::uint32_t> cuts) {
  cuts.push_back(std::uint32_t(library.size()));
  std::vector<std::unique_ptr<Matcher>> parts;
  std::uint32_t begin = 0;
  for (const std::uint32_t end : cuts) {
    parts.push_back(std::make_unique<ReferenceMatcher>(context, begin, models_of(library, context, begin, end)));
    begin = end;
  }
  return CompositeMatcher(std::move(parts));
}

}  // namespace tessera::test
