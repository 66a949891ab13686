#include "products/nesting/drawings/dxf_document.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/too_many.h"
#include "products/nesting/drawings/nest_contours.h"
#include "text/utf8_text.h"

namespace tessera {

void DxfTally::add(std::string_view name, int count) {
  constexpr std::size_t kMostNames = 8, kMostBytes = 60;
  name = name.substr(0, kMostBytes);
  const auto find = [&] {
    return std::find_if(counts_.begin(), counts_.end(), [&](const auto& of) { return of.first == name; });
  };
  auto at = find();
  if (at == counts_.end() && counts_.size() >= kMostNames) {
    name = "others";
    at = find();
  }
  if (at != counts_.end())
    at->second += count;
  else
    counts_.emplace_back(name, count);
}

void DxfTally::add(const DxfTally& other) {
  for (const auto& [name, count] : other.counts_) add(name, count);
}

int DxfTally::count() const {
  int all = 0;
  for (const auto& [name, count] : counts_) all += count;
  return all;
}

std::string DxfTally::names() const {
  std::string text;
  for (const auto& [name, count] : counts_) text += (text.empty() ? "" : ", ") + printable_utf8(std::string(name));
  return text;
}

bool is_polyline(std::string_view kind) { return kind == "LWPOLYLINE" || kind == "POLYLINE"; }

bool is_in_world(const DxfEntity& entity) {
  constexpr unsigned kIs3d = 8;  // flag of a POLYLINE
  return entity.kind == "LINE" || entity.kind == "SPLINE" ||
         (entity.kind == "POLYLINE" && entity.numbers.has_bit(70, kIs3d));
}

std::string dxf_key(std::string_view name) {
  std::string key(name.substr(0, kMostNameBytes));
  for (char& c : key) c = c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c;
  return key;
}

void fail_dxf_points(const std::string& path) {
  throw InputError(path + ": " + too_many(kMostDrawingPoints, "points in a file"));
}

}  // namespace tessera
