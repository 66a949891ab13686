#include "products/nesting/drawings/dxf_reader.h"

#include <array>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/base/too_many.h"
#include "products/nesting/drawings/dxf_entities.h"

namespace tessera {
namespace {

constexpr std::size_t kMostNames = 100'000;  // of layers and of blocks

/// Millimetres in a unit of $INSUNITS: none, inch, foot, mile, mm, cm, m, km, microinch, mil, yard, angstrom, nm, um, dm,
/// dam, hm, Gm, astronomical unit, light year, parsec.
constexpr std::array<double, 21> kMmOfUnit = {1,
                                              25.4,
                                              304.8,
                                              1609344,
                                              1,
                                              10,
                                              1000,
                                              1e6,
                                              2.54e-5,
                                              0.0254,
                                              914.4,
                                              1e-7,
                                              1e-6,
                                              1e-3,
                                              100,
                                              1e4,
                                              1e5,
                                              1e12,
                                              1.495978707e14,
                                              9.4607304725808e18,
                                              3.0856775814913673e19};

class DxfReader {
 public:
  DxfReader(std::string_view text, const std::string& path)
      : pairs_(text, path),
        path_(path),
        entities_(pairs_, path) {}

  DxfDocument read() {
    DxfPair pair;
    while (pairs_.next(pair)) {
      if (pair.code == 0 && pair.value == "EOF") break;
      if (pair.code == 0)
        begin(pair);
      else
        value(pair);
    }
    end_part();
    if (!saw_section_) throw InputError(path_ + ": not an ASCII DXF file");
    return std::move(document_);
  }

 private:
  /// The thing that pairs between two pairs of code 0 belong to.
  enum class Part { none, section_name, layer, block, entity };

  void begin(const DxfPair& pair) {
    const bool is_of_block = section_ == "BLOCKS" && pair.value != "BLOCK" && pair.value != "ENDBLK";
    if ((is_of_block || section_ == "ENTITIES") && pair.value != "ENDSEC" && pair.value != "SECTION") {
      entities_.begin(pair, drawn_on(), document_.in_paper);
      part_ = Part::entity;
      return;
    }
    end_part();
    if (pair.value == "SECTION") {
      section_ = {};
      saw_section_ = true;
      part_ = Part::section_name;
    } else if (pair.value == "ENDSEC") {
      section_ = {};
    } else if (section_ == "TABLES" && pair.value == "LAYER") {
      part_ = Part::layer;
    } else if (section_ == "BLOCKS" && pair.value == "BLOCK") {
      part_ = Part::block;
    }
  }

  /// The block to which new entities are added.
  DxfBlock& drawn_on() { return section_ == "BLOCKS" ? block_ : document_.model; }

  void value(const DxfPair& pair) {
    switch (part_) {
      case Part::none: break;
      case Part::section_name:
        if (pair.code == 2 && section_.empty())
          section_ = pair.value;
        else
          header(pair);
        break;
      case Part::layer: layer(pair); break;
      case Part::block: block(pair); break;
      case Part::entity: entities_.value(pair); break;
    }
  }

  void header(const DxfPair& pair) {
    if (section_ != "HEADER") return;
    if (pair.code == 9) variable_ = pair.value;
    if (pair.code != 70) return;
    if (variable_ == "$MEASUREMENT") document_.measures_in_inches = pairs_.number(pair) == 0;
    if (variable_ != "$INSUNITS") return;
    const double unit = pairs_.number(pair);
    if (!(unit >= 0 && unit < double(kMmOfUnit.size()) && unit == std::floor(unit)))
      pairs_.fail(pair.line + 1, "$INSUNITS: found " + std::string(pair.value.substr(0, 20)) +
                                     ", allowed: a whole number from 0 to 20");
    document_.mm = kMmOfUnit[std::size_t(unit)];
    document_.says_unit = unit > 0;
  }

  void layer(const DxfPair& pair) {
    if (pair.code == 2) layer_name_ = pair.value;
    if (pair.code == 62) layer_.is_off = pairs_.number(pair) < 0;
    if (pair.code == 70) layer_.is_frozen = std::fmod(pairs_.number(pair), 2) == 1;
  }

  void block(const DxfPair& pair) {
    constexpr double kIsExternal = 4;
    if (pair.code == 2) block_.name = pair.value;
    if (pair.code == 10) block_.base.x = pairs_.number(pair);
    if (pair.code == 20) block_.base.y = pairs_.number(pair);
    if (pair.code == 70) block_.is_external = std::fmod(pairs_.number(pair), 2 * kIsExternal) >= kIsExternal;
  }

  /// Stores the data of the part that ends.
  void end_part() {
    entities_.finish(drawn_on(), document_.in_paper);
    if (part_ == Part::layer) {
      if (layer_.is_off || layer_.is_frozen) keep(document_.layers, layer_name_, layer_, "layers");
      layer_ = {};
      layer_name_ = {};
    }
    // A block continues with its entities; its end, another block or the section's end closes it.
    const bool closes_block = section_ == "BLOCKS" && (part_ == Part::entity || part_ == Part::block);
    if (closes_block && !block_.name.empty()) keep(document_.blocks, block_.name, std::move(block_), "blocks");
    if (closes_block) block_ = {};
    part_ = Part::none;
  }

  template <class Thing>
  void keep(std::map<std::string, Thing>& things, std::string_view name, Thing thing, const char* what) {
    if (things.size() >= kMostNames) throw InputError(path_ + ": " + too_many(kMostNames, what));
    things.insert_or_assign(dxf_key(name), std::move(thing));
  }

  DxfPairs pairs_;
  const std::string& path_;
  DxfEntities entities_;
  DxfDocument document_;
  std::string_view section_, variable_, layer_name_;
  DxfLayer layer_;
  DxfBlock block_;
  Part part_ = Part::none;
  bool saw_section_ = false;
};

}  // namespace

DxfDocument dxf_document(std::string_view text, const std::string& path) { return DxfReader(text, path).read(); }

}  // namespace tessera
