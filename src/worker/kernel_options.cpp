#include "worker/kernel_options.h"

#include <cstdio>

#include "core/field/field_lookup.h"
#include "core/matching/docking.h"
#include "core/shape/shape_model.h"
#include "core/tuning.h"
#include "worker/shard.h"

namespace tessera::worker {
namespace {

void define(std::string& options, const char* name, const std::string& value) {
  options += std::string(" -D") + name + "=" + value;
}

void define(std::string& options, const char* name, int value) { define(options, name, std::to_string(value)); }

/// All bits of the number, and brackets for its sign.
void define(std::string& options, const char* name, float value) {
  char text[64];
  std::snprintf(text, sizeof text, "(%af)", double(value));
  define(options, name, std::string(text));
}

}  // namespace

std::string kernel_options(const cl::Device& device, int pad_levels) {
  std::string options = "-cl-std=CL1.2";
  if (device.getInfo<CL_DEVICE_SINGLE_FP_CONFIG>() & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT) {
    options += " -cl-fp32-correctly-rounded-divide-sqrt";
  }
  define(options, "kPadLevels", pad_levels);
  define(options, "kPadRow", pad_row(pad_levels));
  define(options, "kPadKeypoints", 2 * pad_levels + 1);
#define DEFINE(constant) define(options, #constant, constant)
  DEFINE(kMaxPadLevels);
  DEFINE(kMaxPadElements);
  DEFINE(kBoundaryPoints);
  DEFINE(kMediumStride);
  DEFINE(kCoarseStride);
  DEFINE(kMaxInteriorPoints);
  DEFINE(kPairsPerShape);
  DEFINE(kDockingsPerShape);
  DEFINE(kDistanceBins);
  DEFINE(kShortlist);
  DEFINE(kChordLevel);
  DEFINE(kInsideBound);
  DEFINE(kScaleRounding);
  DEFINE(kRotationRounding_rad);
  DEFINE(kNoTurnLimit);
  DEFINE(kScaleWindowLow);
  DEFINE(kScaleWindowHigh);
  DEFINE(kAlignmentTolerance);
  DEFINE(kLeastDockingKey);
  DEFINE(kOffGridDistance);
  DEFINE(kHopelessDepth_px);
  DEFINE(kPushSteps);
  DEFINE(kPushShrink);
#undef DEFINE
  define(options, "kTangentSource", std::to_string(kTangentSource) + "u");
  return options;
}

}  // namespace tessera::worker
