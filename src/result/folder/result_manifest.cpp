#include "result/folder/result_manifest.h"

#include <nlohmann/json.hpp>
#include <span>

#include "core/base/digest.h"
#include "core/base/error.h"
#include "files/atomic_file.h"
#include "job/picture_size.h"
#include "result/folder/result_file.h"
#include "text/digest_text.h"

namespace tessera {
namespace {

using Json = nlohmann::ordered_json;

using ReadJson = nlohmann::json;  // an ordered one is very slow for an object with very many members

constexpr int kFormat = 1;
/// Room for a list of shapes and two lists of colours, for some hundred thousand pieces.
constexpr JsonBounds kBounds{.values = 2'000'000, .levels = 32};

void check_colours(const std::vector<std::string>& colours, std::size_t pieces, bool may_be_none) {
  if (colours.empty()) return;
  if (colours.size() != pieces) throw InputError("not as many colours as pieces");
  for (const std::string& text : colours) {
    if (may_be_none && text.empty()) continue;
    if (text.size() != 7 || text[0] != '#' || text.find_first_not_of("0123456789abcdef", 1) != text.npos)
      throw InputError("found the colour \"" + text.substr(0, 20) + "\", allowed: #rrggbb");
  }
}

/// The table of keys of [output], beside its width, that the manifest keeps for a picture; one in each row. `Output` is
/// OutputSpec, const or not.
template <class Output, class Visit>
void each_output_key(Output& output, Visit visit) {
  visit("width_mm", output.width_mm);
  visit("dpi", output.dpi);
  visit("background", output.background);
  visit("outline_px", output.outline_px);
  visit("outline_colour", output.outline_colour);
  visit("shadow_strength", output.shadow_strength);
  visit("shadow_offset_px", output.shadow_offset_px);
  visit("shadow_blur_px", output.shadow_blur_px);
  visit("clip", output.clip);
  visit("keep_out", output.keep_out);
  visit("ground", output.ground);
  visit("ground_px", output.ground_px);
  if (output.background == kImageBackground) visit("background_light", output.background_light);
}

Json to_json(const DrawnPicture& picture) {
  Json json{{"file", picture.file}, {"width_px", picture_width_px(picture.output)}};
  each_output_key(picture.output, [&](const char* key, const auto& value) { json[key] = value; });
  if (picture.shift > 0) json["shift"] = picture.shift;
  if (picture.overlay > 0) json["overlay"] = picture.overlay;
  if (picture.harmony) {
    json["harmony"] = {{"template", letter_of(picture.harmony->form)}, {"angle_deg", picture.harmony->angle_deg}};
  }
  if (picture.colours) json["palette"] = *picture.colours;
  return json;
}

Harmony harmony_from_json(const ReadJson& harmony) {
  return {template_of(harmony.at("template").get<std::string>()), harmony.at("angle_deg")};
}

/// The output of a picture. Keys that results of earlier versions lack get their defaults.
OutputSpec output_from_json(const ReadJson& picture) {
  OutputSpec output;
  output.width_px = picture.at("width_px");
  each_output_key(output, [&](const char* key, auto& value) {
    if (picture.contains(key)) picture.at(key).get_to(value);
  });
  return output;
}

ResultManifest from_json(const ReadJson& json) {
  if (json.at("format") != kFormat) throw InputError("another format than " + std::to_string(kFormat));
  ResultManifest manifest;
  manifest.finished = json.at("state") == "finished";
  manifest.pieces_digest = json.at("pieces").at("digest");
  manifest.shapes = json.at("pieces").at("shapes").get<std::vector<ShapeId>>();
  manifest.missing = json.at("pieces").value("missing", std::uint64_t(0));
  manifest.deformed = json.at("pieces").value("deformed", false);
  manifest.job_digest = json.at("job").at("digest");
  manifest.library = json.at("library").at("file");
  manifest.library_digest = digest_of_text(json.at("library").at("digest"));
  manifest.canvas_digest = digest_of_text(json.at("canvas").at("digest"));
  if (json.contains("overlays")) manifest.overlay_digest = digest_of_text(json.at("overlays").at("digest"));
  if (json.contains("start")) {
    manifest.start = json.at("start").at("pieces");
    manifest.start_digest = digest_of_text(json.at("start").at("digest"));
  }
  if (json.contains("colours")) manifest.colours = json.at("colours").get<std::vector<std::string>>();
  if (json.contains("covered")) manifest.covered = json.at("covered").get<std::vector<std::string>>();
  check_colours(manifest.colours, manifest.shapes.size(), false);
  check_colours(manifest.covered, manifest.shapes.size(), true);
  for (const ReadJson& picture : json.at("pictures")) {
    manifest.pictures.push_back({picture.at("file"), output_from_json(picture)});
    manifest.pictures.back().shift = picture.value("shift", 0.);
    manifest.pictures.back().overlay = picture.value("overlay", 0.);
    if (picture.contains("harmony")) manifest.pictures.back().harmony = harmony_from_json(picture.at("harmony"));
    if (picture.contains("palette"))
      manifest.pictures.back().colours = picture.at("palette").get<std::vector<std::string>>();
  }
  return manifest;
}

ResultManifest parsed(const std::string& dir) {
  const std::string bytes = read_result_json(dir, kManifestName, kBounds);
  const std::string path = path_in_result(dir, kManifestName);
  try {
    return from_json(ReadJson::parse(bytes));
  } catch (const nlohmann::json::exception& error) {
    throw InputError(path + ": not a manifest of tessera collage: " + error.what());
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
}

void check_digest(const std::string& dir, const char* name, const std::string& expected) {
  FileBlocks blocks = open_result_file(dir, name, kMostPiecesBytes);
  while (!blocks.next().empty()) {
  }
  if (digest_text(blocks.digest()) == expected) return;
  throw InputError(path_in_result(dir, name) + ": not the file that " + kManifestName + " was written with");
}

}  // namespace

std::string text_digest(const std::string& bytes) {
  Digest digest;
  digest.add_all(std::span(bytes));
  return digest_text(digest.value());
}

void write_manifest(const std::string& dir, const ResultManifest& manifest) {
  Json pictures = Json::array();
  for (const DrawnPicture& picture : manifest.pictures) {
    pictures.push_back(to_json(picture));
  }
  Json json{{"format", kFormat},
            {"state", manifest.finished ? "finished" : "unfinished"},
            {"pieces", {{"digest", manifest.pieces_digest}, {"shapes", manifest.shapes}}},
            {"job", {{"digest", manifest.job_digest}}},
            {"library", {{"file", manifest.library}, {"digest", digest_text(manifest.library_digest)}}},
            {"canvas", {{"digest", digest_text(manifest.canvas_digest)}}},
            {"pictures", pictures}};
  if (manifest.missing > 0) json["pieces"]["missing"] = manifest.missing;
  if (manifest.deformed) json["pieces"]["deformed"] = true;
  if (manifest.overlay_digest != 0) json["overlays"] = {{"digest", digest_text(manifest.overlay_digest)}};
  if (!manifest.start.empty())
    json["start"] = {{"pieces", manifest.start}, {"digest", digest_text(manifest.start_digest)}};
  if (!manifest.colours.empty()) json["colours"] = manifest.colours;
  if (!manifest.covered.empty()) json["covered"] = manifest.covered;
  write_file_atomically(path_in_result(dir, kManifestName),
                        json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
}

ResultManifest read_manifest(const std::string& dir) {
  ResultManifest manifest = parsed(dir);
  check_digest(dir, "pieces.geojson", manifest.pieces_digest);
  check_digest(dir, "job.toml", manifest.job_digest);
  return manifest;
}

}  // namespace tessera
