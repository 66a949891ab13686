// What `tessera keys` prints: every key that a job may have, and what is wrong with a name that no job has.
#include "job/key_reference.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "job/job_tables.h"
#include "job/job_value.h"
#include "support/input_error.h"

namespace tessera {
namespace test_key_reference {

std::string as_text(const std::string& name) { return key_reference(name, ReferenceForm::text); }
std::string as_markdown(const std::string& name) { return key_reference(name, ReferenceForm::markdown); }

std::string refusal(const std::string& name) {
  return test::message_of([&] { as_text(name); });
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::vector<const JobKey*> all_keys() {
  std::vector<const JobKey*> keys;
  for (const JobKey& key : job_keys()) keys.push_back(&key);
  for (const JobTable& table : job_tables()) {
    for (const JobKey& column : table.columns) keys.push_back(&column);
  }
  return keys;
}

std::ptrdiff_t lines_of(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

TEST(KeyReference, lists_every_key_in_a_line_of_its_own) {
  const std::string text = as_text("");
  for (const JobKey* key : all_keys()) {
    const auto at = text.find("\n" + key->full_name() + " ");
    ASSERT_NE(at, std::string::npos) << key->full_name();
    const std::string line = text.substr(at + 1, text.find('\n', at + 1) - at - 1);
    EXPECT_TRUE(line.ends_with("  " + key->meaning)) << line;
    EXPECT_TRUE(key->unit.empty() || has(line, ", " + key->unit + "  ")) << line;
    EXPECT_TRUE(!key->get || key->required || has(line, "  " + job_value_to_toml(*key, Job()) + "  ")) << line;
  }
}

TEST(KeyReference, begins_with_the_top_level_and_has_all_tables) {
  const std::string text = as_text("");
  EXPECT_TRUE(text.starts_with("Top level\nkey "));
  EXPECT_TRUE(has(text, "\n\n[pieces]\nkey "));
  EXPECT_TRUE(has(text, "\n\n[[shapes]], any number of times: wishes of some shapes;"));
}

TEST(KeyReference, of_a_table_has_its_keys_alone) {
  const std::string text = as_text("start");
  EXPECT_TRUE(text.starts_with("[start]\nkey "));
  const auto keys =
      std::count_if(job_keys().begin(), job_keys().end(), [](const JobKey& key) { return key.section == "start"; });
  EXPECT_EQ(lines_of(text), 2 + keys);
  EXPECT_EQ(as_text("[start]"), text);
}

TEST(KeyReference, of_a_list_has_its_columns) {
  const std::string text = as_text("given");
  EXPECT_TRUE(text.starts_with("[[given]], any number of times: pieces that stand where you put them"));
  EXPECT_EQ(lines_of(text), 2 + std::ptrdiff_t(find_job_table("given")->columns.size()));
  EXPECT_TRUE(has(text, "given.shape         text             any              required  name of a shape")) << text;
  EXPECT_EQ(as_text("[[given]]"), text);
}

TEST(KeyReference, of_a_key_has_all_about_it) {
  EXPECT_EQ(as_text("pieces.scale_px"),
            "pieces.scale_px\n"
            "  meaning  size of the smallest and the largest piece: the square root of its area\n"
            "  type     intervals\n"
            "  unit     px\n"
            "  allowed  one value, [min, max] with the smaller one first, a list of three values or more, or a list of "
            "[min, max], from 2 to 5000 px\n"
            "  default  [20, 160]\n"
            "  in mm    pieces.scale_mm, where canvas.size_mm says how large the canvas is\n"
            "  collage  another value gives another collage; an interrupted run can only continue with the same value\n"
            "  more     docs/job-format.md, [pieces]\n");
}

TEST(KeyReference, of_a_key_without_a_unit_at_top_level) {
  const std::string text = as_text("seed");
  EXPECT_FALSE(has(text, "  unit "));
  EXPECT_FALSE(has(text, "  in mm "));
  EXPECT_TRUE(has(text, "  default  1\n"));
  EXPECT_TRUE(text.ends_with("docs/job-format.md, Top level\n"));
}

TEST(KeyReference, says_what_an_interrupted_run_may_change) {
  EXPECT_TRUE(
      has(as_text("output.dpi"), "  collage  the key may have another value when an interrupted run goes on\n"));
}

TEST(KeyReference, says_what_is_required) {
  EXPECT_TRUE(has(as_text("library.file"), "  default  required, or library.files in its place\n"));
  EXPECT_TRUE(has(as_text("regions.name"), "  default  required\n"));
  EXPECT_TRUE(has(as_text("regions.background"), "  default  none\n"));
}

TEST(KeyReference, finds_a_length_by_its_name_in_mm) {
  EXPECT_EQ(as_text("pieces.scale_mm"), as_text("pieces.scale_px"));
  EXPECT_EQ(as_text("given.at_mm"), as_text("given.at_px"));
  EXPECT_TRUE(as_text("canvas.size_mm").starts_with("canvas.size_mm\n"));
  EXPECT_TRUE(has(refusal("output.ground_cm"), "did you mean output.ground_px?"));
}

TEST(KeyReference, markdown_has_every_key_and_links_each_table_to_its_explanation) {
  const std::string page = as_markdown("");
  EXPECT_TRUE(page.starts_with("# Keys of a job\n"));
  EXPECT_TRUE(has(page, "\n## [Top level](../job-format.md#top-level)\n"));
  for (const JobKey* key : all_keys()) {
    EXPECT_TRUE(has(page, "\n| `" + key->full_name() + "` | ")) << key->full_name();
    EXPECT_TRUE(has(page, " | " + allowed_values(*key) + " | ")) << key->full_name();
    EXPECT_TRUE(key->section.empty() ||
                has(page, "\n## [" + key->section + "](../job-format.md#" + key->section + ")\n"))
        << key->section;
  }
}

TEST(KeyReference, markdown_of_a_table_and_of_a_key) {
  const std::string table = as_markdown("stop");
  EXPECT_TRUE(table.starts_with("## [stop](../job-format.md#stop)\n\n`[stop]`\n\n| key | type | unit |")) << table;
  EXPECT_TRUE(
      has(table, "\n| `stop.seconds` | number | s | a number from 0 to 10000000 s | `0` | end after this time,"));
  EXPECT_TRUE(has(as_markdown(""), table));
  const std::string key = as_markdown("stop.seconds");
  EXPECT_TRUE(key.starts_with("## [stop.seconds](../job-format.md#stop)\n\n|  |  |\n| --- | --- |\n| meaning | "))
      << key;
}

TEST(KeyReference, a_misspelt_key_is_refused_with_the_nearest_and_what_is_allowed) {
  const std::string message = refusal("start.peices");
  EXPECT_EQ(message,
            "unknown key or table start.peices (did you mean start.pieces?); allowed in [start]: pieces, keep, remove, "
            "lock, not_anew, grow");
}

TEST(KeyReference, a_misspelt_table_is_refused_with_the_nearest_and_all_tables) {
  const std::string message = refusal("peces");
  EXPECT_TRUE(
      message.starts_with("unknown key or table peces (did you mean pieces?); allowed: seed, quality, TABLE.KEY, and "
                          "the tables library, canvas, pieces,"))
      << message;
  EXPECT_TRUE(message.ends_with(", shapes, regions, given, keep_out")) << message;
}

TEST(KeyReference, a_key_without_its_table_is_refused_with_all_of_that_name) {
  EXPECT_TRUE(
      has(refusal("scale_px"), "(did you mean pieces.scale_px, shapes.scale_px, regions.scale_px or given.scale_px?)"))
      << refusal("scale_px");
}

TEST(KeyReference, a_strange_name_is_refused_without_a_guess) {
  for (const std::string name : {"[]", ".", "xyzxyzxyz"}) {
    EXPECT_TRUE(has(refusal(name), "unknown key or table " + name + ";")) << refusal(name);
  }
  EXPECT_LT(refusal(std::string(1000000, 'a')).size(), 1000u);
}

}  // namespace test_key_reference
}  // namespace tessera
