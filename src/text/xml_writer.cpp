#include "text/xml_writer.h"

#include <new>

#include "text/libxml_state.h"

namespace tessera {
namespace {

const xmlChar* xml(const std::string& text) { return reinterpret_cast<const xmlChar*>(text.c_str()); }

/// Throws where libxml2 reports a failure: writing into memory fails only for lack of memory.
void check(int result) {
  if (result < 0) throw std::bad_alloc();
}

}  // namespace

XmlWriter::XmlWriter() {
  make_libxml_state();
  buffer_.reset(xmlBufferCreate());
  if (!buffer_) throw std::bad_alloc();
  xmlBufferSetAllocationScheme(buffer_.get(), XML_BUFFER_ALLOC_DOUBLEIT);
  writer_.reset(xmlNewTextWriterMemory(buffer_.get(), 0));
  if (!writer_) throw std::bad_alloc();
}

XmlWriter& XmlWriter::start(const std::string& element) {
  check(xmlTextWriterStartElement(writer_.get(), xml(element)));
  return *this;
}

XmlWriter& XmlWriter::attribute(const std::string& name, const std::string& value) {
  check(xmlTextWriterWriteAttribute(writer_.get(), xml(name), xml(value)));
  return *this;
}

XmlWriter& XmlWriter::text(const std::string& text) {
  check(xmlTextWriterWriteString(writer_.get(), xml(text)));
  return *this;
}

XmlWriter& XmlWriter::raw(const std::string& text) {
  check(xmlTextWriterWriteRaw(writer_.get(), xml(text)));
  return *this;
}

XmlWriter& XmlWriter::end() {
  check(xmlTextWriterEndElement(writer_.get()));
  return *this;
}

std::string XmlWriter::finish() {
  check(xmlTextWriterEndDocument(writer_.get()));
  check(xmlTextWriterFlush(writer_.get()));
  return {reinterpret_cast<const char*>(xmlBufferContent(buffer_.get())), std::size_t(xmlBufferLength(buffer_.get()))};
}

}  // namespace tessera
