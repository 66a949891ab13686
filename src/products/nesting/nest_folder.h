// The folder that a layout is written to: one run at a time, and a layout there is whole or none.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "files/output_folder.h"
#include "files/output_lock.h"
#include "products/nesting/nest_result.h"

namespace tessera {

/// Called before each file, with the number of files that are done and that of all, and while the disk writes. What it
/// throws ends the writing.
using BetweenFiles = std::function<void(std::size_t done, std::size_t all)>;

/// To be made before time is spent on a search. While it lives, no other run may write into the folder (output_lock.h).
class NestFolder {
 public:
  /// Makes the folder where it is missing, and removes what a run that was killed has left of its temporary files.
  /// Throws InputError where it holds something that is not of tessera nest, or where another run is at work;
  /// EnvironmentError where nothing can be written there.
  explicit NestFolder(const std::string& folder);

  /// About how long the disk will take for the files of so many sheets: some small files are written and removed. 0
  /// where they are few. Throws EnvironmentError.
  double seconds_to_write(bool of_library, double sheets) const;

  /// layout.json, card.txt, and of each sheet layout.svg and .dxf; of a library's shapes layout.toml and
  /// layout_pieces.geojson, too. Of several sheets they are called layout_1.svg and so on. All get temporary names
  /// first: until all are on the disk an earlier layout stays as it was, then the whole of it is replaced, pictures
  /// included, layout.json as the first to go and the last to come: where it is missing, the rest is not complete.
  /// Other files stay. Throws EnvironmentError.
  void write(const NestRun& run, const BetweenFiles& between);

  /// The pictures of a layout that was written: layout.png of each sheet, some at a time. Those before what `between`
  /// throws stay.
  void draw(const NestRun& run, const BetweenFiles& between);

 private:
  void remove_earlier();
  void draw_some(const NestRun& run, int first, int end, const BetweenFiles& between);

  std::filesystem::path folder_;
  OutputFolder made_;
  OutputLock lock_;
};

}  // namespace tessera
