// Writes the answers of tessera recognize: JSON for programs, and a picture.
#pragma once

#include <string>
#include <vector>

#include "library/storage/library_file.h"
#include "recognition/drawn_curves.h"
#include "run/recognition/recognition_messages.h"

namespace tessera {

struct RecognisedShape {
  std::string name;
  double similarity = 0;
  double score = 0;         // answer_score()
  double scale = 0;         // px of the query's picture for one px of the library's drawing; 0: not known
  double rotation_deg = 0;  // from the drawing to the picture, clockwise as y points down
};

struct RecognisedQuery {
  std::string file;
  std::vector<RecognisedShape> shapes;  // the best first

  bool found(double least_score) const { return !shapes.empty() && shapes.front().score >= least_score; }
};

/// A query whose file cannot be read.
struct UnreadQuery {
  std::string file;
  std::string reason;  // names the file
};

/// The answers for the queries. `files`: the names of the queries.
std::vector<RecognisedQuery> recognised_queries(const std::vector<std::string>& files, const Recognitions& found,
                                                const LibraryFile& library);

/// Writes JSON. Throws EnvironmentError where the file cannot be written, like write_recognition_sheet().
void write_recognitions(const std::string& path, const std::string& library,
                        const std::vector<RecognisedQuery>& queries, const std::vector<UnreadQuery>& unread);

/// Writes a PNG with a row for each query: its outlines first, then the best shapes.
void write_recognition_sheet(const std::string& path, const std::vector<RecognisedQuery>& queries,
                             const std::vector<DrawnCurves>& drawn, const Recognitions& found,
                             const LibraryFile& library);

}  // namespace tessera
