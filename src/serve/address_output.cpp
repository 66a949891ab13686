#include "serve/address_output.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "core/base/error.h"
#include "files/file_descriptor.h"
#include "result/folder/result_file.h"
#include "terminal/terminal.h"

namespace tessera::serve {
namespace {

constexpr const char* kName = "serve_address.txt";

bool is_private_output() {
  if (::isatty(STDOUT_FILENO)) return true;
  struct stat status = {};
  return ::fstat(STDOUT_FILENO, &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == ::geteuid() &&
         (status.st_mode & (S_IRWXG | S_IRWXO)) == 0;
}

[[noreturn]] void fail(const std::string& path) {
  throw EnvironmentError(path + ": " + std::generic_category().message(errno) +
                         "; the address of the page must stand in a file that only you can read, because stdout is no "
                         "terminal");
}

void write_privately(const std::string& path, const std::string& text) {
  ::unlink(path.c_str());  // of a server that was killed
  const FileDescriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600));
  if (!file.is_open()) fail(path);
  if (::write(file.number(), text.data(), text.size()) != ssize_t(text.size())) fail(path);
}

}  // namespace

AddressOutput::AddressOutput(const std::string& folder, const std::string& address) {
  if (is_private_output()) {
    print_line("open in a browser on this machine:");
    print_line("  %s", address.c_str());
    return;
  }
  file_ = path_in_result(folder, kName);
  write_privately(file_, address + "\n");
  print_line("the address for a browser on this machine stands in %s, which only you can read", file_.c_str());
}

AddressOutput::~AddressOutput() {
  if (!file_.empty()) ::unlink(file_.c_str());
}

}  // namespace tessera::serve
