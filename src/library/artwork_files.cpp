#include "library/artwork_files.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <map>
#include <string_view>

#include "artwork/images/unread_format.h"
#include "core/base/error.h"
#include "library/name_index.h"

namespace tessera {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 9> kExtensions = {".svg",  ".svgz", ".png", ".webp", ".tif",
                                                         ".tiff", ".bmp",  ".jpg", ".jpeg"};

/// Extensions of pictures that a user may expect to be read.
constexpr std::array<std::string_view, 22> kOtherExtensions = {
    ".gif", ".pdf",  ".eps",  ".ps",   ".ai",  ".cdr", ".emf", ".wmf", ".odg", ".dxf", ".psd",
    ".xcf", ".heic", ".heif", ".avif", ".jxl", ".jp2", ".ico", ".tga", ".pbm", ".pgm", ".ppm"};

std::string extension_of(const fs::path& file) {
  std::string extension = file.extension();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return extension;
}

template <std::size_t N>
bool contains(const std::array<std::string_view, N>& extensions, const std::string& extension) {
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

/// Takes a file that was named. Its content is judged when it is read.
void take_named(const fs::path& file, ArtworkFiles& found) {
  std::error_code error;
  if (fs::is_regular_file(file, error)) {
    found.paths.push_back(file);
  } else {
    found.left_out.push_back({file, "not a regular file"});
  }
}

void take_found(const fs::path& file, ArtworkFiles& found) {
  const std::string extension = extension_of(file);
  if (!contains(kOtherExtensions, extension)) return take_named(file, found);
  found.left_out.push_back({file, unread_format_reason(extension.substr(1))});
}

bool is_artwork(const fs::path& file) {
  const std::string extension = extension_of(file);
  return contains(kExtensions, extension) || contains(kOtherExtensions, extension);
}

/// Adds all files in the folder and in its subfolders to `files`.
void search_folder(const fs::path& folder, std::vector<fs::path>& files, ArtworkFiles& found) {
  std::error_code error;
  for (fs::directory_iterator at(folder, error); !error && at != fs::directory_iterator(); at.increment(error)) {
    std::error_code ignored;
    if (at->is_directory(ignored) && !at->is_symlink(ignored)) {
      if (!is_result_folder(at->path()))
        search_folder(at->path(), files, found);
      else
        found.left_out.push_back({at->path(), "the folder of a collage"});
    } else if (!at->is_directory(ignored)) {
      files.push_back(at->path());
    }
  }
  if (error) found.left_out.push_back({folder, "a folder that cannot be read"});
}

/// Takes the files that match the pattern, by the rule of NameIndex: files whose name is the pattern itself come first.
void take_matching(const std::vector<fs::path>& files, const std::string& glob, ArtworkFiles& found) {
  std::vector<std::string> names;
  for (const fs::path& file : files) names.push_back(file.filename());
  for (const std::uint32_t place : NameIndex(std::move(names)).matching(glob)) take_found(files[place], found);
}

/// Where several paths lead to one file, keeps the file's own path, or the first of the links.
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

/// Sorts the files and keeps each once, because a folder may be given twice.
void sort_by_path(std::vector<UnusedFile>& files) {
  std::sort(files.begin(), files.end(), [](const UnusedFile& a, const UnusedFile& b) { return a.path < b.path; });
  const auto same_path = [](const UnusedFile& a, const UnusedFile& b) { return a.path == b.path; };
  files.erase(std::unique(files.begin(), files.end(), same_path), files.end());
}

}  // namespace

bool has_artwork_name(const std::string& path) { return contains(kExtensions, extension_of(path)); }

bool is_result_folder(const std::string& folder) {
  std::error_code error;
  return fs::exists(fs::path(folder) / "manifest.json", error) &&
         fs::exists(fs::path(folder) / "pieces.geojson", error);
}

ArtworkFiles find_artwork(const std::vector<std::string>& sources, const std::string& glob) {
  ArtworkFiles found;
  std::vector<fs::path> in_folders;
  for (const std::string& source : sources) {
    const fs::path path = fs::absolute(source).lexically_normal();
    std::error_code error;
    if (fs::is_directory(path, error)) {
      search_folder(path, in_folders, found);
    } else if (fs::exists(path, error)) {
      take_named(path, found);
    } else {
      throw InputError(source + ": no such file or folder");
    }
  }
  if (glob.empty()) {
    for (const fs::path& file : in_folders) {
      if (is_artwork(file)) take_found(file, found);
    }
  } else {
    take_matching(in_folders, glob, found);
  }
  remove_repeated(found.paths);
  sort_by_path(found.left_out);
  return found;
}

}  // namespace tessera
