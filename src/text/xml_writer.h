// Writes XML through the writer of libxml2, which escapes texts and closes elements.
#pragma once

#include <libxml/tree.h>
#include <libxml/xmlwriter.h>

#include <memory>
#include <string>

namespace tessera {

class XmlWriter {
 public:
  XmlWriter();

  XmlWriter& start(const std::string& element);
  XmlWriter& attribute(const std::string& name, const std::string& value);
  XmlWriter& text(const std::string& text);
  /// Adds XML that is already well-formed.
  XmlWriter& raw(const std::string& xml);
  XmlWriter& end();

  /// The XML written so far, with all elements closed.
  std::string finish();

 private:
  struct Free {
    void operator()(xmlBuffer* b) const { xmlBufferFree(b); }
    void operator()(xmlTextWriter* w) const { xmlFreeTextWriter(w); }
  };
  std::unique_ptr<xmlBuffer, Free> buffer_;
  std::unique_ptr<xmlTextWriter, Free> writer_;  // refers to the buffer, so it is destroyed first
};

}  // namespace tessera
