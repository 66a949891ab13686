#include "result/piece_properties.h"

#include "core/base/error.h"
#include "job/pieces/feature_properties.h"
#include "result/folder/result_file.h"
#include "result/placed_pieces.h"

namespace tessera {

void read_piece_properties(const std::string& dir, const std::vector<std::string_view>& keys,
                           const std::function<void(const nlohmann::json& properties)>& take) {
  JsonFile file{open_result_file(dir, "pieces.geojson", kMostPiecesBytes)};
  const std::string path = path_in_result(dir, "pieces.geojson");
  try {
    read_feature_properties(file, keys, kMostPieces,
                            [&](const nlohmann::json& feature) { take(feature.at("properties")); });
  } catch (const nlohmann::json::exception& error) {
    throw InputError(path + ": not a pieces.geojson of tessera collage: " + error.what());
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
}

}  // namespace tessera
