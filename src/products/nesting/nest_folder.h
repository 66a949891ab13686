// The folder of a layout: one run at a time writes there, and a layout is whole or not there.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "files/output_folder.h"
#include "files/output_lock.h"
#include "products/nesting/nest_result.h"

namespace tessera {

/// Called before each file, and while the disk writes, with the number of files done and the number of all. What it throws
/// ends the writing.
using BetweenFiles = std::function<void(std::size_t done, std::size_t all)>;

/// Reserves the folder, before time is spent on a search. While it lives, no other run may write into the folder
/// (output_lock.h).
class NestFolder {
 public:
  /// Makes the folder where it is missing, and removes temporary files of a run that was killed. Throws InputError where it
  /// holds something that is not of tessera nest, or another run is at work; EnvironmentError where nothing can be written
  /// there.
  explicit NestFolder(const std::string& folder);

  /// About how many seconds the disk will need for the files of so many sheets; it writes and removes some small files to
  /// find out. 0 where there are few. Throws EnvironmentError.
  double seconds_to_write(bool of_library, double sheets) const;

  /// Writes layout.json, card.txt, and for each sheet layout.svg and .dxf; for a library's shapes layout.toml and
  /// layout_pieces.geojson, too. Of several sheets they are called layout_1.svg and so on. All files get temporary names
  /// first: an earlier layout stays until all are on the disk, then it is replaced as a whole, with its pictures.
  /// layout.json is removed first and written last; where it is missing, the rest is not complete. Other files stay. Throws
  /// EnvironmentError.
  void write(const NestRun& run, const BetweenFiles& between);

  /// Draws the pictures of a written layout: layout.png of each sheet, some at a time. If `between` throws, the pictures
  /// before stay.
  void draw(const NestRun& run, const BetweenFiles& between);

 private:
  void remove_earlier();
  void draw_some(const NestRun& run, int first, int end, const BetweenFiles& between);

  std::filesystem::path folder_;
  OutputFolder made_;
  OutputLock lock_;
};

}  // namespace tessera
