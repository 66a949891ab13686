#include <memory>

#include "cli/commands.h"
#include "run/recognition/recognition_run.h"

namespace tessera::cli {
namespace {

constexpr const char* kRecognizeExamples =
    "Examples:\n"
    "  tessera recognize torn.png --library animals.h5                      finds the animal of which this is a part\n"
    "  tessera recognize signs/*.png --library signs.h5 --json signs.json --sheet signs.png\n"
    "  mpirun -n 8 tessera recognize q.svg --library large.h5               the same answer on any number of ranks\n"
    "A query may be turned, of any size, clipped or partly hidden. Similarity: how much of the query's outline the "
    "shape\n"
    "follows, and how closely; 1 means all of it. Score: the same for the query's and the shape's outlines together. "
    "The\n"
    "exit code is 3 if a query is unknown to the library or cannot be read, and 2 if no query can be read.";

}  // namespace

void add_recognize_command(CLI::App& app, Command& selected) {
  const auto arguments = std::make_shared<RecognizeArguments>();
  CLI::App* command =
      app.add_subcommand("recognize", "Find the shapes of a library that pictures are, or are parts of");
  command->footer(kRecognizeExamples);
  command->add_option("QUERY", arguments->queries, "SVGs, images with transparency, masks, pictures on a plain ground")
      ->required()
      ->type_name("FILE ...");
  command->add_option("--library", arguments->library, "The library")->required()->type_name("LIB.h5");
  command->add_option("--top", arguments->most, "Most shapes to report for each query")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("--least", arguments->least_score, "A query whose best shape has a lower score counts as unknown")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  command
      ->add_option("--scale", arguments->scale,
                   "Scale of the queries, if known: px of the query for one px of the library's drawings; other "
                   "scales are excluded")
      ->type_name("FACTOR");
  command->add_option("--json", arguments->json, "Also write the answer as JSON")->type_name("FILE");
  command->add_option("--sheet", arguments->sheet, "Draw queries and shapes side by side")->type_name("FILE.png");
  command->add_flag("--quiet", arguments->quiet, "Print only warnings and errors");
  command->callback([arguments, &selected] {
    selected.run_on_all_ranks = [arguments](comm::Communicator& ranks) {
      return recognize_on_all_ranks(*arguments, ranks);
    };
  });
}

}  // namespace tessera::cli
