// The elements of a foreign SVG that draw something by themselves.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tessera {

struct SvgLeaf {
  std::string id;          // no other element of the text has it
  std::string name;        // for people: its own id, or its kind and its number among the elements without one
  bool is_masked = false;  // a mask hides part of it
  bool is_shape = false;   // a path, a basic shape or a <use>; else text, an image or a foreign object
  bool is_text = false;
  bool shows_picture = false;  // an image or a foreign object that is seen; of a <use>: in what it shows, too
};

struct SvgLeaves {
  std::string text;           // the SVG with an id for each leaf, its entities put in, and its masks taken off
  std::vector<SvgLeaf> list;  // in the order of the file
  bool says_px = false;       // width or height is in px by name
  std::string program;        // what the file says of who wrote it, "Inkscape 0.48.4"; empty: nothing that is known
};

/// The leaves of an unpacked SVG. Throws InputError, naming `path`, where they are no SVG, or have too many leaves
/// (svg_outlines.h).
SvgLeaves svg_leaves(std::span<const std::uint8_t> bytes, const std::string& path);

}  // namespace tessera
