#include "artwork/outlines/layer_paths.h"

#include <string_view>
#include <unordered_map>

#include "artwork/outlines/svg_outlines.h"
#include "artwork/svg/flattened_nodes.h"
#include "artwork/svg/svg_values.h"
#include "artwork/xml/xml_tree.h"
#include "core/base/error.h"
#include "core/base/too_many.h"
#include "files/write_all.h"

namespace tessera {
namespace {

class LayerReader {
 public:
  explicit LayerReader(const xmlNode* root) { list_ids(root); }

  /// The matrix and the clips of a part of the layer.
  struct Frame {
    cairo_matrix_t layer_from_user;
    std::vector<std::shared_ptr<const LayerClip>> clips;
    int depth = 0;
  };

  void read_children(const xmlNode* node, const Frame& frame) {
    constexpr int kDeepest = 600;
    if (frame.depth > kDeepest) throw InputError("its elements stand too deep in each other");
    for (const xmlNode* child = first_child(node); child; child = next_sibling(child)) read(child, frame);
  }

  std::vector<LayerPath> take() { return std::move(paths_); }

 private:
  void list_ids(const xmlNode* node) {
    if (const std::string id = attribute(node, "id"); !id.empty()) nodes_.emplace(id, node);
    for (const xmlNode* child = first_child(node); child; child = next_sibling(child)) list_ids(child);
  }

  void read(const xmlNode* node, const Frame& outer) {
    const std::string_view kind = name_of(node);
    if (kind != "g" && kind != "use" && kind != "path") return;
    Frame frame{product(outer.layer_from_user, svg_matrix(attribute(node, "transform"))), outer.clips, outer.depth + 1};
    add_clip(node, outer, frame);
    if (kind == "g") read_children(node, frame);
    if (kind == "use") read_use(node, frame);
    if (kind == "path") read_path(node, frame);
  }

  /// Reads the group that is shown. cairo clips its surface to the page where it defines it; that clip is ignored,
  /// since nested content may lie beside the page.
  void read_use(const xmlNode* use, const Frame& frame) {
    constexpr int kMostUses = 10'000;
    if (++uses_ > kMostUses) throw InputError(too_many(kMostUses, "groups"));
    const auto found = nodes_.find(reference(use));
    if (found != nodes_.end() && name_of(found->second) == "g") read_children(found->second, frame);
  }

  void add_clip(const xmlNode* node, const Frame& outer, Frame& frame) {
    const std::string id = local_id(attribute(node, "clip-path"));
    if (id.empty()) return;
    const auto found = nodes_.find(id);
    const xmlNode* const shape = found == nodes_.end() ? nullptr : only_child(found->second);
    if (!shape) throw InputError("a clip without a path");
    // cairo writes clips in the units of what they cut, without the transform of the <use>.
    frame.clips.push_back(std::make_shared<LayerClip>(LayerClip{
        transformed(outer.layer_from_user, counted(steps_of(shape))), attribute(node, "clip-rule") == "evenodd"}));
  }

  void read_path(const xmlNode* node, const Frame& frame) {
    const Style style = svg_style(attribute(node, "style"));
    const auto is_painted = [&](const std::string& what) {
      const std::string value = value_of(style, what), opacity = value_of(style, what + "-opacity");
      return !value.empty() && value != "none" && (opacity.empty() || svg_number(opacity) > 0);
    };
    const std::string width = value_of(style, "stroke-width");
    LayerPath path{.filled = is_painted("fill"),
                   .stroked = is_painted("stroke") && (width.empty() || svg_number(width) > 0),
                   .even_odd = value_of(style, "fill-rule") == "evenodd",
                   .clips = frame.clips};
    if (!path.filled && !path.stroked) return;
    path.steps = transformed(frame.layer_from_user, counted(steps_of(node)));
    if (!path.steps.empty()) paths_.push_back(std::move(path));
  }

  PathSteps counted(PathSteps steps) {
    steps_ += steps.size();
    if (steps_ > kMostOutlineSteps) throw InputError(too_many(kMostOutlineSteps, "points and curves"));
    return steps;
  }

  std::unordered_map<std::string, const xmlNode*> nodes_;
  std::vector<LayerPath> paths_;
  std::size_t steps_ = 0;
  int uses_ = 0;
};

}  // namespace

std::vector<LayerPath> layer_paths(const std::string& svg) {
  const XmlDocPtr doc = parsed_svg(bytes_of(svg), "a layer");
  const xmlNode* const root = xmlDocGetRootElement(doc.get());
  LayerReader reader(root);
  reader.read_children(root, {identity(), {}, 0});
  return reader.take();
}

}  // namespace tessera
