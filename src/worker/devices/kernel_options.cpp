#include "worker/devices/kernel_options.h"

#include <cstdio>

#include "core/base/lanes.h"
#include "core/colour/fading.h"
#include "core/field/field_lookup.h"
#include "core/matching/docking.h"
#include "core/matching/near_colours.h"
#include "core/settings/tuning.h"
#include "core/shape/shape_model.h"

namespace tessera::worker {
namespace {

void define(std::string& options, const char* name, const std::string& value) {
  options += std::string(" -D") + name + "=" + value;
}

void define(std::string& options, const char* name, int value) { define(options, name, std::to_string(value)); }

/// Defines a number with all of its bits, in brackets for its sign.
void define(std::string& options, const char* name, float value) {
  char text[64];
  std::snprintf(text, sizeof text, "(%af)", double(value));
  define(options, name, std::string(text));
}

/// Defines the members one by one: kPush_steps and so on.
void define(std::string& options, const std::string& name, const Descent& descent) {
  define(options, (name + "_steps").c_str(), descent.steps);
  define(options, (name + "_first_radius_px").c_str(), descent.first_radius_px);
  define(options, (name + "_last_radius_px").c_str(), descent.last_radius_px);
  define(options, (name + "_overlap_weight").c_str(), descent.overlap_weight);
  define(options, (name + "_all_points").c_str(), int(descent.all_points));
}

}  // namespace

std::uint32_t items_of_docking(DockingLanes lanes) { return lanes == DockingLanes::items ? kLanes : 1; }

std::uint32_t draws_per_item(DockingLanes lanes) { return lanes == DockingLanes::items ? 1 : 8; }

// Defines all constants, one in each line.
std::string kernel_options(int pad_levels, DockingLanes lanes) {
  std::string options = "-cl-std=CL1.2 -cl-fp32-correctly-rounded-divide-sqrt";
  define(options, "kPadLevels", pad_levels);
  define(options, "kPadKeypoints", 2 * pad_levels + 1);
  define(options, "kLanesAreItems", int(lanes == DockingLanes::items));
  define(options, "kDrawsPerItem", int(draws_per_item(lanes)));
#define DEFINE(constant) define(options, #constant, constant)
  DEFINE(kLanes);
  DEFINE(kMaxPadLevels);
  DEFINE(kMaxPadElements);
  DEFINE(kBoundaryPoints);
  DEFINE(kMediumStride);
  DEFINE(kCoarseStride);
  DEFINE(kMaxInteriorPoints);
  DEFINE(kInsideBound);
  DEFINE(kScaleRounding);
  DEFINE(kRotationRounding_rad);
  DEFINE(kNoTurnLimit);
  DEFINE(kScaleWindowLow);
  DEFINE(kScaleWindowHigh);
  DEFINE(kOffGridDistance);

  DEFINE(kAlignmentLevels);
  DEFINE(kAlignmentTolerance);
  DEFINE(kAlignmentUnit_px);

  DEFINE(kHopelessDocking_px);
  DEFINE(kHopelessDocking);
  DEFINE(kNearDocking_px);
  DEFINE(kNearDocking);
  DEFINE(kMostBadPoints);
  DEFINE(kBadPointCost);
  DEFINE(kInteriorStride);
  DEFINE(kCoveredCost);
  DEFINE(kLeastDockingKey);

  DEFINE(kApproach);
  DEFINE(kApproachRadius);
  DEFINE(kCloseFit);
  DEFINE(kPush);
  DEFINE(kPushSteps);
  DEFINE(kPushShrink);
  DEFINE(kArm);
  DEFINE(kLeastDrawnPoints);
  DEFINE(kDamping);
  DEFINE(kLeastDamping);
  DEFINE(kGrowthDamping);
  DEFINE(kMaxPushDepth_px);
  DEFINE(kInteriorDepth_px);

  DEFINE(kMaxColourLevels);
  DEFINE(kColourFading);
  DEFINE(kEvenFading);
  DEFINE(kColourFootprint);
  DEFINE(kLeastColourWeight);

  DEFINE(kNoise_px);
  DEFINE(kContact_px);
#undef DEFINE
  define(options, "kTangentSource", std::to_string(kTangentSource) + "u");
  define(options, "kAnyColour", std::to_string(NearColours::kAny) + "u");
  define(options, "kAnyColourDraws", std::to_string(kAnyColourDraws) + "u");
  return options;
}

}  // namespace tessera::worker
