#include "io/result/card_drawing.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "io/atomic_file.h"

namespace tessera::io {
namespace {

using Json = nlohmann::ordered_json;

std::string content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(path + ": not found; allowed: the folder of a result of tessera collage");
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string with_drawing(const std::string& path, const DrawingNotes& notes) {
  Json card = Json::parse(content(path), nullptr, false);
  if (!card.is_object()) throw InputError(path + ": not a card.json of tessera collage");
  card["drawing"] = Json::parse(drawing_json(notes));
  return card.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

void add_drawing_to_cards(const std::string& dir, const DrawingNotes& notes) {
  const std::string json = (std::filesystem::path(dir) / "card.json").string();
  const std::string text = (std::filesystem::path(dir) / "card.txt").string();
  write_file_atomically(json, with_drawing(json, notes));
  const std::string card = content(text);
  const std::size_t section = card.find(std::string("\n") + kDrawingHeading);
  write_file_atomically(text, card.substr(0, section == std::string::npos ? section : section + 1) + drawing_text(notes));
}

}  // namespace tessera::io
