// The rules by which shapes of a library may stand as their mirror images.
#pragma once

#include <string>
#include <vector>

namespace tessera {

enum class Mirroring { never, also, only };

/// The words of the job's keys, in the order of the enum.
inline const std::vector<std::string>& mirroring_words() {
  static const std::vector<std::string> words = {"never", "also", "only"};
  return words;
}

/// A rule about mirroring for shapes with such names (patterns as in name_globs.h).
struct MirroringRule {
  std::vector<std::string> names;
  Mirroring mirroring = Mirroring::never;
};

}  // namespace tessera
