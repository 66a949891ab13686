// Data in a page: nothing of it can end its element.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "report/page.h"
#include "report/page_template.h"

namespace tessera {
namespace test_page {

std::string html_of(const Page& page) {
  std::string html;
  write_page(page, [&](std::string_view part) { html += part; });
  return html;
}

/// The text of the element that begins with `opening`.
std::string content(const std::string& html, const std::string& opening, const std::string& closing) {
  const std::size_t begin = html.find(opening);
  if (begin == html.npos) return "no such element";
  const std::size_t from = begin + opening.size();
  return html.substr(from, html.find(closing, from) - from);
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) ++found;
  return found;
}

TEST(Page, hostile_names_stay_data) {
  const std::string name = "</script><script>alert(1)</script><!-- \" & '";
  const nlohmann::json data = {{"name", name}};
  const std::string html = html_of({.title = name, .json = data.dump(), .blocks = {}, .warnings = {}});
  const std::string empty = html_of({.title = "", .json = "{}", .blocks = {}, .warnings = {}});
  EXPECT_EQ(count(html, "<script"), count(empty, "<script")) << "an element more";
  EXPECT_EQ(count(html, "<!--"), count(empty, "<!--"));
  const std::string text = content(html, "<script type=\"application/json\" id=\"data\">", "</script>");
  EXPECT_EQ(nlohmann::json::parse(text), data);
  EXPECT_EQ(content(html, "<title>", "</title>"), "&lt;/script>&lt;script>alert(1)&lt;/script>&lt;!-- \" &amp; '");
}

TEST(Page, blocks_are_base64) {
  const Page page{
      .title = "t", .json = "{}", .blocks = {{"outlines", {0, 255, 16}}, {"tile-0-0-0-0", {}}}, .warnings = {}};
  const std::string html = html_of(page);
  EXPECT_EQ(content(html, "<script type=\"text/plain\" id=\"outlines\">", "</script>"), "AP8Q");
  EXPECT_EQ(content(html, "<script type=\"text/plain\" id=\"tile-0-0-0-0\">", "</script>"), "");
  EXPECT_EQ(nlohmann::json::parse(page_json(page)),
            nlohmann::json::parse(R"({"data": {}, "blocks": {"outlines": "AP8Q", "tile-0-0-0-0": ""}})"));
}

TEST(Page, the_template_lets_nothing_from_outside_in) {
  const std::string text(page_template());
  for (const char* rule : {"default-src 'none'", "script-src 'sha256-", "style-src 'sha256-", "base-uri 'none'",
                           "form-action 'none'", "img-src data: blob:"}) {
    EXPECT_NE(text.find(rule), text.npos) << rule;
  }
  EXPECT_EQ(text.find("unsafe"), text.npos);
  EXPECT_EQ(count(text, "src=\"http"), 0u);
}

}  // namespace test_page
}  // namespace tessera
