#include "products/texture/texture_job.h"

#include <cmath>

#include "job/toml_string.h"
#include "job/written_job.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

constexpr const char* kAuthor = "tessera texture";

/// Copies of an element stay so many mean sides apart.
constexpr double kCopiesApart_elements = 2;

std::string whole(double value) { return std::to_string(std::lround(value)); }

}  // namespace

std::string texture_job(const TextureFiles& files, const TexturePlan& plan) {
  const std::string width = std::to_string(plan.enlarged * plan.texture_px.width),
                    height = std::to_string(plan.enlarged * plan.texture_px.height);
  const std::string ground =
      files.ground.empty()
          ? ""
          : "# What shows where the photo has nothing that fits.\nground = " + toml_string(files.ground) + "\n";
  return with_written_mark("# A texture of " + printable_utf8(files.photo) +
                               " by tessera texture. Change what you like, then: tessera collage THIS_FILE\n"
                               "# Every key of a job: docs/job-format.md\n"
                               "\n"
                               "seed = 1\n"
                               "# The pieces of the layout stand. \"good\" exchanges the others, with little gain.\n"
                               "quality = \"draft\"\n"
                               "\n"
                               "[library]\n"
                               "file = " +
                               toml_string(files.library) +
                               "\n"
                               "\n"
                               "[canvas]\n"
                               "size_px = [" +
                               width + ", " + height +
                               "]\n"
                               "seamless = \"both\"\n"
                               "\n"
                               "[start]\n"
                               "# The elements as they lie side by side in the photo. Others fill the gaps.\n"
                               "pieces = " +
                               toml_string(files.layout) +
                               "\n"
                               "keep = \"standing\"\n"
                               "\n"
                               "[pieces]\n"
                               "sizes = \"drawn\"\n"
                               "rotation_deg = [-5, 5]  # more turns the light of the photo, too\n"
                               "uses = " +
                               std::to_string(plan.uses) +
                               "  # of each element\n"
                               "padding_px = 1\n"
                               "apart_px = " +
                               whole(kCopiesApart_elements * plan.element_px) +
                               "\n"
                               "\n"
                               "[objective]\n"
                               "repetition_exponent = 1.5\n"
                               "\n"
                               "[colour]\n"
                               "pieces = \"artwork\"  # also where all elements have one colour\n"
                               "\n"
                               "[output]\n"
                               "width_px = " +
                               std::to_string(plan.texture_px.width) +
                               "\n"
                               "background = \"photo\"  # what lies round each element in the photo\n" +
                               ground,
                           kAuthor);
}

bool is_texture_job(const std::string& text) { return has_written_mark(text, kAuthor); }

bool is_unedited_texture_job(const std::string& text) { return is_as_written(text, kAuthor); }

}  // namespace tessera
