// A PAD of a library shape with what docking needs of its pyramid, as compact as devices hold it: a large library is
// bound by memory.
#pragma once

#include <array>
#include <cstdint>

#include "core/geometry/vec2.h"
#include "core/pad/quantised_pad.h"

namespace tessera {

using Keypoints = std::array<Vec2, 2 * kMaxPadLevels + 1>;

struct ModelSample {
  struct Step {
    std::int16_t x = 0;
    std::int16_t y = 0;

    friend bool operator==(const Step&, const Step&) = default;
  };

  QuantisedPad pad;        // a library_pad()
  float scale_length = 0;  // the library_length() of the pyramid's scale_length(), shape units
  float convexity = 0;
  std::array<Step, 2 * kMaxPadLevels + 1> keypoint{};  // in steps of the shape's keypoint_step()

  friend bool operator==(const ModelSample&, const ModelSample&) = default;
};

/// Of it what an index is made of.
struct LibraryPad {
  QuantisedPad pad;        // a library_pad()
  float scale_length = 0;  // a library_length()
  float convexity = 0;

  friend bool operator==(const LibraryPad&, const LibraryPad&) = default;
};

inline constexpr int kChordLevel = 2;  // whose chord tells scale and rotation before any alignment

/// Length of the interval that estimates the scale before any alignment.
float scale_length(const ArclengthPyramid& pyramid, int levels);

/// The nearest length whose lower 16 bits are 0, all that is kept of a library's scale lengths: to 0.2 %, of which an
/// octave's window knows nothing.
float library_length(float length);

/// From end to end of that interval: it tells the rotation before any alignment. Of a sample in steps of its shape's
/// key points, in whole numbers.
Vec2 chord(const ArclengthPyramid& pyramid, int levels);
Vec2 chord(const ModelSample& sample, int levels);

/// Shape units for one step of a key point: so small that nothing is seen of it.
inline float keypoint_step(float shape_radius) { return shape_radius * (1.f / 32000.f); }

ModelSample make_model_sample(const ArclengthPyramid& pyramid, int levels, float keypoint_step);

/// The key points in the shape frame.
Keypoints keypoints(const ModelSample& sample, float keypoint_step);

}  // namespace tessera
