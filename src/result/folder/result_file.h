// Reads the files of a result. A missing file and a file that the machine cannot read are different errors.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "files/file_blocks.h"
#include "text/json_bounds.h"

namespace tessera {

/// A path such as "out/animals/card.json".
std::string path_in_result(const std::string& dir, const std::string& name);

/// Whether `dir` has an entry of this name. Throws EnvironmentError where the system does not tell.
bool is_in_result(const std::string& dir, const std::string& name);

/// The name of Job::shown_png in a result that shows a picture. With it `tessera draw` does not need the job's own file.
inline constexpr const char* kShownPictureName = "shown.png";

/// Upper bound of pieces.geojson, which is read block by block.
inline constexpr std::size_t kMostPiecesBytes = std::size_t(4) << 30;
/// Upper bound of every other file of a result.
inline constexpr std::size_t kMostResultFileBytes = std::size_t(64) << 20;

/// Opens dir/name. Throws InputError where the file is missing or has more than `most_bytes`. Throws EnvironmentError where
/// it is there and cannot be opened, which is no reason to make the result again.
FileBlocks open_result_file(const std::string& dir, const std::string& name, std::size_t most_bytes);

/// The bytes of dir/name. Throws like open_result_file().
std::string read_result_file(const std::string& dir, const std::string& name,
                             std::size_t most_bytes = kMostResultFileBytes);

/// The text of a JSON file that is safe to parse with nlohmann, because it is within `bounds`. Throws InputError, too,
/// where it exceeds them.
std::string read_result_json(const std::string& dir, const std::string& name, const JsonBounds& bounds);

}  // namespace tessera
