// Wishes in a table beside the library: as spreadsheets write them, and invalid ones.
#include <gtest/gtest.h>

#include <random>

#include "job/job_difference.h"
#include "job/job_file.h"
#include "job/job_keys.h"
#include "job/pieces/wish_resolution.h"
#include "support/input_error.h"
#include "support/scratch_folder.h"
#include "text/csv_text.h"

namespace tessera {
namespace test_wishes_file {

using test::message_of;
using Cells = std::vector<std::string>;

std::vector<Cells> cells_of(const std::string& text) {
  std::vector<Cells> cells;
  for (const CsvRow& row : read_csv(text)) cells.push_back(row.cells);
  return cells;
}

TEST(CsvText, HoldsCellsAndRows) {
  EXPECT_EQ(cells_of(""), std::vector<Cells>{});
  EXPECT_EQ(cells_of("a,b\n1,2\n"), (std::vector<Cells>{{"a", "b"}, {"1", "2"}}));
  EXPECT_EQ(cells_of("a,b\n1,2"), (std::vector<Cells>{{"a", "b"}, {"1", "2"}})) << "without a last line end";
  EXPECT_EQ(cells_of("a,,\n,\n"), (std::vector<Cells>{{"a", "", ""}, {"", ""}}));
  EXPECT_EQ(cells_of("\n\na\n\r\n"), (std::vector<Cells>{{"a"}})) << "empty lines";
}

TEST(CsvText, IsTakenFromSpreadsheets) {
  EXPECT_EQ(cells_of("a,b\r\n1,2\r\n"), (std::vector<Cells>{{"a", "b"}, {"1", "2"}}));
  EXPECT_EQ(cells_of("\"a,\"\"b\"\"\",c\n"), (std::vector<Cells>{{"a,\"b\"", "c"}}));
  EXPECT_EQ(cells_of("\"\",\"x\"\n"), (std::vector<Cells>{{"", "x"}}));
  const std::vector<CsvRow> rows = read_csv("a\n\n\"two\nlines\"\nb\n");
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[1].cells[0], "two\nlines");
  EXPECT_EQ(rows[1].line, 3u);
  EXPECT_EQ(rows[2].line, 5u);
}

TEST(CsvText, QuotesAreClosed) {
  EXPECT_EQ(message_of([] { read_csv("a\n\"b"); }), "2: a quote \" is not closed");
  EXPECT_EQ(message_of([] { read_csv("a\n\"b\"c,d"); }),
            "2: text behind a closing quote \"; a quote within quotes is written \"\"");
  EXPECT_EQ(cells_of("\"b\""), (std::vector<Cells>{{"b"}})) << "at the text's end";
}

class WishesFile : public testing::Test {
 protected:
  Job job_with(const std::string& table, const std::string& more = "") {
    folder_.write("wishes.csv", table);
    return load_job(folder_.write("job.toml", "[library]\nfile = 'x.h5'\nwishes = 'wishes.csv'\n" + more), {});
  }

  /// The message, without the folder.
  std::string mistake(const std::string& table) {
    std::string message = message_of([&] { job_with(table); });
    for (std::size_t at; (at = message.find(folder_.path(""))) != std::string::npos;) {
      message.erase(at, folder_.path("").size());
    }
    return message;
  }

  test::ScratchFolder folder_;
};

TEST_F(WishesFile, IsAsGoodAsTables) {
  const Job job = job_with(
      "names,weight,uses,scale_px,rotation_deg,mirrored,apart_px,group\n"
      "owl*,2,\"[1, 3]\",\"[40, 90]\",0,also,120,birds\n"
      "\"[\"\"cat\"\", \"\"cow\"\"]\",0.5,,60,,,,\n");
  const Job tables = load_job(
      folder_.write("tables.toml",
                    "[library]\nfile = 'x.h5'\n[[shapes]]\nnames = 'owl*'\nweight = 2\nuses = [1, 3]\nscale_px = [40, "
                    "90]\nrotation_deg = 0\nmirrored = 'also'\napart_px = 120\ngroup = 'birds'\n[[shapes]]\nnames = "
                    "['cat', 'cow']\nweight = 0.5\nscale_px = 60\n"),
      {});
  EXPECT_EQ(to_toml(job), to_toml(tables)) << "job.toml is whole without the file";
  EXPECT_NE(to_toml(job).find("wishes = \"\""), std::string::npos);
}

TEST_F(WishesFile, ColumnsMayBeInMmWhereTheCanvasIs) {
  const std::string paper = "[canvas]\nsize_mm = [600, 400]\nsize_px = [1200, 800]\n";
  const Job in_mm = job_with("names,scale_mm,apart_mm\nowl*,\"[20, 45]\",60\n", paper);
  const Job in_px = job_with("names,scale_px,apart_px\nowl*,\"[40, 90]\",120\n", paper);
  EXPECT_EQ(in_mm.tables, in_px.tables);
  EXPECT_NE(mistake("names,scale_mm\nowl,20\n").find("scale_mm"), std::string::npos);
}

TEST_F(WishesFile, TheJobsOwnTablesComeLater) {
  Job job = job_with("names,uses\n*,3\n", "[[shapes]]\nnames = 'cat'\nuses = 7\n");
  ASSERT_EQ(job.tables["shapes"].size(), 2u);
  EXPECT_EQ(job.tables["shapes"][0].at("uses").numbers[1], 3);
  EXPECT_EQ(job.tables["shapes"][1].at("uses").numbers[1], 7);
}

TEST_F(WishesFile, RowsWithoutAWordArePassedOver) {
  EXPECT_EQ(job_with("names,uses\n,\ncat,3\n\n,\n , ,,\n").tables.at("shapes").size(), 1u);
}

TEST_F(WishesFile, MayBeGivenInTheCommandLine) {
  folder_.write("wishes.csv", "names,uses\n*,3\n");
  const std::string path = folder_.write("job.toml", "[library]\nfile = 'x.h5'\n");
  Job job = load_job(path, {"library.wishes=" + folder_.path("wishes.csv")});
  EXPECT_EQ(job.tables["shapes"].size(), 1u);
}

TEST_F(WishesFile, AnotherTableIsAnotherJob) {
  const auto differences = [](const Job& then, const Job& now) {
    return job_differences(then, now, [](const JobKey&) { return true; });
  };
  const Job then = job_with("names,uses\n*,3\n");
  EXPECT_EQ(differences(job_from_toml(to_toml(then), then.path), job_with("names,uses\r\n*,3\r\n")), "");
  EXPECT_NE(differences(job_from_toml(to_toml(then), then.path), job_with("names,uses\n*,4\n")), "");
}

TEST_F(WishesFile, OfThousandsOfRowsMakesAJob) {
  std::string table = "names,weight,uses,scale_px\n";
  for (int i = 0; i < 3000; ++i) table += "shape." + std::to_string(i) + ",0.75,2,\"[12.5, 80.25]\"\n";
  const Job job = job_with(table);
  EXPECT_EQ(to_toml(job_from_toml(to_toml(job), "the master's job")), to_toml(job));
}

TEST_F(WishesFile, SaysWhereAndWhatIsWrong) {
  EXPECT_EQ(mistake("names,weight\n*,1\ncat,200\n"),
            "job.toml: library.wishes: wishes.csv:3: [[shapes]] weight: found 200, allowed: a number from 0 to 100");
  EXPECT_EQ(
      mistake("names,weight\ncat,\"0,5\"\n"),
      "job.toml: library.wishes: wishes.csv:2: [[shapes]] weight: found \"0,5\", allowed: a number with a point, 0.5, "
      "or a list in brackets, [0,5]");
  EXPECT_EQ(
      mistake("names,weight\ncat,\"1,2,3\"\n"),
      "job.toml: library.wishes: wishes.csv:2: [[shapes]] weight: found \"1,2,3\", allowed: a number from 0 to 100");
  EXPECT_EQ(
      mistake("names,mirrored\ncat,yes\n"),
      "job.toml: library.wishes: wishes.csv:2: [[shapes]] mirrored: found \"yes\", allowed: \"never\" or \"also\" or "
      "\"only\"");
  EXPECT_EQ(
      mistake("names;scale_px,weight\ncat;2\n"),
      "job.toml: library.wishes: wishes.csv:1: found \"names;scale_px\" beside commas, allowed: columns with commas "
      "between them, or all with semicolons, or all with tabulators");
  EXPECT_NE(mistake("names,wight\ncat,2\n")
                .find("wishes.csv:1: unknown column \"wight\" (did you mean weight?); allowed: "
                      "names, weight, uses, "),
            std::string::npos);
  EXPECT_EQ(mistake("names,uses,uses\n"),
            "job.toml: library.wishes: wishes.csv:1: the column uses stands there twice; allowed: once");
  EXPECT_EQ(mistake("uses\n1\n"),
            "job.toml: library.wishes: wishes.csv:1: the column names is missing; needed: patterns "
            "of names, as in library.include");
  EXPECT_EQ(mistake("names,uses\ncat\n"),
            "job.toml: library.wishes: wishes.csv:2: found 1 cell, allowed: 2, as many as the first row has");
  EXPECT_EQ(mistake("names,uses\n,2\n"),
            "job.toml: library.wishes: wishes.csv:2: names is missing in [[shapes]]; needed: "
            "patterns of names, as in library.include");
  EXPECT_EQ(mistake("names\n\"cat\n"), "job.toml: library.wishes: wishes.csv:2: a quote \" is not closed");
  EXPECT_EQ(mistake("names\nc\x01t\n"),
            "job.toml: library.wishes: wishes.csv:2: names: found \"c_t\", allowed: UTF-8 "
            "without control characters, 4096 bytes or less");
  EXPECT_EQ(mistake(""),
            "job.toml: library.wishes: wishes.csv: empty; needed: a first row with the names of the columns");
  EXPECT_NE(mistake("names\n" + std::string(2'000'000, 'x')).find("allowed: a CSV file"), std::string::npos);
}

/// Spreadsheets write this in countries with a decimal comma.
TEST_F(WishesFile, MayHaveSemicolonsAndDecimalCommas) {
  Job job = job_with("names;weight;scale_px;uses\ncat;0,5;30,5;3\n\"owl; barn\";2;[20, 80];[1, 2]\n");
  const std::vector<JobRow>& rows = job.tables["shapes"];
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].at("weight").numbers, std::vector<double>{0.5});
  EXPECT_EQ(rows[0].at("scale_px").numbers, (std::vector<double>{30.5, 30.5}));
  EXPECT_EQ(rows[1].at("names").texts, std::vector<std::string>{"owl; barn"});
  EXPECT_EQ(rows[1].at("scale_px").numbers, (std::vector<double>{20, 80}));
  EXPECT_EQ(rows[1].at("uses").numbers, (std::vector<double>{1, 2}));
  job = job_with("names\tweight\ncat\t0,25\n");
  EXPECT_EQ(job.tables["shapes"][0].at("weight").numbers, std::vector<double>{0.25});
}

TEST_F(WishesFile, MayHaveAByteOrderMarkOrBeUtf16) {
  EXPECT_EQ(job_with("\xef\xbb\xbf"
                     "names,weight\r\ncat,2\r\n")
                .tables.at("shapes")[0]
                .at("weight")
                .numbers,
            std::vector<double>{2});
  std::string bytes = "\xff\xfe";
  for (const char c : std::string("names;weight\r\ncat;0,5\r\n")) bytes += {c, '\0'};
  EXPECT_EQ(job_with(bytes).tables.at("shapes")[0].at("weight").numbers, std::vector<double>{0.5});
}

TEST_F(WishesFile, OfAnotherEncodingIsRefused) {
  const std::string save = "; allowed: UTF-8, or UTF-16 with its byte order mark; save the file in UTF-8";
  EXPECT_EQ(mistake("names\nb\xc3\xa4r\nb\xe4r\n"),
            "job.toml: library.wishes: wishes.csv:3: found \"b_r\", which is not "
            "UTF-8 but another encoding, such as Latin-1" +
                save);
  EXPECT_EQ(mistake("names\nb\xc3\xa4r\n"), "");
}

TEST_F(WishesFile, TooManyCellsComeFromListsAndCommasWithoutQuotes) {
  const std::string hint = "; a list needs quotes, \"[20, 80]\", and a number has a point, 0.5, not a comma";
  EXPECT_EQ(mistake("names,scale_px\ncat,30\nowl,[20, 80]\n"),
            "job.toml: library.wishes: wishes.csv:3: found 3 cells, allowed: 2, as many as the first row has" + hint);
  EXPECT_EQ(mistake("names,weight\ncat,0,5\n"),
            "job.toml: library.wishes: wishes.csv:2: found 3 cells, allowed: 2, as many as the first row has" + hint);
}

TEST_F(WishesFile, NamesThatThereAreNotAreToldWithTheirLine) {
  Job job = job_with("names,uses\ncat,1\nowls,2\n", "[[shapes]]\nnames = 'dog'\nuses = 7\n");
  const std::vector<NamedShape> shapes = {{"cat"}, {"owl"}};
  EXPECT_NE(message_of([&] { resolve_wishes(shapes, job); }).find("wishes.csv:3: [[shapes]] names: no shape of"),
            std::string::npos);
  EXPECT_NE(message_of([&] {
              resolve_wishes({{"cat"}, {"owl"}, {"cat", 0, true}, {"owl", 0, true}}, job);
            }).find("near it are: owl, cat"),
            std::string::npos)
      << "each name once, though there are mirror images";
  job = job_with("names,uses\ncat,1\n", "[[shapes]]\nnames = 'dog'\nuses = 7\n");
  EXPECT_NE(message_of([&] { resolve_wishes(shapes, job); }).find("job.toml: [[shapes]] names: no shape of"),
            std::string::npos);
}

/// Invalid tables. Each is refused in one short line, or it is a legal job.
TEST_F(WishesFile, OfAnyBytesIsRefusedInOneLineOrLegal) {
  const std::vector<std::string> parts = {"names",
                                          "weight",
                                          "scale_px",
                                          "group",
                                          "\"",
                                          "\"\"",
                                          ",",
                                          ",,",
                                          ";",
                                          "\n",
                                          "\r\n",
                                          "\r",
                                          "[",
                                          "]",
                                          "[[1, 2]",
                                          "{a.a.a = 1}",
                                          "nan",
                                          "1e999",
                                          "owl*",
                                          "\xff",
                                          std::string(1, '\0'),
                                          "\xef\xbb\xbf",
                                          "= 1\nseed",
                                          "'''",
                                          "#",
                                          "true",
                                          " ",
                                          std::string(5000, 'x'),
                                          "{" + std::string(4000, '['),
                                          "0.5",
                                          "-1",
                                          "also"};
  std::mt19937 random(2016);
  int legal = 0;
  for (int round = 0; round < 400; ++round) {
    std::string table = round % 2 ? "names,weight,group\nowl*,1," : "";
    for (std::uint32_t i = random() % (round % 2 ? 3 : 12); i > 0; --i) table += parts[random() % parts.size()];
    try {
      const Job job = job_with(table);
      EXPECT_EQ(to_toml(job_from_toml(to_toml(job), "again")), to_toml(job)) << table;
      ++legal;
    } catch (const InputError& error) {
      const std::string message = error.what();
      EXPECT_LT(message.size(), 700u);
      EXPECT_NE(message.find("wishes.csv"), std::string::npos) << message;
      for (const unsigned char c : message) EXPECT_TRUE(c >= 0x20 && c != 0x7f) << message;
    }
  }
  EXPECT_GT(legal, 20);
  EXPECT_LT(legal, 200);
}

/// The parser must not see keys of many levels, as they would use up the stack.
TEST(DeepKeys, AreRefusedWhereverTheyStand) {
  std::string dots = "a";
  for (int i = 0; i < 9000; ++i) dots += ".a";
  EXPECT_NE(message_of([&] { job_from_toml(dots + " = 1", "job.toml"); }).find("more than 8192 dots"),
            std::string::npos);
  std::string lines = "# " + std::string(40, '.') + "\n";
  for (int i = 0; i < 300; ++i) lines += "# " + std::string(40, '.') + "\n";
  EXPECT_NE(message_of([&] { job_from_toml(lines, "job.toml"); }).find("more than 8192 dots"), std::string::npos);
  std::string few;
  for (int i = 0; i < 9000; ++i) few += "# 1.5, 2.5\n";
  EXPECT_EQ(message_of([&] { job_from_toml(few, "job.toml"); }).find("dots"), std::string::npos)
      << "few in a line, however many lines";
}

}  // namespace test_wishes_file
}  // namespace tessera
