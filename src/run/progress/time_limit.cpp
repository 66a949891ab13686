#include "run/progress/time_limit.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>

#include "core/base/error.h"
#include "text/number_text.h"

namespace tessera {
namespace {

// Checkpoint and files without pictures take 0.1 to 1 s; disks of clusters are slow at times.
constexpr double kLeastReserve_s = 2;
constexpr double kMostReserve_s = 20;
constexpr double kReserveShare = 0.05;  // between these two
// Time to end drawing.
constexpr double kDrawingReserve_s = 1;
constexpr double kMostLimit_s = 1e8;

std::optional<double> number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= 0 && value <= kMostLimit_s)) return {};
  return value;
}

/// Reads digits only.
std::optional<double> whole(std::string_view text) {
  return text.find_first_not_of("0123456789") == std::string_view::npos ? number(text) : std::nullopt;
}

/// Reads two digits below 60.
std::optional<double> sixtieth(std::string_view text) {
  const std::optional<double> value = whole(text);
  return text.size() == 2 && value && *value < 60 ? value : std::nullopt;
}

/// Reads "90", "90.5", "90s", "90m", "1.5h".
std::optional<double> with_unit(std::string_view text) {
  double unit_s = 1;
  if (text.ends_with('m')) unit_s = 60;
  if (text.ends_with('h')) unit_s = 3600;
  if (unit_s > 1 || text.ends_with('s')) text.remove_suffix(1);
  const std::optional<double> count = number(text);
  return count ? std::optional(*count * unit_s) : std::nullopt;
}

/// Reads "A", "A:BB", "A:BB:CC". The first number is in units of `unit_s`, each other one in sixtieths of the one before.
std::optional<double> with_colons(std::string_view text, double unit_s) {
  const std::size_t colon = text.find(':');
  const std::optional<double> first = whole(text.substr(0, colon));
  if (!first) return {};
  double sum_s = *first * unit_s;
  for (std::size_t at = colon; at != std::string_view::npos; at = text.find(':', at + 1)) {
    unit_s /= 60;
    const std::optional<double> value = sixtieth(text.substr(at + 1, text.find(':', at + 1) - at - 1));
    if (!value || unit_s < 1) return {};
    sum_s += *value * unit_s;
  }
  return sum_s;
}

/// Whether the text is one of sbatch's two words for no limit, in any case.
bool is_without_limit(std::string_view text) {
  std::string word(text);
  std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::toupper(c); });
  return word == "UNLIMITED" || word == "INFINITE";
}

/// Reads the forms of sbatch's --time, but a plain number is seconds. Infinite: no limit.
std::optional<double> any_form(std::string_view text) {
  if (is_without_limit(text)) return std::numeric_limits<double>::infinity();
  if (const std::size_t dash = text.find('-'); dash != std::string_view::npos) {
    const std::optional<double> days = whole(text.substr(0, dash));
    const std::optional<double> rest_s = with_colons(text.substr(dash + 1), 3600);
    return days && rest_s ? std::optional(*days * 86400 + *rest_s) : std::nullopt;
  }
  const auto colons = std::count(text.begin(), text.end(), ':');
  if (colons == 0) return with_unit(text);
  return with_colons(text, colons == 1 ? 60 : 3600);
}

InputError refused(const std::string& text, const std::string& allowed) {
  return InputError("--time-limit: found " + (text.empty() ? "an empty text" : text) + ", allowed: " + allowed);
}

}  // namespace

double parse_time_limit(const std::string& text) {
  const std::optional<double> limit_s = any_form(text);
  if (limit_s && *limit_s > 0) return *limit_s;
  throw refused(
      text, "seconds, 90s, 90m, 2h, MM:SS, HH:MM:SS, D-HH, D-HH:MM, D-HH:MM:SS, UNLIMITED or INFINITE, more than 0");
}

double time_limit_s(const std::optional<std::string>& argument, const char* slurm_end_time, double now_s,
                    double shutdown_s) {
  if (argument) {
    const double limit_s = parse_time_limit(*argument);
    const double kept_s = reserve_s(limit_s) + shutdown_s;
    if (limit_s > kept_s) return limit_s;
    throw refused(*argument, "more than the " + fixed(kept_s, 1) +
                                 " s that are reserved for the checkpoint, the files and the end of the ranks");
  }
  double end_s = 0;
  if (slurm_end_time) {
    const std::string_view text(slurm_end_time);
    std::from_chars(text.data(), text.data() + text.size(), end_s);
  }
  return end_s > now_s ? end_s - now_s : std::numeric_limits<double>::infinity();
}

std::string short_limit_warning(double limit_s, double shutdown_s) {
  const double kept_s = reserve_s(limit_s) + shutdown_s;
  if (limit_s > kept_s) return "";
  return "the Slurm job ends in " + fixed(limit_s, 0) + " s, and " + fixed(kept_s, 0) +
         " s are reserved for the checkpoint, the files and the end of the ranks: nothing will be computed; give the "
         "job more time (sbatch "
         "--time)";
}

double reserve_s(double limit_s) { return std::clamp(kReserveShare * limit_s, kLeastReserve_s, kMostReserve_s); }

bool TimeLimit::must_end_round(double shutdown_s) const {
  return watch_.seconds() + reserve_s(limit_s_) + shutdown_s >= limit_s_;
}

bool TimeLimit::near() {
  const double now_s = watch_.seconds();
  if (asked_s_ > 0) longest_wait_s_ = std::max(longest_wait_s_, now_s - asked_s_);
  asked_s_ = now_s;
  return now_s + longest_wait_s_ + reserve_s(limit_s_) >= limit_s_;
}

bool TimeLimit::must_end_drawing(double shutdown_s) const {
  return watch_.seconds() + kDrawingReserve_s + shutdown_s >= limit_s_;
}

}  // namespace tessera
