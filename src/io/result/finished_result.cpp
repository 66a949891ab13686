#include "io/result/finished_result.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/error.h"
#include "io/result/card_input.h"

namespace tessera::io {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The picture is written last: one that is older belongs to the run before.
bool picture_is_newest(const fs::path& dir) {
  std::error_code error;
  const auto picture = fs::last_write_time(dir / "collage.png", error);
  return !error && picture >= fs::last_write_time(dir / "job.toml", error) && !error;
}

}  // namespace

bool holds_finished_result(const std::string& dir, const Job& job) {
  if (!picture_is_newest(dir) || bytes_of(fs::path(dir) / "job.toml") != to_toml(job)) return false;
  try {
    const std::string stopped_by = read_card(dir).stopped_by;
    return stopped_by != "signal" && stopped_by != "time_limit";
  } catch (const InputError&) {  // no card, or not one of ours: the run makes a new one
    return false;
  }
}

}  // namespace tessera::io
