#include "products/nesting/drawings/svg_tree.h"

#include <libxml/SAX2.h>
#include <libxml/parser.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <vector>

#include "artwork/svg/xml_tree.h"
#include "core/base/error.h"
#include "core/base/too_many.h"
#include "files/gunzip.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

using namespace svg_limits;

/// What one document has had so far, while libxml2 reads it.
struct Counts {
  std::size_t elements = 0;
  std::size_t attributes = 0;
  std::size_t declarations = 0;
  std::string fault;  // what was found and is allowed; libxml2 knows nothing of exceptions

  /// False where there are too many.
  bool check(const char* what, std::size_t count, std::size_t allowed) {
    if (count > allowed && fault.empty())
      fault = "found " + std::to_string(count) + " " + what + ", allowed: " + std::to_string(allowed);
    return fault.empty();
  }
};

xmlParserCtxt* context_of(void* context) { return static_cast<xmlParserCtxt*>(context); }
Counts& counts_of(void* context) { return *static_cast<Counts*>(context_of(context)->_private); }

void stop_at_fault(void* context) {
  if (!counts_of(context).fault.empty()) xmlStopParser(context_of(context));
}

/// In these encodings '<' and '=' are the bytes that check_tags looks for.
bool extends_ascii(std::string_view encoding) {
  constexpr std::array<std::string_view, 13> kBegins = {"utf-8",    "utf8",      "us-ascii",    "ascii", "iso-8859-",
                                                        "iso8859-", "latin",     "windows-125", "cp125", "koi8-",
                                                        "euc-",     "shift_jis", "gb"};
  std::string word(encoding);
  std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return std::any_of(kBegins.begin(), kBegins.end(), [&](std::string_view begin) { return word.starts_with(begin); });
}

void start_document(void* context) {
  const xmlParserCtxt* const parser = context_of(context);
  const xmlChar* const name = parser->input && parser->input->encoding ? parser->input->encoding : parser->encoding;
  const std::string encoding(name ? view(name) : "utf-8");
  if (!extends_ascii(encoding))
    counts_of(context).fault = "found the encoding " + printable_utf8(encoding.substr(0, 20)) + ", allowed: UTF-8";
  stop_at_fault(context);
  xmlSAX2StartDocument(context);
}

void start_element(void* context, const xmlChar* name, const xmlChar* prefix, const xmlChar* uri, int name_spaces,
                   const xmlChar** name_space_list, int attributes, int defaulted, const xmlChar** attribute_list) {
  Counts& counts = counts_of(context);
  counts.attributes += std::size_t(name_spaces) + std::size_t(attributes);
  const bool right =
      counts.check("elements", ++counts.elements, kElements) &&
      counts.check("attributes", counts.attributes, kAttributes) &&
      counts.check("levels of elements in each other", std::size_t(context_of(context)->nameNr) + 1, kLevels) &&
      counts.check("name spaces at one place", std::size_t(context_of(context)->nsNr) / 2, kNameSpaces);
  if (!right) return xmlStopParser(context_of(context));
  xmlSAX2StartElementNs(context, name, prefix, uri, name_spaces, name_space_list, attributes, defaulted,
                        attribute_list);
}

bool count_declaration(void* context) {
  Counts& counts = counts_of(context);
  const bool right = counts.check("declarations", ++counts.declarations, kDeclarations);
  if (!right) xmlStopParser(context_of(context));
  return right;
}

void declare_entity(void* context, const xmlChar* name, int type, const xmlChar* public_id, const xmlChar* system_id,
                    xmlChar* content) {
  if (count_declaration(context)) declare_internal_entity(context, name, type, public_id, system_id, content);
}

void declare_attribute(void* context, const xmlChar*, const xmlChar*, int, int, const xmlChar*,
                       xmlEnumeration* values) {
  xmlFreeEnumeration(values);
  count_declaration(context);
}

/// Only what has to do with elements and their attributes.
xmlSAXHandler handlers(const xmlSAXHandler& of_libxml) {
  xmlSAXHandler sax = of_libxml;
  sax.startDocument = start_document;
  sax.startElementNs = start_element;
  sax.entityDecl = declare_entity;
  sax.attributeDecl = declare_attribute;
  sax.elementDecl = nullptr;
  sax.notationDecl = nullptr;
  sax.unparsedEntityDecl = nullptr;
  sax.characters = sax.ignorableWhitespace = sax.cdataBlock = nullptr;
  sax.comment = nullptr;
  sax.processingInstruction = nullptr;
  sax.reference = nullptr;
  return sax;
}

/// Before libxml2 sees it: what it would read as one piece, and what it would compare with each other. Between two '<'
/// lies at most one tag.
void check_tags(std::span<const std::uint8_t> bytes, const std::string& path) {
  if (std::find(bytes.begin(), bytes.end(), 0) != bytes.end())
    throw InputError(path + ": not a readable SVG file: found a byte of 0, as UTF-16 has them; allowed: UTF-8");
  std::size_t length = 0, attributes = 0;
  for (const std::uint8_t byte : bytes) {
    if (byte == '<') length = attributes = 0;
    attributes += byte == '=' ? 1 : 0;
    if (++length > kTagBytes) throw InputError(path + ": " + too_many(kTagBytes, "bytes in one tag or text"));
    if (attributes > kAttributesOfElement)
      throw InputError(path + ": " + too_many(kAttributesOfElement, "attributes of one element"));
  }
}

/// What libxml2 does not like, and where; nothing where it does not say.
std::string damage(const xmlParserCtxt& parser) {
  if (!parser.lastError.message) return "";
  std::string text = parser.lastError.message;
  while (text.ends_with('\n') || text.ends_with(' ')) text.pop_back();
  return ": line " + std::to_string(parser.lastError.line) + ": " + cut_utf8(printable_utf8(text), 200);
}

SvgTree parsed(std::span<const std::uint8_t> bytes, const std::string& path) {
  check_tags(bytes, path);
  const XmlContextPtr context = new_xml_context();
  Counts counts;
  context->_private = &counts;
  *context->sax = handlers(*context->sax);
  constexpr int kOptions = XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING;
  SvgTree tree = read_xml(*context, bytes, kOptions);
  if (!counts.fault.empty()) throw InputError(path + ": " + counts.fault);
  const xmlNode* const root = tree ? xmlDocGetRootElement(tree.get()) : nullptr;
  if (!root) throw InputError(path + ": not a readable SVG file" + damage(*context));
  if (name_of(root) != "svg")
    throw InputError(path + ": not an SVG file: its root element is " +
                     printable_utf8(cut_utf8(std::string(name_of(root)), 40)));
  return tree;
}

}  // namespace

SvgTree svg_tree(std::span<const std::uint8_t> bytes, const std::string& path) {
  return is_gzip(bytes) ? parsed(gunzip(bytes, path, kBytes), path) : parsed(bytes, path);
}

}  // namespace tessera
