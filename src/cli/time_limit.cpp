#include "cli/time_limit.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <vector>

#include "core/base/error.h"

namespace tessera::cli {
namespace {

// The checkpoint and the files but the pictures take 0.1 to 1 s; disks of clusters are slow at times.
constexpr double kLeastReserve_s = 2;
constexpr double kMostReserve_s = 20;
constexpr double kReserveShare = 0.05;  // in between
// To end drawing.
constexpr double kDrawingReserve_s = 1;
constexpr double kMostLimit_s = 1e8;

std::optional<double> number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= 0 && value <= kMostLimit_s)) return {};
  return value;
}

/// Two digits below 60.
std::optional<double> sixtieth(std::string_view text) {
  const std::optional<double> value = number(text);
  return text.size() == 2 && value && *value < 60 ? value : std::nullopt;
}

std::optional<double> hours_minutes_seconds(std::string_view text) {
  const std::size_t second = text.rfind(':');
  const std::size_t first = text.find(':');
  if (first == second) return {};
  const auto hours = number(text.substr(0, first));
  const auto minutes = sixtieth(text.substr(first + 1, second - first - 1));
  const auto seconds = sixtieth(text.substr(second + 1));
  if (!hours || !minutes || !seconds) return {};
  return 3600 * *hours + 60 * *minutes + *seconds;
}

}  // namespace

double parse_time_limit(const std::string& text) {
  const auto limit_s = text.find(':') == std::string::npos ? number(text) : hours_minutes_seconds(text);
  if (limit_s && *limit_s > 0) return *limit_s;
  throw InputError("--time-limit: found " + text + ", allowed: seconds or HH:MM:SS, more than 0");
}

double time_limit_s(const std::string& argument, const char* slurm_end_time, double now_s) {
  if (!argument.empty()) return parse_time_limit(argument);
  double end_s = 0;
  if (slurm_end_time) {
    const std::string_view text(slurm_end_time);
    std::from_chars(text.data(), text.data() + text.size(), end_s);
  }
  return end_s > now_s ? end_s - now_s : std::numeric_limits<double>::infinity();
}

double reserve_s(double limit_s) { return std::clamp(kReserveShare * limit_s, kLeastReserve_s, kMostReserve_s); }

bool TimeLimit::near() {
  const double now_s = watch_.seconds();
  if (asked_s_ > 0) longest_round_s_ = std::max(longest_round_s_, now_s - asked_s_);
  asked_s_ = now_s;
  return now_s + longest_round_s_ + reserve_s(limit_s_) >= limit_s_;
}

bool TimeLimit::over() const { return watch_.seconds() + kDrawingReserve_s >= limit_s_; }

}  // namespace tessera::cli
