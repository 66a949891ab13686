// Harmful SVGs: too large, too deep, endless, or with references to themselves and to other files.
#pragma once

#include <string>
#include <vector>

namespace tessera::test {

struct OddSvg {
  std::string name;
  std::string text;
};

class OddSvgs {
 public:
  /// About 50 kinds of SVG, each in `variants` strengths.
  static std::vector<OddSvg> make(int variants) {
    OddSvgs made;
    for (int v = 0; v < variants; ++v) {
      made.suffix_ = "_" + std::to_string(v);
      const double scale = 1 << v;
      made.add_filters(scale);
      made.add_deep(scale);
      made.add_references(scale);
      made.add_strokes_and_texts(scale);
      made.add_pages(scale);
      made.add_documents(scale);
    }
    return std::move(made.all_);
  }

  static std::string document(const std::string& body, const std::string& size = "width=\"400\" height=\"400\"",
                              const std::string& before = "") {
    return before + "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" " + size +
           " viewBox=\"0 0 400 400\">" + body + "</svg>";
  }

 private:
  static inline const std::string kDisc = "<circle cx=\"200\" cy=\"200\" r=\"150\" fill=\"red\"/>";

  static std::string number(double value) { return std::to_string(static_cast<long long>(value)); }

  static std::string repeated(const std::string& text, double count) {
    std::string result;
    for (int i = 0; i < int(count); ++i) result += text;
    return result;
  }

  void add(const std::string& name, const std::string& body) { all_.push_back({name + suffix_, document(body)}); }

  void add_filter(const std::string& name, const std::string& primitives, const std::string& region = "") {
    add(name, "<filter id=\"f\" " + region + ">" + primitives +
                  "</filter><circle cx=\"200\" cy=\"200\" r=\"150\" fill=\"red\" filter=\"url(#f)\"/>");
  }

  void add_filters(double scale) {
    for (const double order : {7., 30., 100.}) {
      const double n = order * scale;
      add_filter("convolve" + number(order),
                 "<feConvolveMatrix order=\"" + number(n) + "\" kernelMatrix=\"" + repeated("1 ", n * n) + "\"/>");
    }
    add_filter("convolve_wrong_size", "<feConvolveMatrix order=\"" + number(3 + scale) + "\" kernelMatrix=\"1 1 1\"/>");
    const std::string nine = "kernelMatrix=\"1 1 1 1 1 1 1 1 1\"";
    add_filter("convolve_zero_divisor", "<feConvolveMatrix order=\"3\" divisor=\"0\" targetX=\"" + number(99 * scale) +
                                            "\" targetY=\"-5\" " + nine + " kernelUnitLength=\"1e-9\"/>");
    add_filter("convolve_tiny_unit", "<feConvolveMatrix order=\"3\" " + nine + " kernelUnitLength=\"0.00001\"/>");
    add_filter("convolve_huge_unit", "<feConvolveMatrix order=\"3\" " + nine + " kernelUnitLength=\"1e9\"/>");
    add_filter("light", "<feDiffuseLighting kernelUnitLength=\"0.00001\" surfaceScale=\"" + number(1e9 * scale) +
                            "\"><fePointLight x=\"1\" y=\"1\" z=\"1\"/></feDiffuseLighting>");
    add_filter("dilate", "<feMorphology operator=\"dilate\" radius=\"" + number(50 * scale) + "\"/>");
    add_filter("dilate_huge", "<feMorphology operator=\"dilate\" radius=\"100000\"/>");
    add_filter("blur_huge", "<feGaussianBlur stdDeviation=\"1e30\"/>",
               "x=\"-1e6\" y=\"-1e6\" width=\"3e6\" height=\"3e6\"");
    add_filter("region_huge", "<feFlood flood-color=\"blue\"/>", "x=\"-1e9\" y=\"-1e9\" width=\"3e9\" height=\"3e9\"");
    add_filter("turbulence_octaves",
               "<feTurbulence baseFrequency=\"0.9\" numOctaves=\"" + number(1e4 * scale) + "\"/>");
    add_filter("turbulence_fast", "<feTurbulence baseFrequency=\"1e9\" numOctaves=\"2000000000\"/>");
    add_filter("blur_chain", repeated("<feGaussianBlur stdDeviation=\"50\"/>", 2000 * scale));
    add_filter("tile", "<feTile/><feOffset dx=\"1e30\"/><feDisplacementMap in2=\"SourceGraphic\" scale=\"1e30\"/>");
    add_filter("merge", "<feMerge>" + repeated("<feMergeNode in=\"SourceGraphic\"/>", 5000 * scale) + "</feMerge>");
  }

  void add_deep(double scale) {
    add("layers", repeated("<g opacity=\"0.99\">", 100 * scale) + kDisc + repeated("</g>", 100 * scale));
    add("deep", repeated("<g>", 10000 * scale) + kDisc + repeated("</g>", 10000 * scale));
    add("filters_nested", "<filter id=\"f\"><feGaussianBlur stdDeviation=\"30\"/></filter>" +
                              repeated("<g filter=\"url(#f)\">", 50 * scale) + kDisc + repeated("</g>", 50 * scale));
    add("blend_layers",
        repeated("<g style=\"mix-blend-mode:multiply\">", 100 * scale) + kDisc + repeated("</g>", 100 * scale));
    add("many_elements", repeated("<rect width=\"9\" height=\"9\"/>", 50000 * scale) + kDisc);
  }

  /// `count` parts: NAME0 refers to NAME1, and so on.
  static std::string chain(const std::string& before, const std::string& between, const std::string& after, int count) {
    std::string result;
    for (int i = 0; i < count; ++i) result += before + std::to_string(i) + between + std::to_string(i + 1) + after;
    return result;
  }

  void add_references(double scale) {
    const std::string whole = "<rect width=\"400\" height=\"400\" ";
    std::string doubled = "<circle id=\"a0\" r=\"9\"/>";
    for (int i = 0; i < 20; ++i) {
      const std::string use = "<use xlink:href=\"#a" + std::to_string(i) + "\"/>";
      doubled += "<g id=\"a" + std::to_string(i + 1) + "\">" + use + use + "</g>";
    }
    add("use_doubled", doubled + "<use xlink:href=\"#a20\"/>");
    add("use_itself", "<g id=\"a\"><use xlink:href=\"#a\"/>" + kDisc + "</g>");
    add("pattern_itself", "<pattern id=\"p\" width=\"1\" height=\"1\" patternUnits=\"userSpaceOnUse\">" + whole +
                              "fill=\"url(#p)\"/></pattern>" + whole + "fill=\"url(#p)\"/>");
    add("pattern_tiny", "<pattern id=\"p\" width=\"1e-7\" height=\"1e-7\" patternUnits=\"userSpaceOnUse\">" + whole +
                            "fill=\"red\"/></pattern><circle cx=\"200\" cy=\"200\" r=\"150\" fill=\"url(#p)\"/>");
    add("pattern_chain", chain("<pattern width=\"1\" height=\"1\" patternUnits=\"userSpaceOnUse\" id=\"p",
                               "\">" + whole + "fill=\"url(#p", ")\"/></pattern>", int(15 * scale)) +
                             "<circle cx=\"200\" cy=\"200\" r=\"150\" fill=\"url(#p0)\"/>");
    add("mask_chain",
        chain("<mask id=\"m", "\">" + whole + "fill=\"white\" mask=\"url(#m", ")\"/></mask>", int(50 * scale)) +
            "<circle cx=\"200\" cy=\"200\" r=\"150\" fill=\"red\" mask=\"url(#m0)\"/>");
    add("clip_chain",
        chain("<clipPath id=\"c", "\">" + whole + "clip-path=\"url(#c", ")\"/></clipPath>", int(50 * scale)) +
            "<circle cx=\"200\" cy=\"200\" r=\"150\" fill=\"red\" clip-path=\"url(#c0)\"/>");
    add("markers",
        "<marker id=\"m\" markerWidth=\"300\" markerHeight=\"300\"><g opacity=\"0.5\"><circle r=\"100\"/></g>"
        "</marker><path fill=\"none\" stroke=\"red\" marker-mid=\"url(#m)\" d=\"M0 0" +
            zigzag(5000 * scale) + "\"/>" + kDisc);
    add("image_of_a_file", "<image width=\"400\" height=\"400\" xlink:href=\"file:///etc/hostname\"/>");
    add("style_of_a_file", "<style>@import url(\"file:///etc/passwd\");</style>" + kDisc);
    add("image_of_itself", "<image id=\"i\" width=\"400\" height=\"400\" xlink:href=\"#i\"/>");
    add("bad_image", "<image width=\"400\" height=\"400\" xlink:href=\"data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAA" +
                         repeated("/", 1000 * scale) + "\"/>" + kDisc);
  }

  static std::string zigzag(double points) {
    std::string path;
    for (int i = 0; i < int(points); ++i) {
      path += "L" + std::to_string(i * 7919LL % 400) + " " + std::to_string(i * 104729LL % 400);
    }
    return path;
  }

  void add_strokes_and_texts(double scale) {
    const std::string stroke = "stroke=\"red\" fill=\"none\" ";
    add("dashes", "<path d=\"M0 200 H400 V0 H0 V400 H400\" stroke-width=\"50\" " + stroke +
                      "stroke-dasharray=\"0.000001 0.000001\"/>");
    add("long_dashes", "<path d=\"M-1e" + number(4 + scale) + " 200 H1e7\" stroke-width=\"50\" " + stroke +
                           "stroke-dasharray=\"0.01\"/>");
    add("path", "<path fill=\"red\" d=\"M0 0" + zigzag(50000 * scale) + "Z\"/>");
    add("wide_stroke",
        "<path stroke-linejoin=\"round\" stroke-width=\"300\" " + stroke + "d=\"M0 0" + zigzag(5000 * scale) + "Z\"/>");
    add("huge_coordinates", "<path fill=\"red\" d=\"M-1e38 -1e38L1e38 1e38L1e300 0Zm1e999 nan\"/>");
    add("huge_font",
        "<text x=\"0\" y=\"300\" font-size=\"1e" + number(4 + scale) + "\" fill=\"red\">AWXM</text>" + kDisc);
    add("long_text",
        "<text x=\"0\" y=\"300\" font-size=\"100\" fill=\"red\">" + repeated("A", 50000 * scale) + "</text>" + kDisc);
    add("transform", "<g transform=\"scale(1e30) rotate(1e30) skewX(90) matrix(0 0 0 0 0 0)\">" + kDisc + "</g>");
  }

  void add_page(const std::string& name, const std::string& size) {
    all_.push_back({name + suffix_, document(kDisc, size)});
  }

  void add_pages(double scale) {
    add_page("page_huge", "width=\"1e9\" height=\"" + number(1e8 * scale) + "\"");
    add_page("page_thin", "width=\"1e9\" height=\"1\"");
    add_page("page_nan", "width=\"nan\" height=\"inf\"");
    add_page("page_negative", "width=\"-5\" height=\"-" + number(scale) + "\"");
    add_page("page_units", "width=\"1e30em\" height=\"1e-30%\"");
  }

  void add_document(const std::string& name, const std::string& entities, const std::string& body) {
    all_.push_back(
        {name + suffix_, document(body, "width=\"400\" height=\"400\"", "<!DOCTYPE svg [" + entities + "]>")});
  }

  void add_documents(double scale) {
    std::string laughs = "<!ENTITY a0 \"lololololol\">";
    for (int i = 0; i < 12; ++i) {
      laughs += "<!ENTITY a" + std::to_string(i + 1) + " \"" + repeated("&a" + std::to_string(i) + ";", 10) + "\">";
    }
    add_document("laughs", laughs, kDisc + "<text>&a12;</text>");
    add_document("quadratic", "<!ENTITY a \"" + std::string(std::size_t(200000 * scale), 'x') + "\">",
                 kDisc + "<desc>" + repeated("&a;", 500) + "</desc>");
    add_document("external", "<!ENTITY a SYSTEM \"file:///etc/passwd\">", kDisc + "<text y=\"50\">&a;</text>");
    add_document("external_parameter", "<!ENTITY % a SYSTEM \"file:///etc/passwd\"> %a;", kDisc);
    const std::string text = document(kDisc);
    all_.push_back({"cut" + suffix_, text.substr(0, text.size() / 2)});
    all_.push_back({"zeros" + suffix_, text + std::string(std::size_t(1000 * scale), '\0')});
    all_.push_back({"no_utf8" + suffix_, document(kDisc + "<desc>\xff\xfe\xc3</desc>")});
  }

  std::vector<OddSvg> all_;
  std::string suffix_;
};

}  // namespace tessera::test
