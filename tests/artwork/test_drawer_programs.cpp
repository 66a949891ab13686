// The drawing program is missing or another one: the messages, and the data that it gets.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "artwork/protocol/drawer_protocol.h"
#include "drawer_samples.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_drawer_programs {

using test::kDisc;
using test::kTwo;
using test::mistake;
using test::svg;

/// While an object of this class lives, another program replaces tessera-drawer.
class OtherProgram {
 public:
  explicit OtherProgram(const std::string& file) { ::setenv("TESSERA_DRAWER", file.c_str(), 1); }
  ~OtherProgram() { ::setenv("TESSERA_DRAWER", place_.c_str(), 1); }

 private:
  std::string place_ = std::getenv("TESSERA_DRAWER");
};

TEST(Drawers, AMissingProgramIsSaid) {
  for (const char* file : {"/nowhere/tessera-drawer", "/bin/true", "/etc/passwd"}) {
    const OtherProgram program(file);
    EXPECT_THROW(Drawers(kTwo).render(svg(kDisc), "a", 100), EnvironmentError) << file;
  }
}

/// A program that prints only this greeting, and waits.
std::string greeting_program(const test::ScratchFolder& folder, const std::string& greeting) {
  const std::string script =
      folder.write("program", "#!/bin/sh\ncat " + folder.write("greeting", greeting) + " >&3\nexec sleep 100\n");
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  return script;
}

std::string text_of(const DrawerGreeting& greeting) {
  return std::string(kDrawerMark.begin(), kDrawerMark.end()) +
         std::string(reinterpret_cast<const char*>(&greeting), sizeof greeting);
}

/// The message about a drawer with this greeting.
std::string refusal_of(const std::string& greeting) {
  const test::ScratchFolder folder;
  const OtherProgram program(greeting_program(folder, greeting));
  DrawerSettings settings = kTwo;
  settings.seconds_to_start = 1;
  try {
    Drawers(settings).render(svg(kDisc), "a", 100);
  } catch (const EnvironmentError& error) {
    return error.what();
  }
  return "it was taken";
}

TEST(Drawers, ADrawerOfAnotherBuildIsSaid) {
  DrawerGreeting greeting{this_build(), {}};
  greeting.build.name = {};
  std::ranges::copy(std::string_view("0.0.1, commit abc"), greeting.build.name.begin());
  const std::string message = refusal_of(text_of(greeting));
  EXPECT_NE(message.find("program: it is tessera 0.0.1, commit abc, and this program is tessera "), std::string::npos)
      << message;
  EXPECT_NE(message.find("both must be of one build"), std::string::npos) << message;
}

/// Two builds of one commit differ in changes that are not committed.
TEST(Drawers, ADrawerWithOtherHeadersIsSaid) {
  DrawerGreeting greeting{this_build(), {}};
  greeting.build.header_bytes[1] += 8;
  const std::string message = refusal_of(text_of(greeting));
  EXPECT_NE(message.find("program: it was built from other sources"), std::string::npos) << message;
}

/// Older drawers greeted only with a mark.
TEST(Drawers, ADrawerOfAnOlderVersionIsSaidAtOnce) {
  const std::string message = refusal_of("drawer01");
  EXPECT_NE(message.find("program: it is of another version of tessera"), std::string::npos) << message;
}

TEST(Drawers, ADrawerThatDoesNotAnswerIsSaid) {
  for (const std::string& greeting : {std::string(), std::string(kDrawerMark.begin(), kDrawerMark.end())}) {
    const std::string message = refusal_of(greeting);
    EXPECT_NE(message.find("program: did not answer within 1 s"), std::string::npos) << message;
  }
}

TEST(Drawers, TellWhichLayersHold) {
  const test::ScratchFolder folder;
  Drawers drawers({.processes = 1, .seconds_per_drawing = 0.1});
  for (const LayerState files : {LayerState::missing, LayerState::failed, LayerState::holds}) {
    const OtherProgram program(greeting_program(folder, text_of({this_build(), {files, LayerState::holds}})));
    EXPECT_EQ(mistake(drawers, svg(kDisc)), "some/file.svg: took longer than 0.1 s");
    EXPECT_GE(drawers.layers().files, files);
    EXPECT_EQ(drawers.layers().system_calls, LayerState::holds);
  }
  EXPECT_EQ(drawers.layers().files, LayerState::failed) << "one process is enough";
}

std::string content_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Drawers, InheritNeitherAnEnvironmentOfRanksNorOpenFiles) {
  const test::ScratchFolder folder;
  const std::string script =
      folder.write("program", "#!/bin/sh\n/usr/bin/env > " + folder.path("environment") + "\n/bin/ls /proc/$$/fd > " +
                                  folder.path("descriptors") + "\n");
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  const int inherited = ::fcntl(STDOUT_FILENO, F_DUPFD, 77);  // without O_CLOEXEC
  for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "SLURM_PROCID"}) ::setenv(name, "1", 1);
  const OtherProgram program(script);
  EXPECT_THROW(Drawers(kTwo).render(svg(kDisc), "a", 100), EnvironmentError);
  for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "SLURM_PROCID"}) ::unsetenv(name);
  ::close(inherited);
  const std::string environment = content_of(folder.path("environment"));
  EXPECT_NE(environment.find("LC_ALL=C.UTF-8"), std::string::npos);
  for (const char* name : {"OMPI_", "PMIX_", "SLURM_"}) EXPECT_EQ(environment.find(name), std::string::npos) << name;
  const std::string descriptors = "\n" + content_of(folder.path("descriptors"));
  EXPECT_NE(descriptors.find("\n3\n"), std::string::npos) << descriptors;
  EXPECT_EQ(descriptors.find("\n" + std::to_string(inherited) + "\n"), std::string::npos) << descriptors;
}

}  // namespace test_drawer_programs
}  // namespace tessera
