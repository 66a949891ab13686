#include "render/card_drawing.h"

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "files/atomic_file.h"
#include "result/card_bounds.h"
#include "result/folder/result_file.h"

namespace tessera {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kJsonCard = "card.json";
constexpr const char* kTextCard = "card.txt";

std::string json_with_drawing(const std::string& dir, const DrawingNotes& notes) {
  Json card = Json::parse(read_result_json(dir, kJsonCard, kCardBounds), nullptr, false);
  if (!card.is_object()) throw InputError(path_in_result(dir, kJsonCard) + ": not a card.json of tessera collage");
  if (notes.afar) card["from_afar"] = Json::parse(afar_json(*notes.afar));
  card["drawing"] = Json::parse(drawing_json(notes));
  return card.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// The part of the card above the section that begins with this line; all of it where there is no such section.
std::string above(const std::string& card, const std::string& heading) {
  const std::size_t section = card.find("\n" + heading);
  return card.substr(0, section == std::string::npos ? section : section + 1);
}

std::string text_with_drawing(const std::string& dir, const DrawingNotes& notes) {
  const std::string card = above(read_result_file(dir, kTextCard), kDrawingHeading);
  return (notes.afar ? above(card, kAfarHeading) + afar_text(*notes.afar) : card) + drawing_text(notes);
}

/// Rewrites a card. Returns why the card stays as it is; mostly empty.
template <class Text>
std::string rewrite(const std::string& dir, const char* name, const DrawingNotes& notes, Text with_drawing) {
  try {
    write_file_atomically(path_in_result(dir, name), with_drawing(dir, notes));
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

}  // namespace

std::vector<std::string> add_drawing_to_cards(const std::string& dir, const DrawingNotes& notes) {
  std::vector<std::string> problems = {rewrite(dir, kJsonCard, notes, json_with_drawing),
                                       rewrite(dir, kTextCard, notes, text_with_drawing)};
  std::erase(problems, "");
  return problems;
}

}  // namespace tessera
