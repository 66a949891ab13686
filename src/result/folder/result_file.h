// Reads the files of a result: one that is not there is told apart from one that the machine cannot read.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "files/file_blocks.h"
#include "text/json_bounds.h"

namespace tessera {

/// "out/animals/card.json"
std::string path_in_result(const std::string& dir, const std::string& name);

/// Whether `dir` has something of this name. Throws EnvironmentError where the system does not say.
bool is_in_result(const std::string& dir, const std::string& name);

/// Job::shown_png in the folder of a result that shows a picture, so that `tessera draw` does not need the job's own
/// file.
inline constexpr const char* kShownPictureName = "shown.png";

/// Of pieces.geojson, which is read block by block.
inline constexpr std::size_t kMostPiecesBytes = std::size_t(4) << 30;
/// Of every other file of a result.
inline constexpr std::size_t kMostResultFileBytes = std::size_t(64) << 20;

/// dir/name, which must be there: otherwise throws InputError, as where it has more than `most_bytes`. Throws
/// EnvironmentError where it is there and cannot be opened, which is no reason to make the result anew.
FileBlocks open_result_file(const std::string& dir, const std::string& name, std::size_t most_bytes);

/// The bytes of dir/name. Throws as open_result_file.
std::string read_result_file(const std::string& dir, const std::string& name,
                             std::size_t most_bytes = kMostResultFileBytes);

/// The text of a JSON file that nlohmann may make a tree of, within `bounds`. Throws InputError, too, where it has
/// more.
std::string read_result_json(const std::string& dir, const std::string& name, const JsonBounds& bounds);

}  // namespace tessera
