#include "artwork/svg/fonts.h"

#include <fontconfig/fontconfig.h>

#include <string_view>

namespace tessera {
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

/// Whether the text ends with the start of a tag, with a prefix or without.
bool ends_in_tag(std::string_view text) {
  const std::size_t end = text.find_last_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-:");
  return end != text.npos && text[end] == '<';
}

bool has_text(std::span<const std::uint8_t> svg) {
  const std::string_view characters(reinterpret_cast<const char*>(svg.data()), svg.size());
  constexpr std::string_view kName = "text";
  for (std::size_t at = characters.find(kName); at != characters.npos; at = characters.find(kName, at + 1)) {
    const bool is_name = at > 0 && (characters[at - 1] == '<' || characters[at - 1] == ':');
    if (is_name && ends_in_tag(characters.substr(0, at))) return true;
  }
  return false;
}

}  // namespace

bool has_fonts() {
  static const bool any = ask_fontconfig();
  return any;
}

bool loses_text(std::span<const std::uint8_t> svg) { return has_text(svg) && !has_fonts(); }

}  // namespace tessera
