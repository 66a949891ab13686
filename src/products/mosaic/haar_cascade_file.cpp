#include "products/mosaic/haar_cascade_file.h"

#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include "artwork/xml/xml_tree.h"
#include "core/base/error.h"
#include "files/regular_file.h"

namespace tessera {
namespace {

/// The largest known cascade has 1 MB.
constexpr std::size_t kMostBytes = std::size_t(8) << 20;
constexpr double kMostWhole = 1e6;

void require(bool holds, const std::string& what) {
  if (!holds) throw InputError(what);
}

const xmlNode* child(const xmlNode* parent, std::string_view name) {
  for (const xmlNode* node = parent->children; node; node = node->next) {
    if (node->type == XML_ELEMENT_NODE && name_of(node) == name) return node;
  }
  throw InputError("<" + std::string(name) + "> is missing");
}

/// The children named "_": OpenCV's XML writes each item of a list as such an element.
std::vector<const xmlNode*> items(const xmlNode* list) {
  std::vector<const xmlNode*> found;
  for (const xmlNode* node = list->children; node; node = node->next) {
    if (node->type == XML_ELEMENT_NODE && name_of(node) == "_") found.push_back(node);
  }
  return found;
}

std::vector<double> numbers_of(const xmlNode* node) {
  const std::string text = content_of(node);
  std::string_view rest = text;
  std::vector<double> numbers;
  for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
    double number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    require(
        error == std::errc() && end == word.data() + word.size() && std::isfinite(number),
        "found \"" + std::string(word.substr(0, 20)) + "\" in <" + std::string(name_of(node)) + ">, allowed: numbers");
    numbers.push_back(number);
  }
  return numbers;
}

double number_in(const xmlNode* parent, std::string_view name) {
  const std::vector<double> numbers = numbers_of(child(parent, name));
  require(numbers.size() == 1, "<" + std::string(name) + "> is no number");
  return numbers.front();
}

int whole(double number) {
  require(std::abs(number) <= kMostWhole && number == std::floor(number), "found an index that is no whole number");
  return int(number);
}

HaarFeature feature_of(const xmlNode* node) {
  for (const xmlNode* other = node->children; other; other = other->next)
    require(name_of(other) != "tilted" || content_of(other) == "0", "found tilted features, allowed: upright ones");
  HaarFeature feature;
  for (const xmlNode* part : items(child(node, "rects"))) {
    const std::vector<double> n = numbers_of(part);
    require(n.size() == 5, "found a rectangle that has not five numbers");
    feature.push_back({{whole(n[0]), whole(n[1]), whole(n[2]), whole(n[3])}, n[4]});
  }
  return feature;
}

HaarTree tree_of(const xmlNode* node) {
  constexpr std::size_t kNumbersOfNode = 4;
  const std::vector<double> n = numbers_of(child(node, "internalNodes"));
  require(n.size() % kNumbersOfNode == 0, "found nodes that have not four numbers each");
  HaarTree tree{.nodes = {}, .leaves = numbers_of(child(node, "leafValues"))};
  for (std::size_t i = 0; i < n.size(); i += kNumbersOfNode)
    tree.nodes.push_back(
        {.below = whole(n[i]), .from = whole(n[i + 1]), .feature = whole(n[i + 2]), .threshold = n[i + 3]});
  return tree;
}

HaarCascade cascade_of(const xmlNode* root) {
  const xmlNode* cascade = child(root, "cascade");
  require(content_of(child(cascade, "featureType")) == "HAAR", "found features of another type, allowed: HAAR");
  std::vector<HaarFeature> features;
  for (const xmlNode* feature : items(child(cascade, "features"))) features.push_back(feature_of(feature));
  std::vector<HaarStage> stages;
  for (const xmlNode* stage : items(child(cascade, "stages"))) {
    HaarStage& read = stages.emplace_back();
    read.threshold = number_in(stage, "stageThreshold");
    for (const xmlNode* tree : items(child(stage, "weakClassifiers"))) read.trees.push_back(tree_of(tree));
  }
  const cv::Size window_px(whole(number_in(cascade, "width")), whole(number_in(cascade, "height")));
  return {window_px, std::move(features), std::move(stages)};
}

}  // namespace

HaarCascade read_haar_cascade(const std::string& path) {
  const std::vector<std::uint8_t> bytes = read_regular_file(path, kMostBytes);
  const XmlContextPtr context = new_xml_context();
  const XmlDocPtr doc = read_xml(*context, bytes, XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING);
  try {
    require(doc && !doc->intSubset && xmlDocGetRootElement(doc.get()), "no XML, damaged, or with declarations");
    return cascade_of(xmlDocGetRootElement(doc.get()));
  } catch (const InputError& error) {
    throw InputError(path + ": is no cascade of upright Haar-like features: " + error.what());
  }
}

}  // namespace tessera
