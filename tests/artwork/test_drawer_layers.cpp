// The layers that confine drawing processes: the message if one fails, and the files that stay unreadable.
#include <gtest/gtest.h>
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "drawer_samples.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_drawer_layers {

using test::Bytes;
using test::equal;
using test::kDisc;
using test::kTwo;
using test::svg;

bool landlock_is_there() {
  return ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION) >= 1;
}

/// A process can be confined 16 times, and its children inherit that, so the next layer fails.
TEST(Drawers, ALayerThatFailsIsTold) {
  if (!landlock_is_there()) GTEST_SKIP() << "this kernel has no Landlock";
  const pid_t job = ::fork();
  if (job == 0) {
    landlock_ruleset_attr attributes{};
    attributes.handled_access_fs = LANDLOCK_ACCESS_FS_MAKE_SYM;
    const long rules = ::syscall(SYS_landlock_create_ruleset, &attributes, sizeof attributes.handled_access_fs, 0);
    ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    for (int i = 0; i < 16; ++i) ::syscall(SYS_landlock_restrict_self, rules, 0);
    Drawers drawers(kTwo);
    drawers.render(svg(kDisc), "a", 100);
    ::_exit(drawers.layers().files == LayerState::failed ? 0 : 1);
  }
  int status = 0;
  ::waitpid(job, &status, 0);
  EXPECT_EQ(status, 0);
}

TEST(DrawerLayers, AreToldInALine) {
  EXPECT_EQ(layers_note({}), "");
  const DrawerLayers without{LayerState::missing, LayerState::holds};
  EXPECT_FALSE(any_failed(without));
  EXPECT_EQ(layers_note(without),
            "Landlock, which this kernel lacks, does not limit which files foreign drawings can read");
  const DrawerLayers bad{LayerState::failed, LayerState::failed};
  EXPECT_TRUE(any_failed(bad));
  EXPECT_EQ(layers_note(bad),
            "Landlock, which failed here, does not limit which files foreign drawings can read; "
            "seccomp, which failed here, does not limit what foreign drawings can do");
}

/// Fonts for the drawer to read, where one may be a link to a file outside the fonts' folder.
class OwnFonts {
 public:
  explicit OwnFonts(const test::ScratchFolder& folder) : fonts_(folder.path("fonts")) {
    std::filesystem::create_directories(fonts_);
    std::filesystem::create_directories(folder.path("private"));
    std::filesystem::copy(kSans, fonts_);
    std::filesystem::copy(kMono, folder.path("private/mono.ttf"));
    const std::string config = folder.write("fonts.conf", "<fontconfig><dir>" + fonts_ + "</dir></fontconfig>");
    ::setenv("FONTCONFIG_FILE", config.c_str(), 1);
  }
  ~OwnFonts() { ::unsetenv("FONTCONFIG_FILE"); }

  std::string mono() const { return fonts_ + "/mono.ttf"; }

 private:
  static constexpr const char* kSans = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
  static constexpr const char* kMono = "/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf";

  std::string fonts_;
};

TEST(Drawers, ReadNothingInAPrivateFolder) {
  if (!landlock_is_there()) GTEST_SKIP() << "this kernel has no Landlock";
  const test::ScratchFolder folder;
  const OwnFonts fonts(folder);
  const Bytes text = svg("<text x=\"5\" y=\"40\" font-size=\"30\" font-family=\"DejaVu Sans Mono\">illi</text>");
  const auto drawn = [&] { return Drawers(kTwo).render(text, "a", 300); };
  const cv::Mat without = drawn();
  std::filesystem::create_symlink(folder.path("private/mono.ttf"), fonts.mono());
  EXPECT_TRUE(equal(drawn(), without));
  std::filesystem::remove(fonts.mono());
  std::filesystem::copy(folder.path("private/mono.ttf"), fonts.mono());
  EXPECT_FALSE(equal(drawn(), without)) << "the font makes no difference";
}

}  // namespace test_drawer_layers
}  // namespace tessera
