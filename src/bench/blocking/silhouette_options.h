// Options that the benchmarks of recognised silhouettes (blocking, scenes) share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace tessera::bench {

struct SilhouetteOptions {
  std::string shapes;          // folder of silhouettes, white on black PNGs
  std::string twins;           // file with pairs of silhouettes that nobody can tell apart; empty: none
  bool mirrors = false;        // mirror images of the silhouettes are shapes of the library, too
  bool edge_removed = true;    // edges of a hider are no boundary of a query; false: they are
  bool scale_known = true;     // false: queries have 0.7 to 1.4 times the silhouettes' size, at random
  std::optional<double> size;  // query px for one px of a silhouette
  double noise_px = 0;         // standard deviation, query px
  int jpeg_quality = 0;        // 1 to 100; 0: no JPEG
  std::size_t queries = 0;     // of each kind, spread evenly over the silhouettes; 0: one of each
  std::uint64_t seed = 1;
};

/// Throws InputError, which names the option, where a number is not allowed.
void check(const SilhouetteOptions& options);

}  // namespace tessera::bench
