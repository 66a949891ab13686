// Names of library shapes: readable, unique, and the same whenever the same files come in the same order.
#pragma once

#include <set>
#include <string>

namespace tessera {

class LibraryNames {
 public:
  /// Whether the name, which is one of a library, was not given before; it is from now on.
  bool take(const std::string& name) { return given_.insert(name).second; }
  /// A name not given before: `stem` itself, or "stem (folder)" with the folder of `path`, or "stem (folder) 2" and so
  /// on. Bytes that are not UTF-8 and control characters become '_'; long names are cut.
  std::string unique(const std::string& stem, const std::string& path);

 private:
  std::set<std::string> given_;
};

}  // namespace tessera
