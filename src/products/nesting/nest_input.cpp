#include "products/nesting/nest_input.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "artwork/drawers/drawers.h"
#include "core/base/count_text.h"
#include "core/base/error.h"
#include "core/base/too_many.h"
#include "files/regular_file.h"
#include "library/library_view.h"
#include "library/name_index.h"
#include "products/nesting/drawings/dxf_drawings.h"
#include "products/nesting/drawings/svg_drawings.h"
#include "products/nesting/layout/search_outline.h"
#include "products/nesting/nest_instance.h"
#include "products/nesting/unknown_units.h"
#include "text/text_encoding.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFileBytes = std::size_t(64) << 20;
constexpr std::size_t kMostFolderPoints = 2'000'000;
constexpr double kMmOfPx = 25.4 / 96;  // for drawings without another unit

enum class Kind { instance, svg, dxf, library, other };

Kind kind_of(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : char(c); });
  if (ending == ".json") return Kind::instance;
  if (ending == ".svg" || ending == ".svgz") return Kind::svg;
  if (ending == ".dxf") return Kind::dxf;
  return ending == ".h5" ? Kind::library : Kind::other;
}

std::string shown_path(const fs::path& path) { return printable_utf8(path.string()); }

/// Reads files, one after the other.
class FileReader {
 public:
  FileReader(const NestReading& reading, NestInput& input)
      : reading_(reading),
        input_(input),
        not_found_(reading.left_out.begin(), reading.left_out.end()) {}

  void add(const fs::path& path) {
    const std::vector<std::uint8_t> bytes = read_regular_file(path.string(), kMostFileBytes);
    const std::string shown = shown_path(path);
    if (kind_of(path) == Kind::svg)
      add_svg(bytes, shown);
    else
      add_dxf(bytes, shown, printable_utf8(path.stem().string()));
  }

  /// Ends the reading after the last file. Throws InputError where --leave-out or --dpi had no effect.
  void end(const std::string& path) const {
    if (!not_found_.empty()) {
      const std::string example = example_.empty() ? "" : ", as " + printable_utf8(example_);
      throw InputError("--leave-out " + printable_utf8(*not_found_.begin()) +
                       ": fits no outline of an SVG; allowed: the id of an element that draws one" + example);
    }
    if (reading_.px_per_inch && example_.empty())
      throw InputError("--dpi: " + path + " has no SVG with an outline; allowed: with an SVG");
    units_.report(path, input_);
  }

 private:
  void add_svg(std::span<const std::uint8_t> bytes, const std::string& shown) {
    const double px_per_inch = reading_.px_per_inch.value_or(kCssPxPerInch);
    const SvgOutlines outlines = drawers_.svg_outlines(bytes, shown, px_per_inch);
    SvgDrawings found = svg_drawings(outlines, shown, reading_.left_out);
    for (const SvgOutline& outline : outlines.outlines) not_found_.erase(outline.name);
    if (example_.empty() && !outlines.outlines.empty()) example_ = outlines.outlines.front().name;
    add_notes(found.notes, shown);
    if (!reading_.px_per_inch) units_.add_svg(shown, outlines, found.drawings);
    add_drawings(std::move(found.drawings));
  }

  void add_dxf(std::span<const std::uint8_t> bytes, const std::string& shown, const std::string& stem) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    DxfDrawings found = dxf_drawings(text, shown, stem);
    add_notes(found.notes, shown);
    if (!found.says_unit) units_.add_dxf(shown, found);
    add_drawings(std::move(found.drawings));
  }

  void add_notes(const std::vector<std::string>& notes, const std::string& shown) {
    for (const std::string& note : notes) input_.notes.push_back(shown + ": " + note);
  }

  void add_drawings(std::vector<NestDrawing> drawings) {
    for (NestDrawing& drawing : drawings) input_.sources.emplace_back().drawing = std::move(drawing);
  }

  const NestReading& reading_;
  NestInput& input_;
  UnknownUnits units_;
  std::set<std::string> not_found_;  // elements to be left out
  std::string example_;              // an element that could be left out
  Drawers drawers_{{.processes = 1}};
};

struct FolderFiles {
  std::vector<fs::path> drawings;
  std::set<std::string> others;  // names of drawings that are no regular files
  std::set<std::string> unread;  // files of other kinds
};

FolderFiles drawings_in(const fs::path& folder) {
  FolderFiles files;
  std::error_code error;
  for (fs::directory_iterator at(folder, error); !error && at != fs::directory_iterator(); at.increment(error)) {
    const Kind kind = kind_of(at->path());
    std::error_code ignored;
    if (kind != Kind::svg && kind != Kind::dxf) {
      const std::string name = printable_utf8(at->path().filename().string());
      if (at->is_regular_file(ignored) && !name.starts_with('.')) files.unread.insert(name);
      continue;
    }
    if (at->is_regular_file(ignored))
      files.drawings.push_back(at->path());
    else
      files.others.insert(printable_utf8(at->path().filename().string()));
  }
  if (error) throw InputError(shown_path(folder) + ": cannot be read: " + error.message());
  std::sort(files.drawings.begin(), files.drawings.end());
  return files;
}

/// Makes a drawing that is alone in its file known by the file's name, too.
void add_file_name(const fs::path& file, NestInput& input) {
  const std::string stem = printable_utf8(file.stem().string());
  if (input.sources.size() == 1 && input.sources.front().drawing.name != stem) input.sources.front().other_name = stem;
}

/// Names the drawings of a file in a folder after the file: a single one by its name, several by its name before their own.
void name_by_file(const fs::path& file, std::size_t first, NestInput& input) {
  const std::string stem = printable_utf8(file.stem().string());
  const bool one = input.sources.size() == first + 1;
  for (std::size_t i = first; i < input.sources.size(); ++i) {
    std::string& name = input.sources[i].drawing.name;
    if (one && name != stem) input.sources[i].other_name = std::exchange(name, stem);
    if (!one && !name.starts_with(stem)) name = stem + "." + name;
  }
}

std::string joined(const std::set<std::string>& names) {
  constexpr std::size_t kMostBytes = 200;
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : ", ") + name;
    if (text.size() > kMostBytes) break;
  }
  return cut_utf8(text, kMostBytes);
}

void add_folder(const fs::path& folder, FileReader& reader, NestInput& input) {
  const auto [files, others, unread] = drawings_in(folder);
  if (!others.empty()) {
    input.notes.push_back(
        shown_path(folder) + ": left out " +
        count_text(others.size(), "name that is no regular file: ", "names that are no regular files: ") +
        joined(others));
  }
  if (!unread.empty()) {
    input.notes.push_back(
        shown_path(folder) + ": left out " +
        count_text(unread.size(), "file that is neither SVG nor DXF: ", "files that are neither SVG nor DXF: ") +
        joined(unread));
  }
  std::size_t points = 0;
  std::string refusal;            // of the first file that cannot be used
  std::set<std::string> refused;  // the other such files: all are reported at once
  for (const fs::path& file : files) {
    const std::size_t before = input.sources.size();
    try {
      reader.add(file);
    } catch (const InputError& error) {
      if (refusal.empty())
        refusal = error.what();
      else
        refused.insert(printable_utf8(file.filename().string()));
      continue;
    }
    if (input.sources.size() == before) input.notes.push_back(shown_path(file) + ": found no closed shape");
    name_by_file(file, before, input);
    if (input.sources.size() > kMostDrawings) {
      throw InputError(shown_path(folder) + ": found " + std::to_string(input.sources.size()) +
                       " shapes or more, allowed: " + std::to_string(kMostDrawings));
    }
    for (std::size_t i = before; i < input.sources.size(); ++i) points += points_of(input.sources[i].drawing);
    if (points > kMostFolderPoints) {
      throw InputError(shown_path(folder) + ": " + too_many(kMostFolderPoints, "points in its files"));
    }
  }
  if (refusal.empty()) return;
  if (!refused.empty()) {
    refusal += "; " + count_text(refused.size(), "more file cannot be used: ", "more files cannot be used: ") +
               joined(refused);
  }
  throw InputError(refusal);
}

NestRing in_mm(const std::vector<Vec2>& curve, double mm) {
  NestRing ring;
  for (const Vec2 p : curve) ring.push_back({double(p.x) * mm, double(p.y) * mm});
  return ring;
}

void add_library(const std::string& path, NestInput& input) {
  input.library = path;
  const LibraryView library({.files = {path}, .names = {}});
  if (library.size() > kMostDrawings) {
    throw InputError(shown_path(path) + ": found " + std::to_string(library.size()) +
                     " shapes, allowed: " + std::to_string(kMostDrawings) + " (tessera library subset)");
  }
  for (const Shape& shape :
       library.read(0, library.size(), {.outline = true, .field = false, .levels = 0, .artwork = false})) {
    if (!(shape.drawn_scale_px > 0)) {
      throw InputError(shown_path(path) + ": does not say how large \"" + printable_utf8(shape.name) +
                       "\" was drawn, because an earlier version built it; tessera library build makes one that does");
    }
    NestSource& source = input.sources.emplace_back();
    source.mm_per_shape = double(shape.drawn_scale_px) * kMmOfPx;
    source.drawing.name = shape.name;
    for (const std::vector<Vec2>& curve : shape.outline.curves) {
      NestRing ring = in_mm(curve, source.mm_per_shape);
      if (source.drawing.outline.empty())
        source.drawing.outline = std::move(ring);
      else
        source.drawing.holes.push_back(std::move(ring));
    }
  }
}

void make_names_unique(NestInput& input) {
  std::set<std::string> names;
  for (NestSource& source : input.sources) {
    const std::string name = source.drawing.name;
    for (int i = 2; !names.insert(source.drawing.name).second; ++i)
      source.drawing.name = name + "_" + std::to_string(i);
  }
}

/// Removes sides that go out and straight back: they would be cut, and would overlap pieces beside them.
void remove_spikes(const std::string& path, NestInput& input) {
  for (NestSource& source : input.sources) {
    NestRing outline = without_spikes(source.drawing.outline);
    if (outline.size() == source.drawing.outline.size()) continue;
    source.drawing.outline = std::move(outline);
    if (!source.drawing.curves.empty()) source.drawing.curves.front().clear();
    input.notes.push_back(printable_utf8(path) + ": " + source.drawing.name +
                          ": left out sides that go out and straight back: they enclose nothing");
  }
}

/// The first notes: the drawing that the user misses may have been left out.
std::string first_notes(const NestInput& input) {
  constexpr std::size_t kMostNotes = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(kMostNotes, input.notes.size()); ++i) text += "; " + input.notes[i];
  return text;
}

}  // namespace

std::size_t points_to_cut(const NestInput& input) {
  std::size_t points = 0;
  for (const NestSource& source : input.sources) points += points_of(source.drawing) * std::size_t(source.demand);
  return points;
}

NestInput read_nest_input(const std::string& path, const NestReading& reading) {
  NestInput input;
  FileReader reader(reading, input);
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    add_folder(path, reader, input);
  } else if (const Kind kind = kind_of(path); kind == Kind::instance) {
    const std::string shown = printable_utf8(path);
    input = nest_instance(utf8_text(read_regular_file(path, kMostFileBytes), shown), shown);
    input.unit = "1 mm";
  } else if (kind == Kind::library) {
    add_library(path, input);
    input.unit = "1/96 inch";
  } else if (kind != Kind::other) {
    reader.add(path);
    add_file_name(path, input);
  } else {
    throw InputError(printable_utf8(path) +
                     ": allowed: an instance (.json), .svg, .svgz, .dxf, a library (.h5), or a folder");
  }
  if (input.sources.empty()) {
    throw InputError(printable_utf8(path) + ": found no closed shape; open lines enclose nothing" + first_notes(input));
  }
  fs::path name = fs::absolute(path).lexically_normal();
  if (!name.has_filename()) name = name.parent_path();
  input.name = printable_utf8(fs::is_directory(path, ignored) ? name.filename().string() : name.stem().string());
  for (std::size_t i = 0; i < input.sources.size(); ++i) input.sources[i].number = int(i);
  make_names_unique(input);
  remove_spikes(path, input);
  reader.end(printable_utf8(path));
  return input;
}

namespace {

/// Some of the names, for people who look for the right one.
std::string names_of(const NestInput& input) {
  constexpr std::size_t kMostBytes = 200;
  std::string names;
  for (const NestSource& source : input.sources) {
    names += (names.empty() ? "" : ", ") + printable_utf8(source.drawing.name);
    if (!source.other_name.empty()) names += " or " + printable_utf8(source.other_name);
    if (names.size() > kMostBytes) break;
  }
  return cut_utf8(names, kMostBytes);
}

}  // namespace

void set_demands(NestInput& input, const std::vector<std::pair<std::string, int>>& demands) {
  std::vector<std::string> names, other_names;
  std::vector<std::uint32_t> place_of_other;
  for (const NestSource& source : input.sources) {
    if (!source.other_name.empty()) {
      place_of_other.push_back(std::uint32_t(names.size()));
      other_names.push_back(source.other_name);
    }
    names.push_back(source.drawing.name);
  }
  const NameIndex index(std::move(names)), others(std::move(other_names));
  for (const auto& [pattern, demand] : demands) {
    std::vector<std::uint32_t> places = index.matching(pattern);
    if (places.empty()) {
      for (const std::uint32_t other : others.matching(pattern)) places.push_back(place_of_other[other]);
    }
    for (const std::uint32_t place : places) input.sources[place].demand = demand;
    if (places.empty())
      throw InputError("--demand " + printable_utf8(pattern) + ": fits no name of a shape; allowed: patterns of " +
                       names_of(input));
  }
  std::erase_if(input.sources, [](const NestSource& source) { return source.demand <= 0; });
}

}  // namespace tessera
