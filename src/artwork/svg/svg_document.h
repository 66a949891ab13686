// An SVG that librsvg has parsed and that can be drawn with cairo.
#pragma once

#include <cairo.h>
#include <librsvg/rsvg.h>

#include <cstdint>
#include <memory>
#include <opencv2/core.hpp>
#include <span>
#include <string>

#include "artwork/svg/svg_page.h"

namespace tessera {

struct Unref {
  void operator()(void* object) const { g_object_unref(object); }
};
template <class T>
using GObjectPtr = std::unique_ptr<T, Unref>;

class SvgDocument {
 public:
  /// Parses the SVG from memory, without a base address (svg_page.h). Throws InputError where it is no SVG or has no
  /// area.
  SvgDocument(std::span<const std::uint8_t> svg, const std::string& path, RsvgHandleFlags flags,
              double px_per_inch = kCssPxPerInch);

  /// The page's size in px.
  cv::Size2d size() const { return size_; }
  /// Whether the file states the page's size; if not, the page is as large as its drawing.
  bool has_size() const { return sized_; }
  /// Whether its width or height has a unit of length other than px.
  bool says_unit() const;
  /// Whether the drawing's size depends on the size of a px.
  bool depends_on_px() const;
  /// Whether text is not drawn, as this machine has no font.
  bool loses_text() const { return loses_text_; }
  /// Sets a style sheet that overrides the document's own, except for declarations with "!important" there.
  void set_style(const std::string& css);
  /// Whether the element, with its content, covers any area.
  bool draws_element(const std::string& id) const;
  /// Draws the page at (0, 0), `scale` times as large. Throws InputError where librsvg cannot.
  void draw(cairo_t* cairo, double scale) const;
  /// Draws one element with its content, as if the page had the size `page`. Throws InputError where librsvg cannot.
  void draw_element(cairo_t* cairo, const std::string& id, const cv::Size2d& page) const;

 private:
  std::string path_;
  GObjectPtr<RsvgHandle> handle_;
  bool sized_ = false;  // stated in the file
  bool loses_text_ = false;
  cv::Size2d size_;
};

}  // namespace tessera
