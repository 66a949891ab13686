// load_job: reads the file's entries in the order of its lines, then the overrides, and checks each against its key.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <deque>
#include <filesystem>
#include <numbers>
#include <set>
#include <sstream>
#include <utility>

#include "core/base/error.h"
#include "core/base/split_text.h"
#include "files/regular_file.h"
#include "job/job_entry.h"
#include "job/job_keys.h"
#include "job/job_tables.h"
#include "job/millimetres.h"
#include "job/palette.h"
#include "job/quality_word.h"
#include "job/wishes_file.h"
#include "text/number_text.h"
#include "text/text_encoding.h"

namespace tessera {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxOverrideBytes = 16384;
constexpr std::size_t kMostZones = 1000;  // this many take seconds on the largest canvas
// toml++ 3.3 builds and destroys a dotted key "a.a.a..." recursively; 32,000 levels overflow a stack of 8 MB.
constexpr std::size_t kMaxKeyLevels = 8192;
constexpr std::size_t kMaxNestedValues = 256;  // nested inline tables and arrays; the limit of toml++

std::string read_text(const std::string& path) {
  std::error_code error;
  if (fs::status(path, error).type() == fs::file_type::not_found) throw InputError("job file " + path + ": not found");
  try {
    return utf8_text(read_regular_file(path, kMaxJobBytes), path);
  } catch (const InputError& problem) {
    throw InputError(std::string("job file ") + problem.what());
  }
}

/// An upper bound of the levels of any key in the text. Each level needs a dot, and a dotted key ends with its line; a
/// key nested in it lies in an inline table.
std::size_t most_key_levels(const std::string& text) {
  std::size_t all = 0, in_line = 0, most_in_line = 0;
  for (const char c : text) {
    if (c == '\n') in_line = 0;
    if (c != '.') continue;
    ++all;
    most_in_line = std::max(most_in_line, ++in_line);
  }
  return std::min(all, kMaxNestedValues * most_in_line);
}

void check_size(const std::string& text, const std::string& path) {
  if (text.size() > kMaxJobBytes) {
    throw InputError(path + ": larger than " + std::to_string(kMaxJobBytes) + " bytes, the most allowed of a job");
  }
  if (most_key_levels(text) > kMaxKeyLevels) {
    throw InputError(path + ": more than " + std::to_string(kMaxKeyLevels) + " dots, the most allowed of a job");
  }
}

std::string line_of(const std::string& text, std::size_t number) {
  std::istringstream lines(text);
  std::string line;
  for (std::size_t i = 0; i < number; ++i) std::getline(lines, line);
  return line;
}

/// A hint for people who seldom write TOML and write fit = all.
std::string quotes_hint(const std::string& line) {
  const std::size_t equals = line.find('=');
  if (equals == std::string::npos) return "";
  const std::string_view value = trimmed(std::string_view(line).substr(equals + 1));
  if (value.empty() || !(std::isalpha(static_cast<unsigned char>(value[0])) || std::strchr("#/~.", value[0])))
    return "";
  return "; texts need quotes: \"" + printable(std::string(value), 60) + "\"";
}

toml::table parse(const std::string& text, const std::string& path) {
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    const std::size_t line = error.source().begin.line;
    throw InputError(path + ":" + std::to_string(line) + ": not TOML: " +
                     printable(std::string(error.description()), 200) + quotes_hint(line_of(text, line)));
  }
}

std::vector<JobEntry> entries_of(const toml::table& table, const std::string& path) {
  std::vector<std::pair<toml::source_index, JobEntry>> by_line;
  const fs::path base = fs::absolute(path).parent_path();
  const auto add = [&](const std::string& section, const std::string& name, const toml::node& value) {
    const auto line = value.source().begin.line;
    by_line.push_back({line, {section, name, &value, path + ":" + std::to_string(line), base}});
  };
  for (const auto& [name, node] : table) {
    const toml::table* section = node.as_table();
    const std::string text(name.str());
    if (find_job_table(text) && node.is_array_of_tables()) continue;
    if (!section || find_job_key("", text)) {
      add("", text, node);
    } else if (section->empty() && !is_job_section(text)) {
      add(text, "", node);
    } else {
      for (const auto& [key, value] : *section) add(text, std::string(key.str()), value);
    }
  }
  std::stable_sort(by_line.begin(), by_line.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<JobEntry> entries;
  for (auto& [line, entry] : by_line) entries.push_back(std::move(entry));
  return entries;
}

void add_rows(const toml::table& table, const std::string& path, Job& job) {
  const auto where = [&](const toml::node& node) { return path + ":" + std::to_string(node.source().begin.line); };
  for (const JobTable& known : job_tables()) {
    const toml::node* node = table.get(known.name);
    if (!node || !node->is_array_of_tables()) continue;
    for (const toml::node& row : *node->as_array()) add_row(known, *row.as_table(), where, job);
  }
}

std::string without_blanks(std::string text) {
  std::erase(text, ' ');
  return text;
}

std::string place_of(const std::string& override) { return "--set " + printable(override); }

/// The entry of an override; `table` keeps its value.
JobEntry entry_of(const std::string& text, toml::table& table) {
  const std::string where = place_of(text);
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0) throw InputError(where + ": allowed: section.key=value");
  if (text.size() > kMaxOverrideBytes) {
    throw InputError(where + ": longer than the allowed " + std::to_string(kMaxOverrideBytes) + " bytes");
  }
  const std::string name = without_blanks(text.substr(0, equals));
  const auto dot = name.find('.');
  const bool top_level = dot == std::string::npos;
  table = parse_value(text.substr(equals + 1));
  return {.section = top_level ? "" : name.substr(0, dot),
          .name = top_level ? name : name.substr(dot + 1),
          .value = table.get("value"),
          .where = where,
          .base = fs::current_path()};
}

/// The entries of a job: those of the file, then those of the command line, which override them.
class Entries {
 public:
  Entries(std::vector<JobEntry> of_file, const std::vector<std::string>& overrides)
      : entries_(std::move(of_file)),
        in_file_(entries_.size()) {
    for (const std::string& text : overrides) entries_.push_back(entry_of(text, tables_.emplace_back()));
  }

  const std::vector<JobEntry>& all() const { return entries_; }

  bool has(const std::string& section, const std::string& name) const {
    return given_from(0, entries_.size(), section, name);
  }

  /// Whether `quality` applies: numbers beside it win, but on the command line it wins over numbers of the file.
  bool quality_counts() const {
    const bool of_command_line = given_from(in_file_, entries_.size(), "", "quality");
    const std::size_t begin = of_command_line ? in_file_ : 0;
    return !given_from(begin, entries_.size(), "improve", "trials") &&
           !given_from(begin, entries_.size(), "improve", "seconds");
  }

  void apply_all_but_mm(Job& job) const {
    for (const JobEntry& entry : entries_) {
      if (!is_length_in_mm(entry)) apply_entry(entry, job);
    }
  }

  /// Applies lengths in mm, once the canvas' size is known.
  void apply_mm(Job& job) const {
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      const JobEntry& entry = entries_[i];
      if (!is_length_in_mm(entry)) continue;
      const std::string in_px = name_in_px(entry.name);
      if (i < in_file_ && given_from(0, in_file_, entry.section, in_px)) {
        throw InputError(entry.where + ": " + entry.section + "." + entry.name + " and " + entry.section + "." + in_px +
                         kBothAreGiven);
      }
      const bool replaced = given_from(std::max(i, in_file_), entries_.size(), entry.section, in_px);
      if (!replaced) apply_entry(entry, job);
    }
  }

 private:
  bool given_from(std::size_t begin, std::size_t end, const std::string& section, const std::string& name) const {
    return std::any_of(entries_.begin() + std::ptrdiff_t(begin), entries_.begin() + std::ptrdiff_t(end),
                       [&](const JobEntry& entry) { return entry.section == section && entry.name == name; });
  }

  std::deque<toml::table> tables_;  // they keep the values of the command line
  std::vector<JobEntry> entries_;
  std::size_t in_file_;
};

/// Sets the size in px where the job gives only mm.
void set_size_on_paper(bool px_are_given, Job& job) {
  if (job.canvas.width_mm == 0) return;
  try {
    if (!px_are_given) set_default_px(job.canvas);
    check_aspect(job.canvas);
  } catch (const InputError& error) {
    throw InputError(job.path + ": " + error.what());
  }
}

/// Copies what the canvas and the pictures need from [[regions]].
void set_regions(Job& job) {
  for (const JobRow& region : rows_of(job, "regions")) {
    job.canvas.region_colours.push_back(region.at("colour").text);
    const auto background = region.find("background");
    job.canvas.region_backgrounds.push_back(background == region.end() ? "" : background->second.text);
  }
}

void check_required(const Job& job) {
  for (const JobKey& key : job_keys()) {
    if (!key.required) continue;
    const bool missing = key.get(job).text.empty();
    const JobKey* list = find_job_key(key.section, key.or_list);
    const bool listed = list && !list->get(job).texts.empty();
    if (missing && !listed) {
      throw InputError(job.path + ": " + key.full_name() + " is missing; needed: " + key.meaning);
    }
    if (!missing && listed) {
      throw InputError(job.path + ": " + key.full_name() + " and " + list->full_name() +
                       ": both are given; allowed: one of them, the other empty");
    }
  }
}

KeepOutRectangle keep_out_rectangle(const JobRow& row) {
  const std::vector<double>& at_px = row.at("at_px").numbers;
  const std::vector<double>& size_px = row.at("size_px").numbers;
  const auto number = [&](const char* column) {
    const auto cell = row.find(column);
    return cell == row.end() ? 0 : cell->second.numbers[0];
  };
  const double rotation_rad = number("rotation_deg") * std::numbers::pi / 180;
  return {.middle_px = {float(at_px[0]), float(at_px[1])},
          .half_size_px = {float(size_px[0] / 2), float(size_px[1] / 2)},
          .across = {float(std::cos(rotation_rad)), float(std::sin(rotation_rad))},
          .corner_px = float(number("corner_px"))};
}

/// Checks start.remove and start.lock: they need start.pieces, and no piece may be in both. With removed pieces only
/// their room is filled, and free pieces cannot lie outside it.
void check_start_lists(const Job& job) {
  const StartSpec& start = job.start;
  for (const auto& [key, list] : {std::pair("start.remove", &start.remove), std::pair("start.lock", &start.lock)}) {
    if (list->empty() || !start.pieces.empty()) continue;
    throw InputError(job.path + ": " + key + ": found pieces, allowed without start.pieces: []");
  }
  if (!start.remove.empty() && start.keep == StartKeep::free) {
    throw InputError(job.path +
                     ": start.remove: found with start.keep = \"free\", allowed: \"standing\" or \"locked\"");
  }
  const std::set<int> removed(start.remove.begin(), start.remove.end());
  for (const int index : start.lock) {
    if (!removed.contains(index)) continue;
    throw InputError(job.path + ": start.lock: found " + std::to_string(index) + ", which start.remove has, too");
  }
}

void check_background(const Job& job) {
  if (job.output.background == kPhotoBackground && job.settings.deform.kind != DeformKind::none) {
    throw InputError(job.path + ": output.background: found \"" + kPhotoBackground +
                     "\" with deform.kind, allowed: one of them, because deformed pieces have left their photo");
  }
  if (job.output.background != kImageBackground) return;
  const std::string found = job.path + ": output.background: found \"" + kImageBackground + "\"";
  if (job.colour.image.empty()) throw InputError(found + ", needed with it: colour.image");
  if (!job.output.ground.empty()) throw InputError(found + " with output.ground, allowed: one of them");
}

void check_overlay(const Job& job) {
  if (job.colour.overlay == 0 || !job.colour.image.empty()) return;
  throw InputError(job.path + ": colour.overlay: found " + significant(job.colour.overlay, 3) +
                   ", allowed without colour.image: 0");
}

/// Checks the drawing keys that require or exclude each other.
void check_drawing(const Job& job) {
  check_background(job);
  check_overlay(job);
}

/// Checks keys that depend on each other.
void check_together(const Job& job) {
  check_drawing(job);
  if (job.canvas.keep_out_rectangles.size() > kMostZones) {
    throw InputError(job.path + ": found " + std::to_string(job.canvas.keep_out_rectangles.size()) +
                     " [[keep_out]], allowed: " + std::to_string(kMostZones) + "; canvas.keep_out may show any number");
  }
  if (!job.canvas.region_colours.empty() && job.canvas.file.empty()) {
    throw InputError(job.path +
                     ": [[regions]] are parts of canvas.file, which is missing; needed: an SVG or image with them");
  }
  check_start_lists(job);
  if (job.settings.start.grow_outward && job.canvas.seamless != Seamless::none) {
    throw InputError(job.path + ": start.grow: found \"outward\" with canvas.seamless, allowed with it: \"inward\"");
  }
}

Job read_job(const std::string& text, const std::string& path, const std::vector<std::string>& overrides) {
  check_size(text, path);
  Job job;
  job.path = path;
  const toml::table table = parse(text, path);
  const Entries entries(entries_of(table, path), overrides);
  entries.apply_all_but_mm(job);
  set_size_on_paper(entries.has("canvas", "size_px"), job);
  entries.apply_mm(job);
  if (!entries.quality_counts()) job.quality = QualityWord::none;
  if (!quality_waits_for_sizes(job)) set_improving_by_quality(job);  // else CanvasProblem does it
  add_rows(table, path, job);
  set_regions(job);
  for (const JobRow& row : rows_of(job, "keep_out")) job.canvas.keep_out_rectangles.push_back(keep_out_rectangle(row));
  if (!job.wishes.empty()) {
    add_wishes_of_file(job);
    check_size(to_toml(job), job.path + ": with the rows of library.wishes");
  }
  check_required(job);
  check_together(job);
  return job;
}

}  // namespace

Job load_job(const std::string& path, const std::vector<std::string>& overrides) {
  Job job = read_job(read_text(path), path, overrides);
  // Loaded here, so that all ranks have the same colours and a result does not need the palette's file.
  if (const std::vector<std::string> colours = load_library_colours(job); !colours.empty())
    job.library_colours = colours;
  return job;
}

bool set_drawing_keys(Job& job, const std::vector<std::string>& overrides) {
  const Entries entries({}, overrides);
  bool silhouettes = false;
  for (const JobEntry& entry : entries.all()) {
    silhouettes |= entry.section == "colour" && (entry.name == "pieces" || entry.name == "palette");
    if (entry.section != "output" && entry.section != "colour") {
      throw InputError(entry.where + ": allowed where a result is drawn: output.key=value or colour.key=value");
    }
    const JobKey* key = find_job_key(entry.section, entry.name);
    if (!key || !key->decides) continue;
    throw InputError(entry.where +
                     ": this key decides where pieces lie; set it in the job, and run tessera collage "
                     "again");
  }
  entries.apply_all_but_mm(job);
  entries.apply_mm(job);
  check_drawing(job);
  return silhouettes;
}

Job job_from_toml(const std::string& text, const std::string& path) { return read_job(text, path, {}); }

Job checked_job(const Job& job) { return job_from_toml(to_toml(job), job.path); }

}  // namespace tessera
