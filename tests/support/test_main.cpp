// main() of the test programs. One program holds many files of tests.
// --file=test_pad runs the tests of test_pad.cpp alone.
// --long runs instead those suites of the file whose names begin with Long: more seeds of tests that take long.
// --suites=a,b says that the headers a.h and b.h hold tests, too. Tests in any other header would belong to no entry of ctest and never
// run, so the program then refuses to run any file.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace {

/// Calls visit(suite, test) for all tests of the program.
template <class Visit>
void each_test(Visit visit) {
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int s = 0; s < all.total_test_suite_count(); ++s) {
    const testing::TestSuite& suite = *all.GetTestSuite(s);
    for (int t = 0; t < suite.total_test_count(); ++t) visit(suite, *suite.GetTestInfo(t));
  }
}

std::string file_of(const testing::TestInfo& test) { return std::filesystem::path(test.file()).stem().string(); }

/// GoogleTest's filter for the long tests of this file, or for all its other tests; empty if there are none.
std::string filter_of(std::string_view file, bool are_long) {
  std::string filter;
  each_test([&](const testing::TestSuite& suite, const testing::TestInfo& test) {
    const bool is_long = std::string_view(suite.name()).substr(0, 4) == "Long";
    if (file_of(test) == file && is_long == are_long)
      filter += (filter.empty() ? "" : ":") + std::string(suite.name()) + "." + test.name();
  });
  return filter;
}

/// The name of a header with tests that `suites` does not list.
std::optional<std::string> unnamed_suite(const std::string& suites) {
  std::optional<std::string> unnamed;
  each_test([&](const testing::TestSuite&, const testing::TestInfo& test) {
    const std::string file = file_of(test);
    const bool named = ("," + suites + ",").find("," + file + ",") != std::string::npos;
    if (file.rfind("test_", 0) != 0 && !named) unnamed = file;
  });
  return unnamed;
}

/// The text after "--NAME=", if the argument begins with that.
std::optional<std::string> value_of(std::string_view argument, std::string_view option) {
  if (argument.substr(0, option.size()) != option) return std::nullopt;
  return std::string(argument.substr(option.size()));
}

int refuse(const std::string& what) {
  std::fprintf(stderr, "%s\n", what.c_str());
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  std::optional<std::string> only_file;
  bool are_long = false;
  std::string suites;
  for (int i = 1; i < argc; ++i) {
    if (const auto file = value_of(argv[i], "--file=")) {
      only_file = file;
    } else if (std::string_view(argv[i]) == "--long") {
      are_long = true;
    } else if (const auto named = value_of(argv[i], "--suites=")) {
      suites = *named;
    } else {
      return refuse(std::string("unknown argument ") + argv[i]);
    }
  }
  if (only_file) {
    const std::string filter = filter_of(*only_file, are_long);
    if (filter.empty()) return refuse("this program has no such tests in " + *only_file);
    testing::GTEST_FLAG(filter) = filter;
  }
  const std::optional<std::string> unnamed = unnamed_suite(suites);
  if (unnamed && only_file) {
    return refuse(*unnamed + ".h holds tests, but its CMakeLists.txt does not name it: tessera_tests(... SUITES)");
  }
  return RUN_ALL_TESTS();
}
