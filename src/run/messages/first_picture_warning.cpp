#include "run/messages/first_picture_warning.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "artwork/images/image_header.h"
#include "core/base/error.h"
#include "files/regular_file.h"
#include "job/job_keys.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

/// Whoever reads pictures refuses larger files.
constexpr std::size_t kMostPictureBytes = std::size_t(128) << 20;

bool may_have_several(ImageFormat format) {
  return format == ImageFormat::png || format == ImageFormat::webp || format == ImageFormat::tiff;
}

bool has_several(const std::string& path) {
  try {
    std::array<std::uint8_t, 16> begin{};
    const FileDescriptor file = open_regular_file(path);
    read_at(path, file, 0, begin);
    return may_have_several(image_format(begin)) && has_several_pictures(read_regular_file(path, kMostPictureBytes));
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

std::string first_picture_warning(const std::vector<std::string>& files) {
  std::string several;
  for (const std::string& file : files) {
    if (has_several(file)) several += (several.empty() ? "" : ", ") + printable_utf8(file);
  }
  return several.empty() ? "" : several + ": an animation, or several pages; only the first picture is used";
}

std::string first_picture_warning(const Job& job) {
  std::vector<std::string> files;
  for (const JobKey& key : job_keys()) {
    if (key.kind != JobKind::file && key.kind != JobKind::files) continue;
    const JobValue value = key.get(job);
    if (!value.text.empty()) files.push_back(value.text);
    files.insert(files.end(), value.texts.begin(), value.texts.end());
  }
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return first_picture_warning(files);
}

}  // namespace tessera
