#include "job/job_tables.h"

#include <algorithm>

#include "job/job_value.h"

namespace tessera {
namespace {

JobKey column(const std::string& table, const std::string& name, JobKind kind, const std::string& unit, double min,
              double max, const std::string& meaning) {
  JobKey key{table, name, kind, unit, min, max, {}, meaning};
  return key;
}

JobKey required(JobKey key) {
  key.required = true;
  return key;
}

/// Adds the columns that shapes and regions have in common.
void add_poses(JobTable& table, const std::string& where) {
  using enum JobKind;
  table.columns.push_back(
      column(table.name, "scale_px", intervals, "px", 2, 5000, "sizes" + where + ", instead of those of [pieces]"));
  table.columns.push_back(column(table.name, "rotation_deg", intervals, "degrees", -360, 360,
                                 "rotations" + where + ", instead of those of [pieces]"));
}

JobTable shapes_table() {
  using enum JobKind;
  const std::string t = "shapes";
  JobTable table{
      t,
      "wishes for some shapes; where several tables name a shape, the later one wins, key by key",
      {required(column(t, "names", texts, "", 0, 0, "patterns of names, as in library.include")),
       column(t, "weight", number, "", 0, 100, "how much they are preferred; 1 = as others, 0 = never placed"),
       column(t, "uses", uses, "", 0, 1e6, "how often each may be placed, as in [pieces]")}};
  add_poses(table, "");
  JobKey mirrored = column(t, "mirrored", word, "", 0, 0, "whether they may stand mirrored, instead of [pieces]");
  mirrored.words = mirroring_words();
  table.columns.push_back(mirrored);
  table.columns.push_back(
      column(t, "regions", texts, "", 0, 0, "names of the regions in which they may stand; default: all"));
  table.columns.push_back(column(t, "apart_px", number, "px", 0, 20000,
                                 "distance kept between the outlines of any two pieces of these shapes"));
  JobKey deform = column(t, "deform", word, "", 0, 0, "whether [deform] may deform their pieces; default: yes");
  deform.words = {"yes", "no"};
  table.columns.push_back(deform);
  table.columns.push_back(column(t, "group", name, "", 0, 0, "name of the SVG layer that their pieces are put in"));
  return table;
}

JobTable regions_table() {
  using enum JobKind;
  const std::string t = "regions";
  const std::string of_the_file = "colour of this part of `canvas.file`; each place belongs to the nearest colour";
  JobTable table{t,
                 "parts of the canvas, by the colours of `canvas.file`; pieces stay within their region",
                 {required(column(t, "name", name, "", 0, 0, "its name in [[shapes]]")),
                  required(column(t, "colour", colour, "", 0, 0, of_the_file))}};
  table.columns.push_back(column(t, "background", colour, "", 0, 0,
                                 "what pictures show beneath the pieces there, instead of output.background"));
  table.columns.back().decides = false;
  add_poses(table, " there");
  return table;
}

JobTable given_table() {
  using enum JobKind;
  const std::string t = "given";
  const std::string middle = "the centre of its area, from the canvas' upper left corner";
  return {t,
          "pieces that stand where you put them, before any other is placed",
          {required(column(t, "shape", name, "", 0, 0, "name of a shape of the library")),
           required(column(t, "at_px", point, "px", -20000, 40000, middle)),
           required(column(t, "scale_px", number, "px", 2, 20000, "its size: the square root of its area")),
           column(t, "rotation_deg", number, "degrees", -360, 360, "clockwise; default 0")}};
}

JobTable keep_out_table() {
  using enum JobKind;
  const std::string t = "keep_out";
  return {t,
          "rectangles that stay free of pieces",
          {required(column(t, "at_px", point, "px", -20000, 40000, "its centre, from the canvas' upper left corner")),
           required(column(t, "size_px", point, "px", 1, 20000, "its width and height")),
           column(t, "rotation_deg", number, "degrees", -360, 360, "clockwise; default 0"),
           column(t, "corner_px", number, "px", 0, 20000,
                  "radius of its corners; half the shorter side or more: round ends; default 0")}};
}

}  // namespace

const std::vector<JobTable>& job_tables() {
  static const std::vector<JobTable> tables = {shapes_table(), regions_table(), given_table(), keep_out_table()};
  return tables;
}

const JobTable* find_job_table(const std::string& name) {
  const auto& tables = job_tables();
  const auto at = std::find_if(tables.begin(), tables.end(), [&](const JobTable& t) { return t.name == name; });
  return at == tables.end() ? nullptr : &*at;
}

const JobKey* find_column(const JobTable& table, const std::string& name) {
  const auto at =
      std::find_if(table.columns.begin(), table.columns.end(), [&](const JobKey& key) { return key.name == name; });
  return at == table.columns.end() ? nullptr : &*at;
}

const std::vector<JobRow>& rows_of(const Job& job, const std::string& table) {
  static const std::vector<JobRow> none;
  const auto rows = job.tables.find(table);
  return rows == job.tables.end() ? none : rows->second;
}

std::string table_to_toml(const JobTable& table, const Job& job) {
  std::string text;
  for (const JobRow& row : rows_of(job, table.name)) {
    text += "\n[[" + table.name + "]]\n";
    for (const JobKey& column : table.columns) {
      const auto cell = row.find(column.name);
      if (cell != row.end()) text += column.name + " = " + cell_to_toml(column, cell->second) + "\n";
    }
  }
  return text;
}

}  // namespace tessera
