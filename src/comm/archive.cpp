#include "comm/archive.h"

#include <boost/archive/impl/archive_serializer_map.ipp>
#include <boost/archive/impl/basic_binary_iarchive.ipp>
#include <boost/archive/impl/basic_binary_iprimitive.ipp>
#include <boost/archive/impl/basic_binary_oarchive.ipp>
#include <boost/archive/impl/basic_binary_oprimitive.ipp>

#include "core/base/error.h"

// Boost's library holds this code only for its own archives. For ours it must be compiled here.
namespace boost::archive {
template class detail::archive_serializer_map<tessera::comm::MessageReader>;
template class detail::archive_serializer_map<tessera::comm::MessageWriter>;
template class basic_binary_iarchive<tessera::comm::MessageReader>;
template class basic_binary_oarchive<tessera::comm::MessageWriter>;
template class basic_binary_iprimitive<tessera::comm::MessageReader, char, std::char_traits<char>>;
template class basic_binary_oprimitive<tessera::comm::MessageWriter, char, std::char_traits<char>>;
template class binary_iarchive_impl<tessera::comm::MessageReader, char, std::char_traits<char>>;
template class binary_oarchive_impl<tessera::comm::MessageWriter, char, std::char_traits<char>>;
}  // namespace boost::archive

namespace tessera::comm {

void refuse_message() {
  throw EnvironmentError(
      "a message from another rank is damaged, or another program sent it; allowed: the same program on all ranks; "
      "install it anew on every node");
}

}  // namespace tessera::comm
