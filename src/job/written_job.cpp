#include "job/written_job.h"

#include <charconv>
#include <cstddef>
#include <span>

#include "core/base/digest.h"

namespace tessera {
namespace {

/// The beginning of the last line, which continues with the digest of all lines before it.
std::string mark_of(const std::string& author) { return "# As " + author + " wrote it: "; }

std::string last_line(const std::string& text, const std::string& author) {
  Digest digest;
  digest.add_all(std::span<const char>(text));
  char number[20];
  return mark_of(author) + std::string(number, std::to_chars(number, number + sizeof number, digest.value(), 16).ptr) +
         "\n";
}

}  // namespace

std::string with_written_mark(const std::string& text, const std::string& author) {
  return text + last_line(text, author);
}

bool has_written_mark(const std::string& text, const std::string& author) {
  return text.find(mark_of(author)) != std::string::npos;
}

bool is_as_written(const std::string& text, const std::string& author) {
  const std::size_t last = text.rfind(mark_of(author));
  return last != std::string::npos && last_line(text.substr(0, last), author) == text.substr(last);
}

}  // namespace tessera
