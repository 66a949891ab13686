#include "artwork/warping/warped_svg.h"

#include <algorithm>

#include "artwork/svg/flattened_svg.h"
#include "artwork/warping/svg_warper.h"
#include "artwork/xml/xml_tree.h"
#include "core/base/error.h"

namespace tessera {
namespace {

/// Sizes of a page that single precision can deform.
constexpr double kSmallestPage = 1e-3, kLargestPage = 1e6;

}  // namespace

std::string warped_svg(std::span<const std::uint8_t> bytes, const std::string& path, const std::string& scope_id,
                       const Warp& page_warp) {
  const FlattenedSvg flattened = flattened_svg(bytes, path);
  const double side = std::max(flattened.page.width, flattened.page.height);
  if (side < kSmallestPage || side > kLargestPage) throw InputError(path + ": its page is too small or too large");
  const std::span text(reinterpret_cast<const std::uint8_t*>(flattened.text.data()), flattened.text.size());
  const XmlDocPtr doc = parsed_svg(text, path);
  try {
    return SvgWarper(xmlDocGetRootElement(doc.get()), flattened, scope_id, page_warp).warped();
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
}

}  // namespace tessera
