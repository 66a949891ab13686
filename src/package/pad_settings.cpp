#include "package/pad_settings.h"

#include <string>

#include "package/number_in_message.h"
#include "tessera/matching/error.h"

namespace tessera::matching {
namespace {

constexpr double kDefaultPart = 1.0 / 100;
/// Limits of the smoothing, as parts of the curve's length. Narrower smoothing would take more points than a curve of a
/// picture has.
constexpr double kNarrowestPart = 1.0 / 5000;
constexpr double kWidestPart = 1.0 / 12;

void check_range(const char* name, double found, double least, double most) {
  if (found >= least && found <= most) return;
  throw Error(std::string(name) + ": found " + number_in_message(found) + ", allowed: " + number_in_message(least) +
              " to " + number_in_message(most));
}

}  // namespace

double smoothing_of(const PadSettings& settings, double length) {
  check_range("levels", settings.levels, 2, 6);
  check_range("delta_tau_rad", settings.delta_tau_rad, 0.01, 1);
  check_range("samples", settings.samples, 1, 100000);
  if (settings.smoothing == 0) return kDefaultPart * length;
  check_range("smoothing of PADs", settings.smoothing, kNarrowestPart * length, kWidestPart * length);
  return settings.smoothing;
}

}  // namespace tessera::matching
