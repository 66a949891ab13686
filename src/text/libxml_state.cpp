#include "text/libxml_state.h"

#include <libxml/parser.h>

#include <mutex>

namespace tessera {

void make_libxml_state() {
  static std::once_flag made;
  std::call_once(made, xmlInitParser);
}

}  // namespace tessera
