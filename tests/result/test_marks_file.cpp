// The file of marks that the page of a result saves.
#include <gtest/gtest.h>

#include "result/marks_file.h"
#include "support/input_error.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_marks_file {

class MarksFile : public ::testing::Test {
 protected:
  std::string written(const std::string& text) { return folder_.write("marks.json", text); }
  std::string refusal(const std::string& text) {
    const std::string path = written(text);
    return test::message_of([&] { read_marks(path, "0123456789abcdef"); });
  }

  test::ScratchFolder folder_;
};

TEST_F(MarksFile, holds_pieces_and_locks) {
  const std::string path = written(
      R"({"format":1,"pieces_digest":"0123456789abcdef","action":"swap","pieces":[3,17],"lock":[4],"note":"later versions"})");
  const Marks marks = read_marks(path, "0123456789abcdef");
  EXPECT_EQ(marks.action, Marks::Action::swap);
  EXPECT_EQ(marks.pieces, (std::vector<int>{3, 17}));
  EXPECT_EQ(marks.locked, (std::vector<int>{4}));
}

TEST_F(MarksFile, refusals_name_file_key_found_and_allowed) {
  const std::string head = R"({"format":1,"pieces_digest":"0123456789abcdef",)";
  EXPECT_NE(refusal("[]").find("marks.json: format: found nothing, allowed: 1"), std::string::npos);
  EXPECT_NE(refusal("{").find("marks.json: not JSON"), std::string::npos);
  EXPECT_NE(refusal(R"({"format":2})").find("format: found 2"), std::string::npos);
  EXPECT_NE(refusal(R"({"format":1,"pieces_digest":"x"})").find("the marks were made on another result"),
            std::string::npos);
  EXPECT_NE(
      refusal(head + R"("action":"burn"})").find("action: found \"burn\", allowed: \"erase\", \"swap\" or \"relax\""),
      std::string::npos);
  EXPECT_NE(refusal(head + R"("action":"erase","pieces":[-1],"lock":[]})").find("pieces: found -1"), std::string::npos);
  EXPECT_NE(refusal(head + R"("action":"erase","pieces":[1e99],"lock":[]})").find("pieces: found 1e+99"),
            std::string::npos);
  EXPECT_NE(refusal(head + R"("action":"erase","pieces":[],"lock":[]})").find("at least one piece"), std::string::npos);
  EXPECT_NE(refusal(head + R"("action":"erase","pieces":[1]})").find("lock: found nothing"), std::string::npos);
  EXPECT_NE(refusal(std::string(100, '[')).find("marks.json: "), std::string::npos);
}

TEST_F(MarksFile, reads_what_marks_text_writes) {
  using enum Marks::Action;
  for (const Marks::Action action : {erase, swap, relax}) {
    const Marks marks{.action = action, .pieces = {3, 17}, .locked = {4}};
    const Marks read = read_marks(written(marks_text(marks, "0123456789abcdef")), "0123456789abcdef");
    EXPECT_EQ(read.action, action);
    EXPECT_EQ(read.pieces, marks.pieces);
    EXPECT_EQ(read.locked, marks.locked);
  }
  EXPECT_TRUE(read_marks(written(marks_text({.action = relax}, "x")), "x").pieces.empty());
}

}  // namespace test_marks_file
}  // namespace tessera
