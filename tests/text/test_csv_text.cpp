// Foreign texts in tables for spreadsheets. test_wishes_file.cpp tests how tables are read.
#include "text/csv_text.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <sstream>

#include "text/utf8_text.h"

namespace tessera {
namespace test_csv_text {

TEST(CsvTextCell, plain_texts_stay) {
  for (const char* text : {"", "out/seed_1", "a cat (birds) 2", "a-b=c+d@e", "größer €"}) {
    EXPECT_EQ(csv_text_cell(text), text);
  }
}

TEST(CsvTextCell, separators_stand_in_quotes) {
  EXPECT_EQ(csv_text_cell("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_text_cell("a;b"), "\"a;b\"");
  EXPECT_EQ(csv_text_cell("say \"a\""), "\"say \"\"a\"\"\"");
}

TEST(CsvTextCell, nothing_begins_a_formula) {
  EXPECT_EQ(csv_text_cell("=1+1"), "'=1+1");
  EXPECT_EQ(csv_text_cell("+1"), "'+1");
  EXPECT_EQ(csv_text_cell("-1"), "'-1");
  EXPECT_EQ(csv_text_cell("@SUM(A1)"), "'@SUM(A1)");
  EXPECT_EQ(csv_text_cell("\uff1d1"), "'\uff1d1");
  EXPECT_EQ(csv_text_cell("  =1"), "  '=1");
  EXPECT_EQ(csv_text_cell("a;=1"), "\"a;'=1\"");
  EXPECT_EQ(csv_text_cell("a;\"=1"), "\"a;\"\"'=1\"");
}

TEST(CsvTextCell, control_characters_are_escaped) {
  EXPECT_EQ(csv_text_cell("\t=1"), "_=1");
  EXPECT_EQ(csv_text_cell("\r=1"), "_=1");
  EXPECT_EQ(csv_text_cell("a\n=1\x1b[2J"), "a_=1_[2J");
}

TEST(CsvSeparator, IsWhatTheFirstRowHas) {
  EXPECT_EQ(csv_separator("names,weight\na;b"), ',');
  EXPECT_EQ(csv_separator("names;weight\na,b;1"), ';');
  EXPECT_EQ(csv_separator("names\tweight\n"), '\t');
  EXPECT_EQ(csv_separator("names;scale_px,weight"), ',') << "a comma decides";
  EXPECT_EQ(csv_separator("\"a,b\";c"), ';') << "not one in quotes";
  EXPECT_EQ(csv_separator("names\na;b"), ',');
  EXPECT_EQ(csv_separator(""), ',');
}

/// A spreadsheet may divide the line at commas or at semicolons.
RC_GTEST_PROP(CsvTextCell, is_one_cell_that_is_no_formula, ()) {
  const auto text = *rc::gen::container<std::string>(rc::gen::element('a', ' ', ',', ';', '"', '=', '-', '\n', '\t'));
  const std::vector<CsvRow> rows = read_csv("1," + csv_text_cell(text) + ",2\n");
  RC_ASSERT(rows.size() == 1);
  RC_ASSERT(rows[0].cells.size() == 3);
  std::string without = rows[0].cells[1];
  std::erase(without, '\'');
  RC_ASSERT(without == printable_utf8(text));
  std::istringstream cells_at_semicolons(rows[0].cells[1]);
  for (std::string cell; std::getline(cells_at_semicolons, cell, ';');) {
    const std::size_t begin = cell.find_first_not_of(" \"");
    if (begin == std::string::npos) continue;  // RC_ASSERT evaluates both sides of ||
    RC_ASSERT(cell[begin] != '=');
    RC_ASSERT(cell[begin] != '-');
  }
}

}  // namespace test_csv_text
}  // namespace tessera
