#include "io/artwork/fonts.h"

#include <fontconfig/fontconfig.h>

#include <string_view>

namespace tessera::io {
namespace {

bool has_any(FcConfig* config, FcSetName set) {
  const FcFontSet* fonts = FcConfigGetFonts(config, set);
  return fonts && fonts->nfont > 0;
}

bool ask_fontconfig() {
  FcConfig* config = FcConfigReference(nullptr);
  if (!config) return false;
  const bool any = has_any(config, FcSetSystem) || has_any(config, FcSetApplication);
  FcConfigDestroy(config);
  return any;
}

bool has_text(std::span<const std::uint8_t> svg) {
  const std::string_view characters(reinterpret_cast<const char*>(svg.data()), svg.size());
  return characters.find("<text") != characters.npos || characters.find(":text") != characters.npos;
}

}  // namespace

bool has_fonts() {
  static const bool any = ask_fontconfig();
  return any;
}

bool loses_text(std::span<const std::uint8_t> svg) { return has_text(svg) && !has_fonts(); }

}  // namespace tessera::io
