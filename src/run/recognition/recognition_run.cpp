#include "run/recognition/recognition_run.h"

#include <algorithm>
#include <cstdio>
#include <memory>

#include "core/base/error.h"
#include "core/base/stopwatch.h"
#include "files/atomic_file.h"
#include "library/storage/library_file.h"
#include "recognition/drawn_curves.h"
#include "recognition/library_lots.h"
#include "run/messages/first_picture_warning.h"
#include "run/recognition/recognition_files.h"
#include "run/recognition/recognition_search.h"
#include "terminal/exit_codes.h"
#include "terminal/progress_bar.h"
#include "terminal/terminal.h"
#include "text/text_table.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

void check(const RecognizeArguments& arguments) {
  if (arguments.scale && !(*arguments.scale > 0 && *arguments.scale < 1e6)) {
    throw InputError("--scale: must be above 0 and below a million");
  }
}

/// Refuses --scale where the library does not say how large its shapes were drawn.
void check_drawn_sizes(const LibraryFile& library) {
  const LibraryParts no_parts{.outline = false, .field = false, .levels = 0, .artwork = false};
  if (library.read(0, 1, no_parts).front().drawn_scale_px > 0) return;
  throw InputError("--scale: " + library.path() + " does not know how large its shapes were drawn; build it anew");
}

/// The files that can be read, with their curves, and the files that cannot, with the reasons.
struct ReadQueries {
  std::vector<std::string> files;
  std::vector<DrawnCurves> drawn;
  std::vector<UnreadQuery> unread;
};

/// Reads the queries. Throws InputError where no file can be read.
ReadQueries read_queries(const std::vector<std::string>& files) {
  Drawers drawers({});
  ReadQueries queries;
  for (const std::string& file : files) {
    try {
      queries.drawn.push_back(read_drawn_curves(file, TracedAs::outlines, drawers));
      queries.files.push_back(file);
    } catch (const InputError& error) {
      queries.unread.push_back({file, error.what()});
    }
  }
  if (queries.files.empty()) throw InputError(queries.unread.front().reason);
  return queries;
}

RecognitionQuestion question_of(const RecognizeArguments& arguments, const std::vector<DrawnCurves>& queries,
                                const ShapeLibrary& library) {
  RecognitionQuestion question;
  question.library = arguments.library;
  question.library_digest = library.content_digest();
  question.most = arguments.most;
  question.lot_shapes = shapes_of_lot(library.size());
  if (arguments.scale) question.query_per_drawn_px = float(*arguments.scale);
  for (const DrawnCurves& query : queries) question.queries.push_back({query.curves, query.pixel});
  return question;
}

Recognitions searched(const RecognizeArguments& arguments, const RecognitionQuestion& question,
                      const ShapeLibrary& library, comm::Communicator& ranks) {
  std::optional<ProgressBar> bar;
  return recognised_by_all_ranks(ranks, question, library, [&](std::size_t done, std::size_t all) {
    if (arguments.quiet || all < 2) return;
    if (!bar) bar.emplace("searching", all);
    bar->update(done);
  });
}

void print_table(const RecognizeArguments& arguments, const std::vector<RecognisedQuery>& queries) {
  for (const RecognisedQuery& query : queries) {
    print_line("%s", printable_utf8(query.file).c_str());
    TextTable table({"shape", "similarity", "score", "scale", "turned"});
    for (const RecognisedShape& shape : query.shapes) {
      char similarity[16], score[16], scale[16], turned[16];
      std::snprintf(similarity, sizeof similarity, "%.3f", shape.similarity);
      std::snprintf(score, sizeof score, "%.3f", shape.score);
      std::snprintf(scale, sizeof scale, "%.3f", shape.scale);
      std::snprintf(turned, sizeof turned, "%.1f deg", shape.rotation_deg);
      table.add({shape.name, similarity, score, scale, turned});
    }
    if (!query.shapes.empty()) print_lines(table.text());
    if (!query.found(arguments.least_score)) {
      print_line("  no shape of the library: the best score is below %.2f (--least)", arguments.least_score);
    }
  }
}

int lead(const RecognizeArguments& arguments, comm::Communicator& ranks) {
  check(arguments);
  for (const std::string& output : {arguments.json, arguments.sheet}) {
    if (!output.empty()) check_can_be_written(output);
  }
  const ReadQueries read = read_queries(arguments.queries);
  const LibraryFile library(arguments.library);
  if (arguments.scale) check_drawn_sizes(library);
  const Stopwatch watch;
  const Recognitions found = searched(arguments, question_of(arguments, read.drawn, library), library, ranks);
  const std::vector<RecognisedQuery> queries = recognised_queries(read.files, found, library);
  if (!arguments.quiet) print_table(arguments, queries);
  if (!arguments.json.empty()) write_recognitions(arguments.json, arguments.library, queries, read.unread);
  if (!arguments.sheet.empty()) write_recognition_sheet(arguments.sheet, queries, read.drawn, found, library);
  if (!arguments.quiet) print_line("%zu shapes, %.1f s", library.size(), watch.seconds());
  print_warning(first_picture_warning(read.files));
  for (const UnreadQuery& query : read.unread) print_warning("skipped: " + query.reason);
  const bool all_found = std::all_of(queries.begin(), queries.end(),
                                     [&](const RecognisedQuery& query) { return query.found(arguments.least_score); });
  return all_found && read.unread.empty() ? kDoneExitCode : kIncompleteExitCode;
}

}  // namespace

int recognize_on_all_ranks(const RecognizeArguments& arguments, comm::Communicator& ranks) {
  if (ranks.rank() != 0) {  // never returns
    work_on_recognition(ranks, [](const std::string& path) { return std::make_unique<const LibraryFile>(path); });
  }
  return lead(arguments, ranks);
}

}  // namespace tessera
