// match_drawings A B: how drawing B lies on drawing A where their outlines follow one another.
#include <cstdio>

#include <tessera/matching/matching.h>

int main(int count, char** arguments) try {
  using namespace tessera::matching;
  if (count != 3) throw Error("needs two drawings");
  for (const Match& m : match(read_drawing(arguments[1]), read_drawing(arguments[2]), 3)) {
    std::printf("score %.3f: %.1f %% of A, scale %.3f, turned by %.3f rad\n", m.score, 100 * m.part_of_a,
                m.a_from_b.scale(), m.a_from_b.rotation_rad());
  }
} catch (const tessera::matching::Error& error) {
  std::fprintf(stderr, "match_drawings: %s\n", error.what());
  return 2;
}
