// The base of tests with forged files. A child process with limits reads each forgery.
// It must refuse the file with the file's name, or take it as a valid file.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <exception>
#include <string>

#include "core/base/error.h"
#include "support/limited_child.h"

namespace tessera::test {

/// A description of the forgery, and whether a reader may take the file for a different valid file. Numbers that are possible are no error,
/// whoever wrote them.
struct Forgery {
  std::string what;
  bool may_differ = false;
};

class HostileFile : public testing::Test {
 protected:
  /// Writes the valid file, then changes it.
  virtual Forgery forge(std::uint32_t seed) = 0;
  /// Reads everything that the program reads of the file. Returns what is wrong with it, or an empty text.
  virtual std::string read(bool may_differ) const = 0;
  virtual const std::string& path() const = 0;

  /// Returns the message of the refusal, or "WRONG: " and the mistake, or an empty text.
  std::string use(bool may_differ) const {
    try {
      const std::string wrong = read(may_differ);
      return wrong.empty() ? wrong : "WRONG: " + wrong;
    } catch (const InputError& error) {
      return error.what();
    } catch (const std::exception& error) {
      return std::string("WRONG: not an InputError: ") + error.what();
    }
  }

  /// Returns whether the reader refused the file.
  bool try_file(const Forgery& forgery, std::uint32_t seed) const {
    const std::string what = "seed " + std::to_string(seed) + ": " + forgery.what;
    const ChildReport report = in_child([&] { return use(forgery.may_differ); });
    expect_survived(report, what);
    if (report.said.empty()) return false;
    expect_names_the_file(report.said, path(), what);
    return true;
  }

  /// Returns the number of refused files.
  std::uint32_t try_forgeries(std::uint32_t first, std::uint32_t count) {
    std::uint32_t refused = 0;
    for (std::uint32_t seed = first; seed < first + count; ++seed) refused += try_file(forge(seed), seed);
    return refused;
  }
};

}  // namespace tessera::test
