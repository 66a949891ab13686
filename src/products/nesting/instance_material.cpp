#include "products/nesting/instance_material.h"

#include "core/base/count_text.h"
#include "core/base/error.h"
#include "products/nesting/drawings/nest_contours.h"
#include "products/nesting/instance_values.h"

namespace tessera {
namespace {

using nlohmann::json;

constexpr double kLeast_mm = 1e-3;

/// Refuses the older format of jagua-rs, whose keys have capitals and whose bins are called objects.
void check_format(const json& instance, const std::string& path) {
  std::string found;
  for (const char* key : {"Items", "Objects", "Strip"}) {
    if (instance.contains(key)) found += (found.empty() ? "\"" : ", \"") + std::string(key) + "\"";
  }
  if (found.empty()) return;
  throw InputError(path + ": found " + found +
                   ": an instance of an older format of jagua-rs (\"Objects\" are sheets), which is not read; allowed: "
                   "\"items\", and \"strip_height\" or \"bins\", as sparrow and newer versions have them");
}

void check_zones(const json& material, const std::string& where) {
  const json* zones = optional_member(material, "zones");
  if (!zones || (zones->is_array() && zones->empty())) return;
  throw InputError(where + ": zones: found " +
                   (zones->is_array() ? count_text(zones->size(), "zone") : shown_value(*zones)) +
                   ": parts of the material with another quality, which are not read; allowed: no zones");
}

NestBin bin_of(const json& bins, const std::string& where) {
  const std::string cure = "; allowed: one kind, a rectangle without zones";
  if (!bins.is_array()) throw InputError(where + ": found " + shown_value(bins) + cure);
  for (const json& bin : bins) check_zones(bin, where);
  if (bins.size() > 1) {
    throw InputError(where + ": found " + count_text(bins.size(), "kind") +
                     " of bins: sheets of several sizes or costs, which are not read" + cure);
  }
  const json& shape = member(bins.front(), "shape", where);
  const json& type = member(shape, "type", where + ": shape");
  if (type != "rectangle")
    throw InputError(where + ": shape: found " + shown_value(type) + ": a sheet of another shape, which is not read" +
                     cure);
  const InstanceRectangle sheet = rectangle_of(member(shape, "data", where + ": shape"), where + ": shape");
  constexpr int kMostStock = 1'000'000'000;
  const json* stock = optional_member(bins.front(), "stock");
  return {sheet.width, sheet.height, stock ? whole_number_in(*stock, 1, kMostStock, where + ": stock") : 0};
}

}  // namespace

void read_material(const json& instance, const std::string& path, NestInput& input) {
  if (!instance.is_object()) return;
  check_format(instance, path);
  check_zones(instance, path);
  const json* bins = optional_member(instance, "bins");
  const bool has_bins = bins && !(bins->is_array() && bins->empty());
  if (has_bins) input.bin = bin_of(*bins, path + ": bins");
  if (!instance.contains("strip_height")) return;
  if (has_bins) throw InputError(path + ": strip_height and bins: allowed: one of them");
  input.strip_height = number_in(instance["strip_height"], kLeast_mm, kFarthest_mm, path + ": strip_height");
}

void check_quality(const json& item, const std::string& where) {
  const json* quality = optional_member(item, "min_quality");
  if (!quality) return;
  throw InputError(
      where + ": min_quality: found " + shown_value(*quality) +
      ": the piece may lie only where the material is that good, which is not read; allowed: no min_quality");
}

}  // namespace tessera
