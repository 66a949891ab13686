// Owners of libxml2's objects for parsing foreign XML, and a handler that keeps other files out.
#pragma once

#include <libxml/parser.h>
#include <libxml/tree.h>

#include <cstdint>
#include <memory>
#include <span>

namespace tessera {

struct FreeXml {
  void operator()(xmlDoc* doc) const { xmlFreeDoc(doc); }
  void operator()(xmlChar* text) const { xmlFree(text); }
  /// Frees the context and its document; a new owner of the document sets `myDoc` to null.
  void operator()(xmlParserCtxt* context) const {
    if (context->myDoc) xmlFreeDoc(context->myDoc);
    xmlFreeParserCtxt(context);
  }
};
using XmlDocPtr = std::unique_ptr<xmlDoc, FreeXml>;
using XmlContextPtr = std::unique_ptr<xmlParserCtxt, FreeXml>;

/// Throws std::bad_alloc.
XmlContextPtr new_xml_context();

/// The document in `bytes`, null where it is damaged. `options` are XML_PARSE_... without XML_PARSE_HUGE. Works like
/// xmlCtxtReadMemory, but accepts a document of more than 10 MB that ends right after a long tag. Throws
/// std::bad_alloc.
XmlDocPtr read_xml(xmlParserCtxt& context, std::span<const std::uint8_t> bytes, int options);

/// A handler for xmlSAXHandler::entityDecl. Entities that would be read from other files stay undeclared; using one is
/// then an error like any other.
void declare_internal_entity(void* context, const xmlChar* name, int type, const xmlChar* public_id,
                             const xmlChar* system_id, xmlChar* content);

}  // namespace tessera
