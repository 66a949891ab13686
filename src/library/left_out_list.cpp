#include "library/left_out_list.h"

#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

#include "core/base/error.h"
#include "files/atomic_file.h"
#include "files/regular_file.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

namespace fs = std::filesystem;

/// One line of the list. Control characters in paths and reasons, such as tabs, would break the columns.
std::string line(const char* what, const std::string& path, const std::string& why) {
  return std::string(what) + "\t" + printable_utf8(path) + "\t" + printable_utf8(why) + "\n";
}

bool begins_as_list(const std::string& path) {
  std::vector<std::uint8_t> first(8);
  first.resize(read_at(path, open_regular_file(path), 0, first));
  const std::string_view text(reinterpret_cast<const char*>(first.data()), first.size());
  return text.starts_with("skipped\t") || text.starts_with("merged\t") || text.starts_with("trimmed\t");
}

}  // namespace

std::string left_out_path(const std::string& library) {
  fs::path path(library);
  if (path.extension() == ".h5") path.replace_extension();
  return path.string() + ".left_out.txt";
}

std::string left_out_list(const LibraryBuildReport& report) {
  std::string text;
  for (const UnusedFile& file : report.skipped) text += line("skipped", file.path, file.reason);
  for (const LibraryBuildReport::Merged& file : report.merged) {
    text += line("merged", file.path, "the silhouette and colour of " + file.name);
  }
  for (const std::string& path : report.trimmed) {
    text += line("trimmed", path,
                 "parts that do not touch the largest one are not in the silhouette; join them to have them, or, where "
                 "a soft shadow joins them, build with --edge-opacity 0.05");
  }
  for (const std::string& path : report.textless) {
    text += line("trimmed", path, "text is not drawn, as fontconfig finds no font here; install one to have it");
  }
  for (const std::string& path : report.first_pictures) {
    text += line("trimmed", path, "an animation, or a file of several pages: its first picture alone is the shape");
  }
  for (const std::string& path : report.faint) {
    text +=
        line("trimmed", path,
             "parts that are too faint (an opacity below 0.08) or too thin, or a plate behind the drawing, are not in "
             "the silhouette; make them more opaque or thicker to have them, or build with --edge-opacity 0.05");
  }
  return text;
}

void check_left_out_list(const std::string& library) {
  const std::string path = left_out_path(library);
  std::error_code error;
  if (fs::is_regular_file(path, error) && !begins_as_list(path))
    throw InputError(path +
                     ": exists and is not the list of a library's left-out files; give the library another name");
  check_can_be_written(path);
}

void write_left_out_list(const std::string& library, const LibraryBuildReport& report) {
  const std::string path = left_out_path(library);
  const std::string text = left_out_list(report);
  if (!text.empty()) return write_file_atomically(path, text);
  std::error_code error;
  fs::remove(path, error);
  if (error) throw EnvironmentError("cannot remove " + path + ": " + error.message());
}

}  // namespace tessera
