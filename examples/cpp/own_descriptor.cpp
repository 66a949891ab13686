// own_descriptor DRAWING...: distances of drawings by a descriptor of one's own, beside those by PADs.
#include <cmath>
#include <cstdio>

#include <tessera/matching/matching.h>

using namespace tessera::matching;

/// How round a shape is: 4 pi area / length^2, 1 of a disc.
class Roundness : public Descriptor {
 public:
  std::string name() const override { return "roundness"; }
  Description describe(const Outline& outline) const override {
    return {12.566370614 * area_of(outline) / std::pow(length_of(outline), 2)};
  }
  double distance(const Description& query, const Description& known) const override {
    return std::abs(query[0] - known[0]);
  }
};

void print_distances(const Descriptor& descriptor, const std::vector<Outline>& outlines) {
  const Matrix matrix = distance_matrix(descriptor, outlines, outlines);
  std::printf("%s\n", descriptor.name().c_str());
  for (std::size_t row = 0; row < matrix.rows; ++row) {
    for (std::size_t column = 0; column < matrix.columns; ++column) std::printf(" %.3f", matrix(row, column));
    std::printf("\n");
  }
}

int main(int count, char** arguments) try {
  std::vector<Outline> outlines;
  for (int i = 1; i < count; ++i) outlines.push_back(read_drawing(arguments[i]));
  print_distances(Roundness(), outlines);
  print_distances(*make_pad_descriptor(), outlines);
} catch (const Error& error) {
  std::fprintf(stderr, "own_descriptor: %s\n", error.what());
  return 2;
}
