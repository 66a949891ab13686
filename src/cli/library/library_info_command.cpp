#include "cli/library/library_info_command.h"

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "core/base/count_text.h"
#include "core/base/error.h"
#include "files/atomic_file.h"
#include "library/contact_sheet.h"
#include "library/storage/library_file.h"
#include "terminal/terminal.h"

namespace tessera::cli {
namespace {

constexpr char kLibraryInfoExamples[] =
    "Examples:\n"
    "  tessera library info animals.h5\n"
    "  tessera library info animals.h5 --sheet animals.png\n"
    "  tessera library info animals.h5 --names | grep -i cat";

struct InfoArguments {
  std::string library;
  std::string sheet;
  bool names = false;
};

std::size_t samples_per_shape() {
  std::size_t samples = 0;
  for (const SmoothingLevel& level : kSmoothingLevels) samples += std::size_t(level.samples);
  return samples;
}

void print_counts(const LibraryFile& library, const LibrarySummary& summary) {
  const PadParameters pad = library.pad_parameters();
  print_line("library         %s", library.path().c_str());
  print_line("shapes          %zu", summary.shapes);
  print_line("curves          %zu (%s)", summary.curves, count_text(summary.curves - summary.shapes, "hole").c_str());
  print_line("outline points  %zu", summary.outline_points);
  print_line("samples         %zu (%zu a shape)", summary.shapes * samples_per_shape(), samples_per_shape());
  print_line("PAD             n = %d, delta_tau = %g rad", pad.levels, double(pad.delta_tau));
  const std::vector<std::uint32_t> variant_of = library.variant_of();
  const std::set<std::uint32_t> silhouettes(variant_of.begin(), variant_of.end());
  print_line("silhouettes     %zu (%zu in other colours)", silhouettes.size(), summary.shapes - silhouettes.size());
  print_line("artwork         %s", summary.original_bytes > 0 ? "embedded" : "referred to by path");
}

void print_levels() {
  print_lines("\n");
  print_line("smoothing level  sigma (shape units)  curve points  samples");
  for (std::size_t k = 0; k < kSmoothingLevels.size(); ++k) {
    const SmoothingLevel& level = kSmoothingLevels[k];
    print_line("%-15zu  %19.6f  %12d  %7d", k, double(level.sigma), level.curve_points, level.samples);
  }
}

void print_bytes(const LibrarySummary& summary) {
  print_lines("\n");
  print_line("part                 bytes  bytes a shape");
  const auto row = [&](const std::string& part, std::uint64_t bytes) {
    print_line("%-10s  %14llu  %13.0f", part.c_str(), static_cast<unsigned long long>(bytes),
               double(bytes) / double(summary.shapes));
  };
  for (const auto& [part, bytes] : summary.stored_bytes_of_part) row(part, bytes);
  row("file", summary.file_bytes);
}

void print_names(const LibraryFile& library) {
  constexpr std::size_t kNamesAtATime = 1024;
  constexpr LibraryParts kNames{.outline = false, .field = false, .levels = 0, .artwork = false, .original = false};
  for (std::size_t at = 0; at < library.size() && printing_works(); at += kNamesAtATime) {
    for (const Shape& shape : library.read(at, at + kNamesAtATime, kNames)) print_line("%s", shape.name.c_str());
  }
}

int run(const InfoArguments& arguments) {
  check_sheet(arguments.sheet);
  const LibraryFile library(arguments.library);
  if (arguments.names) {
    print_names(library);
    return 0;
  }
  const LibrarySummary summary = library.summary();
  print_counts(library, summary);
  print_levels();
  print_bytes(summary);
  if (arguments.sheet.empty()) return 0;
  const std::size_t shown = write_contact_sheet(library, arguments.sheet);
  print_lines("\n");
  print_line("%s: %s", arguments.sheet.c_str(), count_text(shown, "shape").c_str());
  return 0;
}

}  // namespace

void check_sheet(const std::string& sheet) {
  if (sheet.empty()) return;
  if (!sheet.ends_with(".png")) throw InputError("--sheet: found " + sheet + ", allowed: a name that ends in .png");
  check_can_be_written(sheet);
}

void add_library_info_command(CLI::App& library, Command& selected) {
  const auto arguments = std::make_shared<InfoArguments>();
  CLI::App* info = library.add_subcommand("info", "Show what is in a library");
  info->footer(kLibraryInfoExamples);
  info->add_option("LIBRARY", arguments->library, "The library file")->required()->type_name("LIB.h5");
  info->add_option("--sheet", arguments->sheet, "Write a picture of its shapes (PNG)")->type_name("SHEET.png");
  info->add_flag("--names", arguments->names, "Print the names of the shapes instead, one a line")->excludes("--sheet");
  info->callback([arguments, &selected] { selected.run = [arguments] { return run(*arguments); }; });
}

}  // namespace tessera::cli
