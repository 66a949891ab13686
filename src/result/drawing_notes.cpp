#include "result/drawing_notes.h"

#include <map>
#include <nlohmann/json.hpp>

#include "core/base/count_text.h"
#include "text/number_text.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

using Json = nlohmann::ordered_json;

/// Counts pieces by reason.
std::map<std::string, std::size_t> by_reason(const DrawingNotes& notes, DrawnFrom from) {
  std::map<std::string, std::size_t> pieces;
  for (const DrawingNote& note : notes.notes) {
    if (note.from == from) pieces[note.reason] += note.pieces;
  }
  return pieces;
}

std::size_t pieces_of(const DrawingNotes& notes, DrawnFrom from) {
  std::size_t pieces = 0;
  for (const DrawingNote& note : notes.notes) pieces += note.from == from ? note.pieces : 0;
  return pieces;
}

/// Cuts a UTF-8 text to so many bytes, with an ellipsis where something is missing.
std::string cut(std::string text, std::size_t most_bytes) {
  if (text.size() <= most_bytes) return text;
  text.resize(most_bytes - 3);
  while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xc0) == 0x80) text.pop_back();
  if (!text.empty() && (static_cast<unsigned char>(text.back()) & 0x80) != 0) text.pop_back();
  return text + "...";
}

std::string line(const std::string& label, const std::string& value) {
  constexpr std::size_t kLabelWidth = 24, kMostBytes = 78;
  return "  " + cut(label + std::string(kLabelWidth - label.size(), ' ') + printable_utf8(value), kMostBytes - 2) +
         "\n";
}

}  // namespace

std::string drawing_json(const DrawingNotes& notes) {
  Json thumbnails = Json::array(), silhouettes = Json::array();
  for (const auto& [reason, pieces] : by_reason(notes, DrawnFrom::thumbnail)) {
    thumbnails.push_back({{"reason", reason}, {"pieces", pieces}});
  }
  for (const DrawingNote& note : notes.notes) {
    if (note.from != DrawnFrom::silhouette) continue;
    silhouettes.push_back({{"shape", note.shape}, {"reason", note.reason}, {"pieces", note.pieces}});
  }
  const std::size_t others = pieces_of(notes, DrawnFrom::thumbnail) + pieces_of(notes, DrawnFrom::silhouette);
  const Json section{{"seconds", rounded(notes.seconds, 3)},
                     {"pieces_from_originals", notes.pieces - others},
                     {"from_thumbnails", thumbnails},
                     {"as_silhouettes", silhouettes}};
  return section.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string drawing_text(const DrawingNotes& notes) {
  std::string text = kDrawingHeading + line("drawing time", fixed(notes.seconds, 1) + " s");
  for (const auto& [reason, pieces] : by_reason(notes, DrawnFrom::thumbnail)) {
    text += line("drawn from thumbnail", count_text(pieces, "piece") + ": " + reason);
  }
  for (const DrawingNote& note : notes.notes) {
    if (note.from != DrawnFrom::silhouette) continue;
    text += line("drawn as silhouette", count_text(note.pieces, "piece") + " of " + note.shape + ": " + note.reason);
  }
  return text;
}

std::string drawing_warning(const DrawingNotes& notes) {
  std::string text;
  for (const auto& [reason, pieces] : by_reason(notes, DrawnFrom::thumbnail)) {
    text += (text.empty() ? "" : "; ") + count_text(pieces, "piece") + " drawn from thumbnails: " + reason;
  }
  for (const auto& [reason, pieces] : by_reason(notes, DrawnFrom::silhouette)) {
    text += (text.empty() ? "" : "; ") + count_text(pieces, "piece") + " drawn as silhouettes: " + reason;
  }
  for (const std::string& problem : notes.cards) {
    text += (text.empty() ? "" : "; ") + std::string("the card does not tell of this drawing: ") + problem;
  }
  return text;
}

}  // namespace tessera
