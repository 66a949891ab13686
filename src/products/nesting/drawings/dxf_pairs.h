// Reads the pairs of lines of an ASCII DXF: a group code and its value.
#pragma once

#include <string>
#include <string_view>

namespace tessera {

struct DxfPair {
  int code = 0;
  std::string_view value;  // without white space around it
  int line = 0;            // line of the code; the value is in the next one
};

class DxfPairs {
 public:
  /// `path`: for messages. Both outlive it. Throws InputError where the file is a binary DXF or a DWG.
  DxfPairs(std::string_view text, const std::string& path);

  /// False at the end of the file. Throws InputError that names the line.
  bool next(DxfPair& pair);

  /// The value as a number. Throws InputError where it is none, or beyond +-1e12.
  double number(const DxfPair& pair) const;

  /// Throws InputError.
  [[noreturn]] void fail(int line, const std::string& what) const;

 private:
  bool next_line(std::string_view& line);

  std::string_view rest_;
  const std::string& path_;
  int line_ = 0;
};

}  // namespace tessera
