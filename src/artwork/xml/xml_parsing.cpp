#include "artwork/xml/xml_parsing.h"

#include <libxml/SAX2.h>

#include <new>
#include <string>
#include <string_view>

#include "text/libxml_state.h"

namespace tessera {

namespace {

/// The text with comments at its end. About 250 bytes before the end, libxml2 counts the text that it still keeps, and
/// refuses 10 MB. At comments about 500 bytes before the end it frees what it has read.
std::string with_comments(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view kComment = "<!---->";
  constexpr std::size_t kComments = 200;
  std::string text;
  text.reserve(bytes.size() + kComments * kComment.size());
  text.assign(bytes.begin(), bytes.end());
  if (text.ends_with('\0') || text.ends_with(std::string_view("\0>", 2))) return text;  // UTF-16
  for (std::size_t i = 0; i < kComments; ++i) text += kComment;
  return text;
}

}  // namespace

XmlContextPtr new_xml_context() {
  make_libxml_state();
  XmlContextPtr context(xmlNewParserCtxt());
  if (!context) throw std::bad_alloc();
  return context;
}

XmlDocPtr read_xml(xmlParserCtxt& context, std::span<const std::uint8_t> bytes, int options) {
  constexpr std::size_t kKept = 9'000'000;
  const std::string longer = bytes.size() > kKept ? with_comments(bytes) : "";
  const char* const text = longer.empty() ? reinterpret_cast<const char*>(bytes.data()) : longer.data();
  const std::size_t size = longer.empty() ? bytes.size() : longer.size();
  XmlDocPtr doc(xmlCtxtReadMemory(&context, text, int(size), nullptr, nullptr, options));
  context.myDoc = nullptr;
  return doc;
}

void declare_internal_entity(void* context, const xmlChar* name, int type, const xmlChar* public_id,
                             const xmlChar* system_id, xmlChar* content) {
  if (type != XML_INTERNAL_GENERAL_ENTITY && type != XML_INTERNAL_PARAMETER_ENTITY) return;
  xmlSAX2EntityDecl(context, name, type, public_id, system_id, content);
}

}  // namespace tessera
