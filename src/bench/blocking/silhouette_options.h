// Options that the benchmarks of recognised silhouettes (blocking, scenes) have in common.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace tessera::bench {

struct SilhouetteOptions {
  std::string shapes;          // folder of silhouettes, white on black PNGs
  std::string twins;           // file of pairs of silhouettes that nobody can tell apart; empty: there are none
  bool mirrors = false;        // the silhouettes' mirror images are shapes of the library, too
  bool edge_removed = true;    // edges of what hides a part are no boundary of a query; else they are
  bool scale_known = true;     // else queries have 0.7 to 1.4 times the silhouettes' size, at random
  std::optional<double> size;  // px of all queries for one px of a silhouette
  double noise_px = 0;         // standard deviation, query px
  int jpeg_quality = 0;        // 1 to 100; 0: queries are no JPEG
  std::size_t queries = 0;     // of each kind, evenly from all silhouettes; 0: one of each
  std::uint64_t seed = 1;
};

/// Throws InputError, which names the option, where a number is none that is allowed.
void check(const SilhouetteOptions& options);

}  // namespace tessera::bench
