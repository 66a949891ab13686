#include "library/library_view.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <map>
#include <span>
#include <unordered_map>
#include <utility>

#include "core/base/digest.h"
#include "core/base/error.h"
#include "core/base/split_text.h"
#include "core/colour/palette_difference.h"
#include "core/shape/mirrored_shape.h"
#include "library/library_names.h"
#include "library/same_colour.h"
#include "library/style_reference.h"
#include "text/number_text.h"

namespace tessera {
namespace {

constexpr std::size_t kHeadsAtATime = 1024;  // heads read at a time, some 400 bytes each

constexpr LibraryParts kColourParts{.outline = false, .field = false, .levels = 0, .artwork = false};
constexpr LibraryParts kArtwork{.outline = false, .field = false, .levels = 0, .artwork = true, .original = false};

std::string parameters_text(const PadParameters& pad) {
  return "--pad-levels " + std::to_string(pad.levels) + " --delta-tau " + fixed(pad.delta_tau, 6);
}

void check_built_alike(const std::vector<LibraryFile>& files) {
  const LibraryFile& first = files.front();
  for (const LibraryFile& file : files) {
    if (file.pad_parameters() == first.pad_parameters()) continue;
    throw InputError(file.path() + ": built with " + parameters_text(file.pad_parameters()) + ", but " + first.path() +
                     " with " + parameters_text(first.pad_parameters()) +
                     "; allowed: libraries built alike (tessera library build)");
  }
}

template <class Library, class Take>
void for_each_head(const Library& library, Take take) {
  for (std::size_t at = 0; at < library.size(); at += kHeadsAtATime) {
    std::size_t index = at;
    for (ShapeHead& head : library.heads(at, std::min(library.size(), at + kHeadsAtATime)))
      take(index++, std::move(head));
  }
}

/// The names of all shapes of the files, one file after the other.
std::vector<std::string> names_of(const std::vector<LibraryFile>& files) {
  std::vector<std::string> names;
  for (const LibraryFile& file : files)
    for_each_head(file, [&](std::size_t, ShapeHead head) { names.push_back(std::move(head.name)); });
  return names;
}

/// For each shape of the files, one after the other, whether it is chosen.
std::vector<bool> chosen_shapes(const std::vector<LibraryFile>& files, const std::string& path,
                                const NameGlobs& globs) {
  const NameIndex index(names_of(files));
  std::vector<bool> chosen(index.names().size());
  for (const std::uint32_t place : chosen_names(index, globs, path)) chosen[place] = true;
  return chosen;
}

float difference_of(const LibraryFile& file, const Shape& shape, const std::vector<Lab>& palette) {
  if (shape.colour_grid.known()) return palette_difference(shape.colour_grid, palette);
  throw InputError(file.path() + " does not know the colours of " + shape.name +
                   "'s parts, because an older version built it; build it again");
}

/// Removes drawings of other colours from the choice.
void keep_colours(const std::vector<LibraryFile>& files, const ColourChoice& choice, std::vector<bool>& chosen) {
  if (choice.palette.empty()) return;
  float nearest = std::numeric_limits<float>::infinity();
  std::size_t place = 0;
  for (const LibraryFile& file : files) {
    for (std::size_t at = 0; at < file.size(); at += kHeadsAtATime) {
      for (const Shape& shape : file.read(at, std::min(file.size(), at + kHeadsAtATime), kColourParts)) {
        const std::size_t own = place++;
        if (!chosen[own]) continue;
        const float difference = difference_of(file, shape, choice.palette);
        nearest = std::min(nearest, difference);
        chosen[own] = difference <= choice.most_difference;
      }
    }
  }
  if (std::find(chosen.begin(), chosen.end(), true) != chosen.end()) return;
  throw NoSuchColours("no drawing that is chosen is within " + fixed(double(choice.most_difference), 1) +
                      " CIEDE2000 of these colours; the nearest is at " + fixed(double(nearest), 1));
}

/// The style of each shape of the files, one after the other.
std::vector<StylePlace> known_styles(const std::vector<LibraryFile>& files, std::vector<std::string>& names) {
  std::vector<StylePlace> places;
  for (const LibraryFile& file : files) {
    for_each_head(file, [&](std::size_t, ShapeHead head) {
      if (!head.style.known()) throw InputError(unknown_style_text(file.path(), head.name));
      places.push_back(style_place(head.style));
      names.push_back(std::move(head.name));
    });
  }
  return places;
}

/// Removes drawings of other styles from the choice. The nearest are kept; of equally near ones the first.
void keep_style(const std::vector<LibraryFile>& files, const StyleChoice& choice, std::vector<bool>& chosen) {
  if (choice.like.empty()) return;
  std::vector<std::string> names;
  const std::vector<StylePlace> places = known_styles(files, names);
  const StylePlace like = style_reference(NameIndex(std::move(names)), places, choice.like);
  std::vector<std::pair<float, std::size_t>> by_distance;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (chosen[i]) by_distance.emplace_back(style_distance(places[i], like), i);
  }
  std::sort(by_distance.begin(), by_distance.end());
  if (choice.closest) by_distance.resize(std::min(by_distance.size(), *choice.closest));
  chosen.assign(chosen.size(), false);
  for (const auto& [distance, place] : by_distance) chosen[place] = !choice.within || distance <= *choice.within;
  if (std::find(chosen.begin(), chosen.end(), true) != chosen.end()) return;
  throw InputError("no drawing that is chosen is within " + fixed(double(choice.within.value_or(0)), 2) +
                   " of the style of " + joined(choice.like) + "; the nearest is at " +
                   fixed(double(by_distance.front().first), 2));
}

/// The mirroring of each name, by the last rule that matches the name.
std::vector<Mirroring> mirroring_of(const NameIndex& names, const std::vector<MirroringRule>& rules) {
  std::vector<Mirroring> mirroring(names.names().size(), Mirroring::never);
  for (const MirroringRule& rule : rules) {
    for (const std::string& glob : rule.names) {
      for (const std::uint32_t place : names.matching(glob)) mirroring[place] = rule.mirroring;
    }
  }
  return mirroring;
}

}  // namespace

/// Gathers the entries of a view one by one.
class LibraryView::Gathering {
 public:
  explicit Gathering(LibraryView& view) : view_(view) {}

  void add(std::uint32_t file, std::uint32_t index, const ShapeHead& head) {
    const std::size_t family = family_of(file, head);
    std::vector<Member>& members = families_[family];
    const auto twin = std::find_if(members.begin(), members.end(),
                                   [&](const Member& m) { return same_colour(m.mean_lab, head.mean_lab); });
    if (several_files() && twin != members.end()) {
      view_.twins_.push_back({view_.files_[file].path(), head.name, twin->name});
      return;
    }
    const std::string name = unique_name(file, index, head.name);
    const auto own = std::uint32_t(view_.entries_.size());
    members.push_back({own, head.mean_lab, name});
    view_.entries_.push_back(
        {file, index, members.front().entry, name == head.name ? std::string() : name, false, own});
  }

 private:
  /// A shape of a family; a family has one outline.
  struct Member {
    std::uint32_t entry;
    std::array<float, 3> mean_lab;
    std::string name;
  };

  bool several_files() const { return view_.files_.size() > 1; }

  /// The family of the shape: within a file the one that the file tells, across files the one with the same outline.
  std::size_t family_of(std::uint32_t file, const ShapeHead& head) {
    const std::pair source(file, head.variant_of);
    std::size_t family = families_.size();
    if (const auto known = of_source_.find(source); known != of_source_.end()) {
      family = known->second;
    } else if (const auto equal = of_outline_.find(head.outline_digest()); equal != of_outline_.end()) {
      family = equal->second;
    }
    if (family == families_.size()) families_.emplace_back();
    of_source_.try_emplace(source, family);
    if (several_files()) of_outline_.try_emplace(head.outline_digest(), family);
    return family;
  }

  std::string unique_name(std::uint32_t file, std::uint32_t index, const std::string& name) {
    if (names_.take(name)) return name;
    const Shape shape = std::move(view_.files_[file].read(index, index + 1, kArtwork).front());
    return names_.unique(name, shape.artwork.path);
  }

  LibraryView& view_;
  LibraryNames names_;
  std::vector<std::vector<Member>> families_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> of_source_;  // by file and first shape in it
  std::unordered_map<std::uint64_t, std::size_t> of_outline_;
};

LibraryView::LibraryView(const LibraryChoice& choice) : drawn_sizes_(choice.drawn_sizes), styles_(choice.styles) {
  for (const std::string& file : choice.files) files_.emplace_back(file);
  path_ = joined(choice.files);
  check_built_alike(files_);
  const bool mirrors = std::any_of(choice.mirroring.begin(), choice.mirroring.end(),
                                   [](const MirroringRule& rule) { return rule.mirroring != Mirroring::never; });
  if (files_.size() == 1 && choice.names.empty() && choice.colours.palette.empty() && choice.style.like.empty() &&
      !mirrors)
    return;
  gather(choice);
  if (mirrors) add_mirror_images(choice.mirroring);
}

void LibraryView::gather(const LibraryChoice& choice) {
  std::vector<bool> chosen = chosen_shapes(files_, path_, choice.names);
  keep_colours(files_, choice.colours, chosen);
  keep_style(files_, choice.style, chosen);
  if (chosen.size() > layout::kMaxShapes) throw InputError(path_ + ": too many shapes");
  Gathering gathering(*this);
  std::size_t at = 0;
  for (std::uint32_t file = 0; file < files_.size(); ++file) {
    for_each_head(files_[file], [&](std::size_t index, const ShapeHead& head) {
      if (chosen[at++]) gathering.add(file, std::uint32_t(index), head);
    });
  }
}

std::vector<std::string> LibraryView::names() const {
  std::vector<std::string> names;
  for_each_head(*this, [&](std::size_t, ShapeHead head) { names.push_back(std::move(head.name)); });
  return names;
}

std::vector<std::string> LibraryView::names_in_files() const { return names_of(files_); }

std::vector<float> LibraryView::drawn_scales_px() const {
  std::vector<float> scales_px;
  for_each_head(*this, [&](std::size_t, const ShapeHead& head) { scales_px.push_back(head.drawn_scale_px); });
  return scales_px;
}

void LibraryView::add_mirror_images(const std::vector<MirroringRule>& rules) {
  const std::vector<Mirroring> mirroring = mirroring_of(NameIndex(names(), names_in_files()), rules);
  for (std::uint32_t own = 0; own < mirroring.size(); ++own) {
    if (mirroring[own] == Mirroring::never) continue;
    Entry image = entries_[own];
    image.mirrored = true;
    if (mirroring[own] == Mirroring::only) {
      entries_[own] = image;
    } else {
      entries_.push_back(image);
    }
  }
  if (entries_.size() > layout::kMaxShapes) throw InputError(path_ + ": too many shapes with their mirror images");
}

std::uint64_t LibraryView::content_digest() const {
  const std::uint64_t shapes =
      digest_of_heads(pad_parameters(), size(), [&](std::size_t begin, std::size_t end) { return heads(begin, end); });
  const bool mirrors = std::any_of(entries_.begin(), entries_.end(), [](const Entry& entry) { return entry.mirrored; });
  if (!mirrors && !drawn_sizes_ && !styles_) return shapes;
  Digest digest;
  digest.add(shapes);
  if (mirrors) {
    for (const Entry& entry : entries_) digest.add(std::uint64_t(entry.mirrored));
  }
  if (drawn_sizes_) {
    const std::vector<float> scales_px = drawn_scales_px();
    digest.add_all(std::span<const float>(scales_px));
  }
  if (styles_) {
    const std::vector<StyleFeatures> all = styles();
    digest.add_all(std::span<const StyleFeatures>(all));
  }
  return digest.value();
}

std::vector<std::uint32_t> LibraryView::variant_of() const {
  if (whole_file()) return files_.front().variant_of();
  std::vector<std::uint32_t> variants;
  for (const Entry& entry : entries_) variants.push_back(entry.variant_of);
  return variants;
}

std::vector<StyleFeatures> LibraryView::styles() const {
  if (whole_file()) return files_.front().styles();
  std::vector<StyleFeatures> styles;
  for_each_head(*this, [&](std::size_t, const ShapeHead& head) { styles.push_back(head.style); });
  return styles;
}

bool LibraryView::has_surroundings() const {
  return std::any_of(files_.begin(), files_.end(), [](const LibraryFile& file) { return file.has_surroundings(); });
}

std::vector<std::uint32_t> LibraryView::drawings() const {
  if (whole_file()) return files_.front().drawings();
  std::vector<std::uint32_t> drawings;
  for (const Entry& entry : entries_) drawings.push_back(entry.drawing);
  return drawings;
}

/// The end of the consecutive entries of one file that begin at `begin`; at most `end`.
std::size_t LibraryView::run_end(std::size_t begin, std::size_t end) const {
  std::size_t at = begin + 1;
  while (at < end && entries_[at].file == entries_[begin].file &&
         entries_[at].index == entries_[begin].index + (at - begin)) {
    ++at;
  }
  return at;
}

std::vector<ShapeHead> LibraryView::heads(std::size_t begin, std::size_t end) const {
  if (whole_file()) return files_.front().heads(begin, end);
  std::vector<ShapeHead> heads;
  for (std::size_t at = begin, next = at; at < end; at = next) {
    next = run_end(at, end);
    const std::uint32_t first = entries_[at].index;
    std::vector<ShapeHead> run = files_[entries_[at].file].heads(first, first + (next - at));
    std::move(run.begin(), run.end(), std::back_inserter(heads));
  }
  for (std::size_t i = 0; i < heads.size(); ++i) {
    const Entry& entry = entries_[begin + i];
    if (!entry.new_name.empty()) heads[i].name = entry.new_name;
    heads[i].variant_of = entry.variant_of;
  }
  return heads;
}

std::shared_ptr<const ModelSource> LibraryView::stored_models(const MatchingContext& context) const {
  return whole_file() ? files_.front().stored_models(context) : nullptr;
}

std::vector<Shape> LibraryView::read(std::size_t begin, std::size_t end, const LibraryParts& parts) const {
  if (whole_file()) return files_.front().read(begin, end, parts);
  end = std::min(end, size());
  std::vector<Shape> shapes;
  for (std::size_t at = begin, next = at; at < end; at = next) {
    next = run_end(at, end);
    const std::uint32_t first = entries_[at].index;
    std::vector<Shape> run = files_[entries_[at].file].read(first, first + (next - at), parts);
    std::move(run.begin(), run.end(), std::back_inserter(shapes));
  }
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Entry& entry = entries_[begin + i];
    if (!entry.new_name.empty()) shapes[i].name = entry.new_name;
    if (entry.mirrored) shapes[i] = mirror_image(std::move(shapes[i]), pad_parameters().levels);
  }
  return shapes;
}

}  // namespace tessera
