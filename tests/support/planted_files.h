// Obstacles that other users may create under a name in a shared folder before the program writes there.
#pragma once

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "scratch_folder.h"

namespace tessera::test {

enum class Plant { link, link_to_nothing, hard_link, pipe, socket, file };

inline constexpr Plant kPlants[] = {Plant::link, Plant::link_to_nothing, Plant::hard_link,
                                    Plant::pipe, Plant::socket,          Plant::file};

/// A file of the user that no writer may change, and obstacles under other names: links to that file, pipes, sockets.
class PlantedFiles {
 public:
  PlantedFiles() { elsewhere_.write("precious", kContent); }

  void put(Plant plant, const std::string& path) const {
    const std::string precious = elsewhere_.path("precious");
    if (plant == Plant::link) std::filesystem::create_symlink(precious, path);
    if (plant == Plant::link_to_nothing) std::filesystem::create_symlink(elsewhere_.path("new"), path);
    if (plant == Plant::hard_link) std::filesystem::create_hard_link(precious, path);
    if (plant == Plant::pipe) put_pipe(path);
    if (plant == Plant::socket) put_socket(path);
    if (plant == Plant::file) std::ofstream(path) << "longer than anything that is written here afterwards";
  }

  void expect_untouched() const {
    EXPECT_EQ(content_of(elsewhere_.path("precious")), kContent);
    EXPECT_FALSE(std::filesystem::exists(elsewhere_.path("new")));
  }

 private:
  static constexpr const char* kContent = "precious";

  static std::string content_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  static void put_pipe(const std::string& path) { ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0); }

  static void put_socket(const std::string& path) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    ASSERT_LT(path.size(), sizeof address.sun_path);
    path.copy(address.sun_path, path.size());
    const int listener = ::socket(AF_UNIX, SOCK_STREAM, 0);
    ASSERT_EQ(::bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    ::close(listener);
  }

  ScratchFolder elsewhere_;
};

}  // namespace tessera::test
