#include "job/pieces/job_library.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "artwork/images/colour_conversion.h"
#include "core/base/error.h"
#include "job/job_tables.h"
#include "job/palette.h"
#include "job/pieces/start_pieces.h"
#include "job/pieces/wish_resolution.h"
#include "library/name_index.h"

namespace tessera {

std::vector<std::string> library_paths(const Job& job) {
  return job.library_files.empty() ? std::vector{job.library} : job.library_files;
}

std::string library_text(const Job& job) {
  std::string text;
  for (const std::string& path : library_paths(job)) text += (text.empty() ? "" : ", ") + path;
  return text;
}

namespace {

/// The rules for mirror images; for each shape the last table that mentions it wins.
std::vector<MirroringRule> mirroring_of(const Job& job) {
  std::vector<MirroringRule> rules = {{{"*"}, job.mirrored}};
  for (const JobRow& row : rows_of(job, "shapes")) {
    const auto cell = row.find("mirrored");
    if (cell == row.end()) continue;
    const std::vector<std::string>& words = mirroring_words();
    const auto word = std::find(words.begin(), words.end(), cell->second.text);
    rules.push_back({row.at("names").texts, Mirroring(word - words.begin())});
  }
  return rules;
}

ColourChoice colours_of(const Job& job) {
  ColourChoice choice;
  for (const std::string& colour : load_library_colours(job)) choice.palette.push_back(lab_of(bgr_of(colour)));
  choice.most_difference = float(job.library_colours_within);
  return choice;
}

}  // namespace

LibraryView open_library_of(const Job& job) {
  const ColourChoice colours = colours_of(job);
  try {
    return LibraryView({library_paths(job),
                        {job.library_include, job.library_exclude},
                        mirroring_of(job),
                        job.drawn_sizes,
                        colours,
                        wishes_style(job)});
  } catch (const NamesNotFound& error) {
    throw InputError(job.path + ": library." + error.what());
  } catch (const NoSuchColours& error) {
    throw InputError(job.path + ": library.colours: " + error.what());
  } catch (const InputError& error) {
    const char* key = job.library_files.empty() ? ": library.file: " : ": library.files: ";
    throw InputError(job.path + key + error.what() + "; allowed: a library made by tessera library build");
  }
}

std::vector<NamedShape> named_shapes(const ShapeLibrary& library) {
  constexpr LibraryParts kNamesOnly{.outline = false, .field = false, .levels = 0, .artwork = false};
  const std::vector<StyleFeatures> styles = library.styles();
  std::vector<NamedShape> shapes;
  for (Shape& shape : library.read(0, library.size(), kNamesOnly)) {
    shapes.push_back({std::move(shape.name), shape.drawn_scale_px, shape.artwork.mirrored, styles[shapes.size()]});
  }
  return shapes;
}

std::vector<std::string> names_like_patterns(const LibraryView& library, const Job& job) {
  std::set<std::string> patterns;
  const auto add = [&](const std::vector<std::string>& globs) {
    std::ranges::copy_if(globs, std::inserter(patterns, patterns.end()), is_pattern);
  };
  for (const JobRow& row : rows_of(job, "shapes")) add(row.at("names").texts);
  add(job.style.like);
  if (patterns.empty()) return {};
  std::vector<std::string> names = library.names_in_files();
  std::erase_if(names, [&](const std::string& name) { return !patterns.contains(name); });
  return names;
}

void resolve_wishes(const LibraryView& library, Job& job) {
  if (!has_shape_wishes(job)) return resolve_wishes(std::vector<NamedShape>(), job);
  resolve_wishes(named_shapes(library), job, names_like_patterns(library, job));
}

void add_start_pieces(const ShapeLibrary& library, Job& job) {
  if (!job.start.pieces.empty()) add_start_pieces(named_shapes(library), job);
}

}  // namespace tessera
