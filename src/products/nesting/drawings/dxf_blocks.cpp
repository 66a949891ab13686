#include "products/nesting/drawings/dxf_blocks.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/base/too_many.h"
#include "products/nesting/drawings/affine.h"
#include "products/nesting/drawings/dxf_outlines.h"
#include "products/nesting/drawings/nest_contours.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

constexpr std::size_t kMostLevels = 64;
constexpr std::size_t kMostEntities = 200'000;
constexpr double kMostScale = 1e40;  // products of larger coordinates could overflow

/// A block, and how a reference places it.
struct PlacedBlock {
  const DxfBlock* block = nullptr;
  Affine mm_from_block;
  std::string_view layer = "0";  // layer of the reference, which entities on layer 0 of the block get
};

/// Maps a block's coordinates, for one place of the reference's array.
Affine placement(const DxfEntity& insert, const DxfBlock& block, int column, int row) {
  const DxfNumbers& of = insert.numbers;
  const NestTurn turn = turn_of(of.get(50));
  const Affine turned{turn.cosine, turn.sine, -turn.sine, turn.cosine, of.get(10), of.get(20)};
  const Affine scaled{of.get(41, 1), 0, 0, of.get(42, 1), column * of.get(44), row * of.get(45)};
  const Affine from_base{1, 0, 0, 1, -block.base.x, -block.base.y};
  return plane_of(insert).after(turned).after(scaled).after(from_base);
}

class DxfDrawer {
 public:
  DxfDrawer(const DxfDocument& document, const std::string& path) : document_(document), path_(path) {}

  void draw(const PlacedBlock& placed) {
    found_.unread.add(placed.block->unread);
    for (const DxfEntity& entity : placed.block->entities) {
      count_entity();
      const std::string_view layer = entity.layer == "0" ? placed.layer : entity.layer;
      if (entity.numbers.get(60) == 1)
        ++found_.invisible;
      else if (is_hidden(entity, layer))
        found_.hidden.add(layer);
      else if (entity.kind == "INSERT")
        refer(entity, layer, placed.mm_from_block);
      else
        add_line(entity, placed.mm_from_block);
    }
  }

  DxfLines take() { return std::move(found_); }

 private:
  /// Whether the layer hides the entity. A reference on a layer that is off still draws the parts of its block on other
  /// layers; on a frozen layer it draws nothing.
  bool is_hidden(const DxfEntity& entity, std::string_view layer) const {
    if (document_.layers.empty()) return false;
    const auto found = document_.layers.find(dxf_key(layer));
    if (found == document_.layers.end()) return false;
    return found->second.is_frozen || (found->second.is_off && entity.kind != "INSERT");
  }

  void refer(const DxfEntity& insert, std::string_view layer, const Affine& mm) {
    const auto found = document_.blocks.find(dxf_key(insert.block));
    if (found == document_.blocks.end() || found->second.is_external) {
      found_.missing.add(insert.block);
      return;
    }
    const DxfBlock& block = found->second;
    if (std::find(inside_.begin(), inside_.end(), &block) != inside_.end()) fail(block, "it contains itself");
    if (inside_.size() >= kMostLevels) throw InputError(path_ + ": " + too_many(kMostLevels, "levels of blocks"));
    inside_.push_back(&block);
    const int columns = count_in(insert, 70), rows = count_in(insert, 71);
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        count_entity();
        const Affine placed = mm.after(placement(insert, block, column, row));
        if (!placed.is_within(kMostScale)) fail(block, "found a reference that makes it too large");
        draw({&block, placed, layer});
      }
    }
    inside_.pop_back();
  }

  static int count_in(const DxfEntity& insert, int code) {
    constexpr double kMost = 32'767;
    return int(std::clamp(insert.numbers.get(code, 1), 1.0, kMost));
  }

  void add_line(const DxfEntity& entity, const Affine& mm) {
    NestRing line = dxf_outline(entity, mm, kMostDrawingPoints - points_);
    // A spline may have more control points than points; then its references would take long and draw little.
    points_ += std::max(line.size(), entity.vertices.size());
    if (points_ > kMostDrawingPoints) fail_dxf_points(path_);
    if (line.size() > 1) found_.lines.push_back(std::move(line));
  }

  void count_entity() {
    if (++entities_ > kMostEntities) throw InputError(path_ + ": " + too_many(kMostEntities, "entities in its blocks"));
  }

  [[noreturn]] void fail(const DxfBlock& block, const std::string& what) const {
    throw InputError(path_ + ": block \"" + cut_utf8(printable_utf8(std::string(block.name.substr(0, 200))), 60) +
                     "\": " + what);
  }

  const DxfDocument& document_;
  const std::string& path_;
  DxfLines found_;
  std::vector<const DxfBlock*> inside_;  // the blocks that are being drawn, the outermost first
  std::size_t points_ = 0, entities_ = 0;
};

}  // namespace

DxfLines dxf_lines(const DxfDocument& document, const std::string& path) {
  DxfDrawer drawer(document, path);
  drawer.draw({&document.model, {document.mm, 0, 0, -document.mm, 0, 0}, "0"});
  return drawer.take();
}

}  // namespace tessera
