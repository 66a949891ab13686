// A PAD of a library shape with the part of its pyramid that docking needs. It is as compact as on devices, because
// memory limits large libraries.
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

/// The part of a ModelSample from which an index is made.
struct LibraryPad {
  QuantisedPad pad;        // a library_pad()
  float scale_length = 0;  // a library_length()
  float convexity = 0;

  friend bool operator==(const LibraryPad&, const LibraryPad&) = default;
};

inline constexpr int kChordLevel = 2;  // the level whose chord estimates scale and rotation before any alignment

/// The length of the interval that estimates the scale before any alignment.
float scale_length(const ArclengthPyramid& pyramid, int levels);

/// The nearest length whose lower 16 bits are 0. A library keeps only these bits of its scale lengths: exact to 0.2 %,
/// which does not matter in a window of an octave.
float library_length(float length);

/// The vector from end to end of that interval, which estimates the rotation before any alignment. For a ModelSample in
/// steps of its shape's key points, in whole numbers.
Vec2 chord(const ArclengthPyramid& pyramid, int levels);
Vec2 chord(const ModelSample& sample, int levels);

/// Shape units for one step of a key point: too small to matter.
inline float keypoint_step(float shape_radius) { return shape_radius * (1.f / 32000.f); }

ModelSample make_model_sample(const ArclengthPyramid& pyramid, int levels, float keypoint_step);

/// The key points in the shape frame.
Keypoints keypoints(const ModelSample& sample, float keypoint_step);

}  // namespace tessera
