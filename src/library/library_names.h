// Makes names of library shapes: readable, unique, and the same whenever the same files come in the same order.
#pragma once

#include <set>
#include <string>

namespace tessera {

class LibraryNames {
 public:
  /// Takes the name, which is that of a library shape. False where it was given before.
  bool take(const std::string& name) { return given_.insert(name).second; }
  /// A name that was not given before: `stem`, or "stem (folder)" with the folder of `path`, or "stem (folder) 2" and so
  /// on. Bytes that are not UTF-8 and control characters become '_'; long names are cut.
  std::string unique(const std::string& stem, const std::string& path);

 private:
  std::set<std::string> given_;
};

}  // namespace tessera
