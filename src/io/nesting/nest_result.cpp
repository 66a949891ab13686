#include "io/nesting/nest_result.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

#include "core/base/error.h"
#include "io/atomic_file.h"
#include "io/nesting/nest_job.h"
#include "io/nesting/nest_sheets.h"
#include "io/number_text.h"
#include "io/regular_file.h"
#include "io/utf8_text.h"

namespace tessera::io {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr const char* kLayout = "layout.json";
constexpr const char* kCard = "card.txt";
constexpr const char* kProgram = "tessera nest";

bool is_strip(const NestRun& run) { return !std::isfinite(run.problem.length); }

double placed_area(const NestRun& run) {
  double area = 0;
  for (const NestedPiece& piece : run.layout.pieces)
    area += std::abs(signed_area(run.problem.items[std::size_t(piece.item)].outline));
  return area;
}

ordered_json placed_item(const NestRun& run, const NestedPiece& piece) {
  ordered_json item = {{"item_id", run.input.sources[std::size_t(piece.item)].number},
                       {"name", run.input.sources[std::size_t(piece.item)].drawing.name},
                       {"transformation",
                        {{"rotation", run.problem.items[std::size_t(piece.item)].angles_deg[std::size_t(piece.angle)]},
                         {"translation", {piece.shift.x, piece.shift.y}}}}};
  if (!is_strip(run)) item["sheet"] = piece.sheet + 1;
  return item;
}

/// In the manner of sparrow's solutions: rotation in degrees about the shape's own origin, then the translation.
std::string layout_json(const NestRun& run) {
  ordered_json items = ordered_json::array();
  for (const NestedPiece& piece : run.layout.pieces) items.push_back(placed_item(run, piece));
  ordered_json left = ordered_json::array();
  for (std::size_t i = 0; i < run.layout.left_over.size(); ++i) {
    if (run.layout.left_over[i] > 0)
      left.push_back({{"item_id", run.input.sources[i].number},
                      {"name", run.input.sources[i].drawing.name},
                      {"count", run.layout.left_over[i]}});
  }
  ordered_json layout = {{"program", kProgram}, {"name", run.input.name}, {"strip_height", run.problem.height}};
  if (!is_strip(run)) layout["sheet_width"] = run.problem.length;
  layout["solution"] = {{"strip_width", run.layout.used_length},
                        {"sheets", run.layout.sheets},
                        {"density", density_of(run)},
                        {"layout", {{"container_id", 0}, {"placed_items", items}, {"density", density_of(run)}}},
                        {"left_over", left}};
  return layout.dump(1) + "\n";
}

std::string left_over_text(const NestRun& run) {
  std::string text;
  for (std::size_t i = 0; i < run.layout.left_over.size(); ++i) {
    const int count = run.layout.left_over[i];
    if (count > 0)
      text += (text.empty() ? "" : ", ") + std::to_string(count) + " x " + run.input.sources[i].drawing.name;
  }
  return text.empty() ? "nothing" : text;
}

std::string card_text(const NestRun& run) {
  const auto line = [](const std::string& label, const std::string& value) {
    return "  " + label + std::string(16 - label.size(), ' ') + value + "\n";
  };
  const std::string length = fixed(run.layout.used_length, 3) + " mm";
  std::string text = std::string(kProgram) + ": " + run.input.name + "\n";
  text += line("pieces", std::to_string(run.layout.pieces.size()) + " of " + std::to_string(wanted_pieces(run)));
  text += line("density", fixed(100 * density_of(run), 2) + " %");
  if (is_strip(run)) {
    text += line("strip", fixed(run.problem.height, 3) + " mm high");
    text += line("length", length);
  } else {
    text += line("sheets", std::to_string(run.layout.sheets) + " of " + fixed(run.problem.length, 3) + " x " +
                               fixed(run.problem.height, 3) + " mm");
    text += line("last sheet", length + " of its length used");
  }
  text += line("spacing", fixed(run.problem.spacing, 3) + " mm");
  text += line("did not fit", left_over_text(run));
  text += line("effort", run.effort + ", seed " + std::to_string(run.seed));
  return text + line("time", fixed(run.seconds, 1) + " s");
}

/// layout or layout_N, and an ending of what write_sheet writes.
bool is_of_sheet(std::string_view name) {
  constexpr std::string_view kStem = "layout";
  if (!name.starts_with(kStem)) return false;
  name.remove_prefix(kStem.size());
  if (const std::size_t end = std::min(name.find_first_not_of("0123456789", 1), name.size());
      name.starts_with('_') && end > 1)
    name.remove_prefix(end);
  return name == ".svg" || name == ".dxf" || name == ".png" || name == ".toml" || name == "_pieces.geojson";
}

/// Of an earlier run, maybe with more sheets.
void remove_old_sheets(const fs::path& folder) {
  std::vector<fs::path> old;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (is_of_sheet(entry.path().filename().string()) && entry.is_regular_file()) old.push_back(entry.path());
  }
  for (const fs::path& file : old) fs::remove(file);
}

bool begins_with(const fs::path& file, const std::string& words) try {
  std::vector<std::uint8_t> first(words.size());
  read_at(file.string(), open_regular_file(file.string()), 0, first);
  return std::equal(first.begin(), first.end(), words.begin(), words.end());
} catch (const InputError&) {  // not there, or no file
  return false;
}

/// The first of its entries, by name.
std::string first_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names.empty() ? "" : *names.begin();
}

/// What in the folder shows that it is not of tessera nest; nothing where it may be written into. An unfinished run left
/// its card and no layout.json.
std::string foreign_file(const fs::path& folder) {
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(folder / kLayout, ignored)))
    return begins_with(folder / kLayout, "{\n \"program\": \"" + std::string(kProgram) + "\",\n") ? "" : kLayout;
  return begins_with(folder / kCard, std::string(kProgram) + ": ") ? "" : first_in(folder);
}

void write_sheet(const NestRun& run, int sheet, const fs::path& folder) {
  const std::string name = run.layout.sheets > 1 ? "layout_" + std::to_string(sheet + 1) : "layout";
  const NestSheet cut = nest_sheet(run, sheet);
  write_file_atomically((folder / (name + ".svg")).string(), sheet_svg(cut));
  write_file_atomically((folder / (name + ".dxf")).string(), sheet_dxf(cut));
  write_file_atomically((folder / (name + ".png")).string(), sheet_png(cut));
  if (run.input.library.empty()) return;
  const NestJob job = nest_job(run, sheet, folder.string(), name + "_pieces.geojson");
  write_file_atomically((folder / (name + "_pieces.geojson")).string(), job.pieces);
  write_file_atomically((folder / (name + ".toml")).string(), job.toml);
}

}  // namespace

double density_of(const NestRun& run) {
  const double length = is_strip(run) ? run.layout.used_length : run.problem.length * run.layout.sheets;
  return length > 0 ? placed_area(run) / (run.problem.height * length) : 0;
}

int wanted_pieces(const NestRun& run) {
  int count = 0;
  for (const NestItem& item : run.problem.items) count += item.demand;
  return count;
}

void check_nest_folder(const std::string& folder) {
  std::error_code ignored;
  if (!fs::exists(folder, ignored)) return;
  if (!fs::is_directory(folder, ignored))
    throw InputError("--out " + printable_utf8(folder) + ": is there and is no folder; give another name");
  if (const std::string file = foreign_file(folder); !file.empty()) {
    throw InputError("--out " + printable_utf8(folder) + ": is there, and its " + printable_utf8(file) +
                     " is not of tessera nest; give another name");
  }
}

std::string write_nest_result(const NestRun& run, const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw EnvironmentError("cannot make " + printable_utf8(folder) + ": " + error.message());
  // layout.json says that all is there: it goes first and comes last. Meanwhile the card tells whose folder it is.
  fs::remove(fs::path(folder) / kLayout);
  const std::string card = card_text(run);
  write_file_atomically((fs::path(folder) / kCard).string(), card);
  remove_old_sheets(folder);
  for (int sheet = 0; sheet < run.layout.sheets; ++sheet) write_sheet(run, sheet, folder);
  write_file_atomically((fs::path(folder) / kLayout).string(), layout_json(run));
  return card;
}

}  // namespace tessera::io
