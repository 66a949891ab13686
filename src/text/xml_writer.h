// XML text through libxml2's writer: escaping and nesting are its business.
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
  /// Adds XML that is well-formed already.
  XmlWriter& raw(const std::string& xml);
  XmlWriter& end();

  /// What was written so far, with all elements closed.
  std::string finish();

 private:
  struct Free {
    void operator()(xmlBuffer* b) const { xmlBufferFree(b); }
    void operator()(xmlTextWriter* w) const { xmlFreeTextWriter(w); }
  };
  std::unique_ptr<xmlBuffer, Free> buffer_;
  std::unique_ptr<xmlTextWriter, Free> writer_;  // refers to the buffer, so it goes first
};

}  // namespace tessera
