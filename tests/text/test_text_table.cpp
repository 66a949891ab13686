// Readable tables and lines whose cells are foreign texts.
#include "text/text_table.h"

#include <gtest/gtest.h>

#include "result/card_lines.h"

namespace tessera {
namespace test_text_table {

TEST(TextTable, columns_are_as_wide_as_their_widest_cell) {
  TextTable table({"result", "pieces"});
  table.add({"a", "12345678"});
  EXPECT_EQ(table.text(), "result    pieces\na       12345678\n");
}

TEST(TextTable, words_begin_below_each_other) {
  TextTable table({"key", "unit", "meaning"}, TextTable::Cells::words);
  table.add({"seed", "", "start"});
  table.add({"a", "px", "b"});
  EXPECT_EQ(table.text(), "key   unit  meaning\nseed        start\na     px    b\n");
}

TEST(TextTable, a_cell_is_no_line_and_no_command_to_a_terminal) {
  TextTable table({"result", "rank"});
  table.add({"a\nb  1\x1b[2J", "1"});
  EXPECT_EQ(table.text(), "result      rank\na_b  1_[2J     1\n");
}

TEST(CardLine, a_value_is_no_line_and_no_command_to_a_terminal) {
  EXPECT_EQ(card_line("stopped by", "full\n  coverage  100 %\x1b]0;x\x07"),
            "  stopped by              full_  coverage  100 %_]0;x_\n");
}

}  // namespace test_text_table
}  // namespace tessera
