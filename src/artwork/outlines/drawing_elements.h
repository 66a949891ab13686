// The elements of a foreign SVG that draw something themselves (leaves).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tessera {

struct DrawingElement {
  std::string id;          // unique in the text
  std::string name;        // for people: its own id, or its kind and number among elements without id
  bool is_masked = false;  // a mask hides part of it
  bool is_shape = false;   // a path, a basic shape or a <use>; false: text, an image or a foreign object
  bool is_text = false;
  bool shows_picture = false;  // a visible image or foreign object; for a <use> also in what it shows
};

struct DrawingElements {
  std::string text;                  // the SVG with an id for each leaf, with entities resolved and without masks
  std::vector<DrawingElement> list;  // in the order of the file
  bool says_px = false;              // width or height is stated in px
  std::string program;               // the program that wrote the file, "Inkscape 0.48.4"; empty: unknown
};

/// The leaves of an unpacked SVG. Throws InputError, which names `path`, where the bytes are no SVG or have too many
/// leaves (svg_outlines.h).
DrawingElements drawing_elements(std::span<const std::uint8_t> bytes, const std::string& path);

}  // namespace tessera
