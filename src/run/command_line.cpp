#include "run/command_line.h"

#include <fstream>

#include "terminal/shell_word.h"

namespace tessera {
std::string quoted_command(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + shell_word(word);
  return text;
}

std::string own_command_line() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  std::vector<std::string> words;
  for (std::string word; std::getline(file, word, '\0');) words.push_back(word);
  return quoted_command(words);
}

}  // namespace tessera
