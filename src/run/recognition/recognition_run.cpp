#include "run/recognition/recognition_run.h"

#include <cstdio>
#include <memory>

#include "core/base/error.h"
#include "core/base/stopwatch.h"
#include "library/storage/library_file.h"
#include "recognition/drawn_curves.h"
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

/// A known scale is of no use where the library does not say how large its shapes were drawn.
void check_drawn_sizes(const LibraryFile& library) {
  const LibraryParts no_parts{.outline = false, .field = false, .levels = 0, .artwork = false};
  if (library.read(0, 1, no_parts).front().drawn_scale_px > 0) return;
  throw InputError("--scale: " + library.path() + " does not know how large its shapes were drawn; build it anew");
}

std::vector<DrawnCurves> read_queries(const RecognizeArguments& arguments) {
  Drawers drawers({});
  std::vector<DrawnCurves> queries;
  for (const std::string& path : arguments.queries) {
    queries.push_back(read_drawn_curves(path, TracedAs::outlines, drawers));
  }
  return queries;
}

RecognitionQuestion question_of(const RecognizeArguments& arguments, const std::vector<DrawnCurves>& queries,
                                const ShapeLibrary& library) {
  RecognitionQuestion question;
  question.library = arguments.library;
  question.library_digest = library.content_digest();
  question.most = arguments.most;
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
      print_line("  nothing of the library: the best shape's score is below %.2f (--least)", arguments.least_score);
    }
  }
}

int lead(const RecognizeArguments& arguments, comm::Communicator& ranks) {
  check(arguments);
  const std::vector<DrawnCurves> drawn = read_queries(arguments);
  const LibraryFile library(arguments.library);
  if (arguments.scale) check_drawn_sizes(library);
  const Stopwatch watch;
  const RecognitionQuestion question = question_of(arguments, drawn, library);
  const Recognitions found = searched(arguments, question, library, ranks);
  const std::vector<RecognisedQuery> queries = recognised_queries(arguments.queries, found, library);
  if (!arguments.quiet) print_table(arguments, queries);
  if (!arguments.json.empty()) write_recognitions(arguments.json, arguments.library, queries);
  if (!arguments.sheet.empty()) write_recognition_sheet(arguments.sheet, arguments.queries, drawn, found, library);
  if (!arguments.quiet) print_line("%zu shapes, %.1f s", library.size(), watch.seconds());
  bool all_found = true;
  for (const RecognisedQuery& query : queries) all_found &= query.found(arguments.least_score);
  return all_found ? kDoneExitCode : kIncompleteExitCode;
}

}  // namespace

int recognize_on_all_ranks(const RecognizeArguments& arguments, comm::Communicator& ranks) {
  if (ranks.rank() != 0) {  // never returns
    work_on_recognition(ranks, [](const std::string& path) { return std::make_unique<const LibraryFile>(path); });
  }
  return lead(arguments, ranks);
}

}  // namespace tessera
