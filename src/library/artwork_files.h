// Finds the artwork files from which a library is built.
#pragma once

#include <string>
#include <vector>

namespace tessera {

struct UnusedFile {
  std::string path;
  std::string reason;
};

struct ArtworkFiles {
  std::vector<std::string> paths;  // absolute, sorted bytewise; each file once, even if several links lead to it
  std::vector<UnusedFile>
      left_out;  // folders that cannot be listed or hold a collage, pictures in formats that are not read, pipes
};

/// Whether the file's name is one that find_artwork() takes in a folder.
bool has_artwork_name(const std::string& path);

/// Whether the folder holds pictures of tessera collage (docs/result-format.md); they are no drawings for a library.
bool is_result_folder(const std::string& folder);

/// Finds the artwork among `sources`, which are files and folders. It searches folders at any depth, but not through links
/// to folders, for files whose name matches the shell pattern `glob`. Where files have the pattern itself as their name,
/// these are taken (NameIndex). An empty pattern means the extensions of pictures. In folders, files of other formats (GIF,
/// PDF, EPS ...) are left out by their extension; a file that is named is taken with any extension. Throws InputError where
/// a source does not exist.
ArtworkFiles find_artwork(const std::vector<std::string>& sources, const std::string& glob);

}  // namespace tessera
