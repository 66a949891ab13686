#include "library/skip_reason_text.h"

namespace tessera {

std::string skip_reason_text(SkipReason reason) {
  switch (reason) {
    case SkipReason::empty:
      return "shows nothing; an image needs transparency, or a shape that stands out from a plain background";
    case SkipReason::too_small: return "too small; save the image with more pixels";
    case SkipReason::several_large_components:
      return "several large parts that do not touch; save each as a file of its own, or join them; a photo is for "
             "tessera "
             "library extract";
    case SkipReason::plain_rectangle:
      return "a plain rectangle; remove it if it is a background, or keep it as a shape (--keep-rectangles)";
    case SkipReason::hairlines: return "too much of it is thin lines; fill what they enclose, or make them thicker";
    case SkipReason::hollow:
      return "an outline with hardly any area; fill it, or let --fill-holes take what it encloses";
    case SkipReason::faint:
      return "too faint: parts of an opacity below 0.08, or lines too thin, do not count, and the rest makes no shape; "
             "make them more opaque or thicker, or build with --edge-opacity 0.05";
  }
  return "unknown";
}

}  // namespace tessera
