#include "io/library/artwork_files.h"

#include <fnmatch.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <map>
#include <string_view>

#include "core/base/error.h"

namespace tessera::io {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 9> kExtensions = {".svg",  ".svgz", ".png", ".webp", ".tif",
                                                         ".tiff", ".bmp",  ".jpg", ".jpeg"};

bool is_wanted(const fs::path& file, const std::string& glob) {
  if (!glob.empty()) return ::fnmatch(glob.c_str(), file.filename().c_str(), 0) == 0;
  std::string extension = file.extension();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

void search_folder(const fs::path& folder, const std::string& glob, ArtworkFiles& found) {
  std::error_code error;
  for (fs::directory_iterator at(folder, error); !error && at != fs::directory_iterator(); at.increment(error)) {
    std::error_code ignored;
    if (at->is_directory(ignored) && !at->is_symlink(ignored)) {
      search_folder(at->path(), glob, found);
    } else if (at->is_regular_file(ignored) && is_wanted(at->path(), glob)) {
      found.paths.push_back(at->path());
    }
  }
  if (error) found.unreadable.push_back({folder, "a folder that cannot be read"});
}

/// Where several paths lead to one file, the file's own path stays, or the first of the links.
void remove_repeated(std::vector<std::string>& paths) {
  std::sort(paths.begin(), paths.end());
  std::map<fs::path, std::string> path_of_file;
  for (const std::string& path : paths) {
    std::error_code error;
    fs::path file = fs::canonical(path, error);
    if (error) file = path;
    const auto [at, is_new] = path_of_file.try_emplace(file, path);
    if (!is_new && path == file) at->second = path;
  }
  paths.clear();
  for (auto& [file, path] : path_of_file) paths.push_back(std::move(path));
  std::sort(paths.begin(), paths.end());
}

}  // namespace

ArtworkFiles find_artwork(const std::vector<std::string>& sources, const std::string& glob) {
  ArtworkFiles found;
  for (const std::string& source : sources) {
    const fs::path path = fs::absolute(source).lexically_normal();
    std::error_code error;
    if (fs::is_directory(path, error)) {
      search_folder(path, glob, found);
    } else if (fs::exists(path, error)) {
      found.paths.push_back(path);
    } else {
      throw InputError(source + ": no such file or folder");
    }
  }
  remove_repeated(found.paths);
  std::sort(found.unreadable.begin(), found.unreadable.end(),
            [](const UnusedFile& a, const UnusedFile& b) { return a.path < b.path; });
  return found;
}

}  // namespace tessera::io
