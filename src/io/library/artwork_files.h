// Finds the artwork files that a library is built from.
#pragma once

#include <string>
#include <vector>

namespace tessera::io {

struct UnusedFile {
  std::string path;
  std::string reason;
};

struct ArtworkFiles {
  std::vector<std::string> paths;      // absolute, sorted bytewise, each file once however many links lead to it
  std::vector<UnusedFile> left_out;    // folders that cannot be listed, pictures in formats that are not read
};

/// `sources`: files, taken as they are, and folders, searched to any depth for files (not through links to folders)
/// whose name matches the shell pattern `glob`; an empty pattern means the extensions of the formats we read. Pictures
/// in other formats (GIF, PDF, EPS ...) that are found then are named as left out.
/// Throws InputError where a source does not exist.
ArtworkFiles find_artwork(const std::vector<std::string>& sources, const std::string& glob);

}  // namespace tessera::io
