// Repetitive files of many megabytes, written block by block, and the resources that a reader needs for them.
#pragma once

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstddef>
#include <fstream>
#include <functional>
#include <string>

#include "core/base/error.h"
#include "support/limited_child.h"

namespace tessera::test {

/// `begin`, then `unit` repeated `times` times, then `end`.
struct LargeText {
  std::string begin, unit;
  std::size_t times = 0;
  std::string end;

  void write(const std::string& path) const {
    std::ofstream file(path, std::ios::binary);
    each_block([&](const std::string& block) { file << block; });
  }

  void write_packed(const std::string& path) const {
    const gzFile file = gzopen(path.c_str(), "wb1");
    each_block([&](const std::string& block) { gzwrite(file, block.data(), unsigned(block.size())); });
    gzclose(file);
  }

 private:
  template <class Take>
  void each_block(Take take) const {
    const std::size_t units = std::max<std::size_t>(1, 65'536 / std::max<std::size_t>(1, unit.size()));
    std::string many;
    for (std::size_t i = 0; i < std::min(units, times); ++i) many += unit;
    take(begin);
    std::size_t left = times;
    for (; left >= units; left -= units) take(many);
    take(many.substr(0, left * unit.size()));
    take(end);
  }
};

#ifdef __SANITIZE_ADDRESS__
inline constexpr std::size_t kMostOfReader_bytes = std::size_t(2) << 30;
#else
/// A drawer may use 512 MiB more than it has at its start.
inline constexpr std::size_t kMostOfReader_bytes = std::size_t(640) << 20;
#endif

/// Expects that `read` refuses the file with one line that contains the path and `said`. An empty `said` expects that `read` takes the
/// file. Either way `read` needs little time and memory.
inline void expect_refused(const std::string& path, const std::string& said, const std::function<void()>& read) {
  const ChildReport report = in_child([&]() -> std::string {
    try {
      read();
      return "";
    } catch (const InputError& error) {
      return error.what();
    } catch (const std::exception& error) {
      return std::string("no InputError: ") + error.what();
    }
  });
  const std::string name = path.substr(path.rfind('/') + 1);
  EXPECT_EQ(report.death, "") << name;
  EXPECT_LT(report.peak_bytes, kMostOfReader_bytes) << name;
  EXPECT_NE(report.said.find(said), std::string::npos) << name << ": " << report.said;
  EXPECT_EQ(report.said.empty(), said.empty()) << name << ": " << report.said;
  EXPECT_EQ(report.said.find(path) != std::string::npos, !said.empty()) << report.said;
  EXPECT_EQ(report.said.find('\n'), std::string::npos) << report.said;
}

}  // namespace tessera::test
