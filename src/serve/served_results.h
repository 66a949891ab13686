// The results that a server shows: the one that it was started for, and those that were refined from it, beside it.
#pragma once

#include <string>
#include <vector>

namespace tessera::serve {

struct ServedResult {
  std::string name;  // that of its folder
  std::string folder;
  std::string from;  // the name of the result that it was refined from; empty: of none of these
  bool finished = false;
  bool stopped = false;  // with its state saved
  std::string message;   // why it is not finished
};

/// A result "out/animals" and those with numbers: "out/animals-2", "out/animals-3".
class ServedResults {
 public:
  /// Finds the results of earlier sessions, too; folders of other users and folders without a whole result are passed over.
  /// Throws InputError where `folder` holds no whole result, or where its name cannot stand in an address.
  explicit ServedResults(const std::string& folder);

  /// The first one is that of the constructor; then by their numbers.
  const std::vector<ServedResult>& all() const { return all_; }
  /// Throws InputError where there is no result of this name.
  ServedResult& named(const std::string& name);
  /// Makes the folder of a further result. Throws EnvironmentError.
  ServedResult& add(const std::string& from);
  /// Takes the latest result back; its folder goes if it is empty.
  void remove_last();

 private:
  std::string folder_of(int number) const;
  void find_earlier();

  std::vector<ServedResult> all_;
  int last_number_ = 1;
};

}  // namespace tessera::serve
