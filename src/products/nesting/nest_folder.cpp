#include "products/nesting/nest_folder.h"

#include <algorithm>
#include <exception>
#include <set>
#include <span>
#include <string_view>
#include <system_error>

#include "core/base/error.h"
#include "core/base/stopwatch.h"
#include "files/atomic_file.h"
#include "files/regular_file.h"
#include "files/write_all.h"
#include "products/nesting/nest_job.h"
#include "products/nesting/nest_sheets.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

namespace fs = std::filesystem;

/// Whether the name is layout or layout_N with an ending of a sheet's files.
bool is_of_sheet(std::string_view name) {
  constexpr std::string_view kStem = "layout";
  if (!name.starts_with(kStem)) return false;
  name.remove_prefix(kStem.size());
  if (const std::size_t end = std::min(name.find_first_not_of("0123456789", 1), name.size());
      name.starts_with('_') && end > 1)
    name.remove_prefix(end);
  return name == ".svg" || name == ".dxf" || name == ".png" || name == ".toml" || name == "_pieces.geojson";
}

bool is_ours(std::string_view name) { return is_of_sheet(name) || name == kNestLayoutName || name == kNestCardName; }

/// Whether a run that was killed may have left the file.
bool is_leftover(std::string_view name) {
  static const std::string ending = temporary_path("");
  return name.ends_with(ending) && is_ours(name.substr(0, name.size() - ending.size()));
}

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

void remove_file(const fs::path& file) {
  std::error_code error;
  fs::remove(file, error);
  if (error) throw EnvironmentError("cannot remove " + printable_utf8(file.string()) + ": " + error.message());
}

template <class Which>
void remove_files(const fs::path& folder, Which which) {
  for (const std::string& name : names_in(folder)) {
    if (which(name)) remove_file(folder / name);
  }
}

bool begins_with(const fs::path& file, const std::string& words) try {
  std::vector<std::uint8_t> first(words.size());
  read_at(file.string(), open_regular_file(file.string()), 0, first);
  return std::equal(first.begin(), first.end(), words.begin(), words.end());
} catch (const InputError&) {  // missing, or no file
  return false;
}

/// The first file that shows that the folder is not of tessera nest; empty: the folder may be used. A run that was killed
/// leaves its lock and temporary files, or its card without layout.json.
std::string foreign_file(const fs::path& folder) {
  const std::string program(kNestProgram);
  const std::set<std::string> names = names_in(folder);
  if (names.contains(kNestLayoutName))
    return begins_with(folder / kNestLayoutName, "{\n \"program\": \"" + program + "\",\n") ? "" : kNestLayoutName;
  if (begins_with(folder / kNestCardName, program + ": ")) return "";
  const std::string lock = fs::path(folder_lock_path(folder)).filename();
  for (const std::string& name : names) {
    if (name != lock && !is_leftover(name)) return name;
  }
  return "";
}

/// The folder, after a check that it may be used.
fs::path checked(const fs::path& folder) {
  const std::string shown = printable_utf8(folder.string());
  std::error_code ignored;
  if (!fs::exists(folder, ignored)) return folder;
  if (!fs::is_directory(folder, ignored))
    throw InputError("--out " + shown + ": exists and is no folder; give another name");
  if (const std::string file = foreign_file(folder); !file.empty()) {
    throw InputError("--out " + shown + ": exists, and its " + printable_utf8(file) +
                     " was not made by tessera nest; give another name");
  }
  for (const std::string& name : names_in(folder)) {
    if ((is_ours(name) || is_leftover(name)) && fs::is_directory(fs::symlink_status(folder / name)))
      throw EnvironmentError("cannot write " + shown + "/" + printable_utf8(name) + ": is a folder; remove it");
  }
  return folder;
}

std::string name_of_sheet(const NestRun& run, int sheet) {
  return run.layout.sheets > 1 ? "layout_" + std::to_string(sheet + 1) : "layout";
}

/// Writes files under temporary names, and removes those that do not get their final names.
class TemporaryFiles {
 public:
  TemporaryFiles(const fs::path& folder, std::size_t all, const BetweenFiles& between)
      : folder_(folder),
        all_(all),
        between_(between) {}
  ~TemporaryFiles() {
    std::error_code ignored;
    for (const std::string& name : names_) fs::remove(temporary_path((folder_ / name).string()), ignored);
  }
  TemporaryFiles(const TemporaryFiles&) = delete;
  TemporaryFiles& operator=(const TemporaryFiles&) = delete;

  void add(const std::string& name, std::span<const std::uint8_t> bytes) {
    between_(names_.size(), all_);
    TemporaryFile file((folder_ / name).string());
    file.write(bytes);
    file.leave();
    names_.push_back(name);  // a file that could not be written does not exist
  }
  void add(const std::string& name, std::string_view text) { add(name, bytes_of(text)); }

  /// Writes all bytes to the disk.
  void flush() const {
    constexpr std::size_t kAtOnce = 64;
    for (std::size_t first = 0; first < names_.size(); first += kAtOnce) {
      between_(names_.size(), all_);
      flush_left_files(folder_.string(), std::span(names_).subspan(first, std::min(kAtOnce, names_.size() - first)));
    }
  }

  /// Gives all files their final names, in the order in which they were added. To be called after flush().
  void take() const { take_left_files(folder_.string(), names_); }

 private:
  fs::path folder_;
  std::size_t all_;
  BetweenFiles between_;
  std::vector<std::string> names_;
};

std::size_t files_of_sheet(bool of_library) { return of_library ? 4 : 2; }

/// The time that the disk takes for files that are written, flushed and renamed together.
struct DiskSpeed {
  double wait_s = 0;  // for any number of files
  double file_s = 0;  // more for each file
  double seconds(double files) const { return wait_s + file_s * files; }
};

/// Writes, flushes and removes so many small files, and returns the seconds that it took.
double seconds_of_trial(const fs::path& folder, std::size_t count) {
  constexpr std::size_t kBytes = 4096;
  const std::string text(kBytes, ' ');
  const Stopwatch watch;
  {
    TemporaryFiles files(folder, count, [](std::size_t, std::size_t) {});
    for (std::size_t i = 1; i <= count; ++i) files.add("layout_" + std::to_string(i) + ".svg", text);
    files.flush();
  }
  return watch.seconds();
}

DiskSpeed measured_disk(const fs::path& folder) {
  constexpr std::size_t kFiles = 96;
  const double wait_s = seconds_of_trial(folder, 1);
  return {wait_s, std::max(0.0, seconds_of_trial(folder, kFiles) - wait_s) / double(kFiles)};
}

void add_sheet(const NestRun& run, int sheet, const fs::path& folder, TemporaryFiles& files) {
  const std::string name = name_of_sheet(run, sheet);
  const NestSheet cut = nest_sheet(run, sheet);
  files.add(name + ".svg", sheet_svg(cut));
  files.add(name + ".dxf", sheet_dxf(cut));
  if (run.input.library.empty()) return;
  const NestJob job = nest_job(run, sheet, folder.string(), name + "_pieces.geojson");
  files.add(name + "_pieces.geojson", job.pieces);
  files.add(name + ".toml", job.toml);
}

}  // namespace

NestFolder::NestFolder(const std::string& folder)
    : folder_(checked(folder)),
      made_(folder),
      lock_(folder_lock_path(folder), folder) {
  remove_files(folder_, is_leftover);
}

double NestFolder::seconds_to_write(bool of_library, double sheets) const {
  constexpr double kFew = 16, kMargin = 1.5;
  const double count = double(files_of_sheet(of_library)) * sheets;
  return count > kFew ? kMargin * measured_disk(folder_).seconds(count) : 0;
}

/// Removes the earlier layout. Without layout.json the folder has no whole layout until the new layout.json, the last file,
/// is written.
void NestFolder::remove_earlier() {
  remove_file(folder_ / kNestLayoutName);
  remove_files(folder_, is_of_sheet);
}

void NestFolder::write(const NestRun& run, const BetweenFiles& between) {
  const std::size_t of_sheets = files_of_sheet(!run.input.library.empty()) * std::size_t(run.layout.sheets);
  TemporaryFiles files(folder_, 2 + of_sheets, between);
  files.add(kNestCardName, nest_card_text(run));
  for (int sheet = 0; sheet < run.layout.sheets; ++sheet) add_sheet(run, sheet, folder_, files);
  files.add(kNestLayoutName, nest_layout_json(run));
  files.flush();
  remove_earlier();
  files.take();
}

void NestFolder::draw(const NestRun& run, const BetweenFiles& between) {
  constexpr int kAtOnce = 32;
  for (int first = 0; first < run.layout.sheets; first += kAtOnce)
    draw_some(run, first, std::min(first + kAtOnce, run.layout.sheets), between);
}

/// Draws the sheets from `first` to before `end`.
void NestFolder::draw_some(const NestRun& run, int first, int end, const BetweenFiles& between) {
  const BetweenFiles nothing = [](std::size_t, std::size_t) {};
  TemporaryFiles files(folder_, std::size_t(end - first), nothing);
  std::exception_ptr ended;
  try {
    for (int sheet = first; sheet < end; ++sheet) {
      between(std::size_t(sheet), std::size_t(run.layout.sheets));
      files.add(name_of_sheet(run, sheet) + ".png", sheet_png(nest_sheet(run, sheet)));
    }
  } catch (...) {
    ended = std::current_exception();
  }
  files.flush();
  files.take();
  if (ended) std::rethrow_exception(ended);
}

}  // namespace tessera
