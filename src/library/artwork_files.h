// Finds the artwork files that a library is built from.
#pragma once

#include <string>
#include <vector>

namespace tessera {

struct UnusedFile {
  std::string path;
  std::string reason;
};

struct ArtworkFiles {
  std::vector<std::string> paths;  // absolute, sorted bytewise, each file once however many links lead to it
  std::vector<UnusedFile>
      left_out;  // folders that cannot be listed or hold a collage, pictures in formats that are not read, pipes
};

/// Whether a file has one of the names that find_artwork takes in a folder.
bool has_artwork_name(const std::string& path);

/// Whether tessera collage has put its pictures there (docs/result-format.md): they are no drawings for a library.
bool is_result_folder(const std::string& folder);

/// `sources`: files, and folders, searched to any depth for files (not through links to folders) whose name matches the
/// shell pattern `glob`, or is the pattern itself, letter by letter, where a file has that name (NameIndex); an empty
/// pattern means the extensions of pictures. Those in formats that are not read (GIF,
/// PDF, EPS ...) are left out by their extension where they are found; a file that is named is taken whatever its
/// extension. Throws InputError where a source does not exist.
ArtworkFiles find_artwork(const std::vector<std::string>& sources, const std::string& glob);

}  // namespace tessera
