#include "io/artwork/xml_parsing.h"

#include <libxml/SAX2.h>

#include <new>

namespace tessera::io {

XmlContextPtr new_xml_context() {
  XmlContextPtr context(xmlNewParserCtxt());
  if (!context) throw std::bad_alloc();
  return context;
}

void declare_internal_entity(void* context, const xmlChar* name, int type, const xmlChar* public_id,
                             const xmlChar* system_id, xmlChar* content) {
  if (type != XML_INTERNAL_GENERAL_ENTITY && type != XML_INTERNAL_PARAMETER_ENTITY) return;
  xmlSAX2EntityDecl(context, name, type, public_id, system_id, content);
}

}  // namespace tessera::io
