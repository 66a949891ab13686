// The name of a result, which is that of its folder.
#pragma once

#include <filesystem>
#include <string>

namespace tessera {

/// The page of a result, in its folder.
inline constexpr const char* kReportName = "report.html";

/// The last name of a path, with or without a slash at its end: "seed_1" of "DIR/seed_1/". "." has the name of its folder.
inline std::string folder_name(const std::string& folder) {
  const std::filesystem::path path = std::filesystem::absolute(folder).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

}  // namespace tessera
