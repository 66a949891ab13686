// Tells the user the address of a served page, which is a password.
#pragma once

#include <string>

namespace tessera::serve {

/// Prints the address where only the user can read it: on a terminal, or into a file of their own. Elsewhere (a pipe, the
/// output of a Slurm job) it prints the name of a file in the result's folder that has the address; the destructor
/// removes the file. Throws EnvironmentError where neither can be written.
class AddressOutput {
 public:
  AddressOutput(const std::string& folder, const std::string& address);
  ~AddressOutput();
  AddressOutput(const AddressOutput&) = delete;
  AddressOutput& operator=(const AddressOutput&) = delete;

 private:
  std::string file_;  // empty: none
};

}  // namespace tessera::serve
