#include "report/page.h"

#include <glib.h>

#include <memory>

#include "core/base/error.h"
#include "report/page_template.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

constexpr std::string_view kTitlePlace = "<!--TESSERA-TITLE-->";
constexpr std::string_view kDataPlace = "<!--TESSERA-DATA-->";

struct FreeText {
  void operator()(gchar* text) const { g_free(text); }
};

std::string base64(const std::vector<std::uint8_t>& bytes) {
  const std::unique_ptr<gchar, FreeText> text(g_base64_encode(bytes.data(), bytes.size()));
  return text.get();
}

/// JSON for a script element. "<" begins both "</script>" and "<!--"; JSON has it only in texts.
std::string for_script(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

std::string html_text(const std::string& text) {
  std::string html;
  for (const char c : printable_utf8(text)) {
    if (c == '<') {
      html += "&lt;";
    } else if (c == '&') {
      html += "&amp;";
    } else {
      html += c;
    }
  }
  return html;
}

/// The template's parts before, between and after its two places.
struct TemplateParts {
  std::string_view head, middle, tail;
};

TemplateParts template_parts() {
  const std::string_view all = page_template();
  const std::size_t title = all.find(kTitlePlace), data = all.find(kDataPlace);
  if (title == all.npos || data == all.npos || data < title) {
    throw EnvironmentError(
        "this program was built with a damaged page template; build it again from a whole web/dist/");
  }
  const std::size_t after_title = title + kTitlePlace.size();
  return {all.substr(0, title), all.substr(after_title, data - after_title), all.substr(data + kDataPlace.size())};
}

}  // namespace

void write_page(const Page& page, const std::function<void(std::string_view)>& write) {
  const TemplateParts parts = template_parts();
  write(parts.head);
  write(html_text(page.title));
  write(parts.middle);
  write("<script type=\"application/json\" id=\"data\">");
  write(for_script(page.json));
  write("</script>\n");
  for (const PageBlock& block : page.blocks) {
    write("<script type=\"text/plain\" id=\"" + block.name + "\">");
    write(base64(block.bytes));
    write("</script>\n");
  }
  write(parts.tail);
}

std::string page_json(const Page& page) {
  std::string text = "{\"data\":" + page.json + ",\"blocks\":{";
  bool first = true;
  for (const PageBlock& block : page.blocks) {
    text += (first ? "\"" : ",\"") + block.name + "\":\"";
    text += base64(block.bytes);
    text += '"';
    first = false;
  }
  return text + "}}";
}

}  // namespace tessera
