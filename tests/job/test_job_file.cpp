// The job file: what it accepts, and every kind of mistake.
#include <filesystem>
#include <numbers>

#include "job/job_keys.h"
#include "job_file_fixture.h"

namespace tessera {
namespace test_job_file {

TEST_F(JobFile, needs_nothing_but_a_library) {
  const Job job = load(minimal_);
  EXPECT_EQ(job.library, folder_.path("animals.h5"));
  EXPECT_EQ(job.canvas.width_px, 1000);
  EXPECT_EQ(job.canvas.file, "");
  EXPECT_EQ(job.devices, "all");
  EXPECT_EQ(job.settings.seed, CollageSettings().seed);
  EXPECT_EQ(job.settings.match.pad, PadParameters());
}

TEST_F(JobFile, reads_every_key) {
  const Job job = load(R"(
    seed = 42
    [library]
    file = "/data/birds.h5"
    [canvas]
    size_px = [640, 480]
    file = "../mask.png"
    [pieces]
    scale_px = [14, 180.5]
    rotation_deg = [-90, 45]
    uses = 3
    balance = 0.75
    padding_px = 1.5
    [match]
    levels = 4
    delta_tau = 0.25
    top_percent = 5
    beta = 0.4
    tangent_dockings = 0
    delta_px = 3
    [objective]
    kind = "paper"
    overlap_weight = 1
    gap_weight = 2
    length_exponent = 1
    scale_exponent = 1.5
    repetition_exponent = 0
    near_twin_factor = 1
    [stop]
    pieces = 100
    coverage = 0.8
    seconds = 2.5
    [devices]
    use = [2, 0]
    [output]
    width_px = 640
    background = "#FFeedd"
  )");
  EXPECT_EQ(job.settings.seed, 42u);
  EXPECT_EQ(job.library, "/data/birds.h5");
  EXPECT_EQ(job.canvas.width_px, 640);
  EXPECT_EQ(job.canvas.height_px, 480);
  EXPECT_EQ(job.canvas.file, std::filesystem::path(folder_.path("../mask.png")).lexically_normal());
  EXPECT_EQ(job.settings.pieces.min_scale_px, 14);
  EXPECT_EQ(job.settings.pieces.max_scale_px, 180.5f);
  EXPECT_FLOAT_EQ(job.settings.pieces.min_rotation_rad, -std::numbers::pi_v<float> / 2);
  EXPECT_FLOAT_EQ(job.settings.pieces.max_rotation_rad, std::numbers::pi_v<float> / 4);
  EXPECT_EQ(job.settings.pieces.uses, 3);
  EXPECT_EQ(job.settings.objective.balance, 0.75f);
  EXPECT_EQ(job.settings.pieces.padding_px, 1.5f);
  EXPECT_EQ(job.settings.match.pad, (PadParameters{4, 0.25f}));
  EXPECT_EQ(job.settings.match.top_percent, 5);
  EXPECT_EQ(job.settings.match.beta, 0.4f);
  EXPECT_EQ(job.settings.match.tangent_dockings, 0);
  EXPECT_EQ(job.settings.match.delta_px, 3);
  EXPECT_EQ(job.settings.objective.kind, Objective::paper);
  EXPECT_EQ(job.settings.objective.overlap_weight, 1);
  EXPECT_EQ(job.settings.objective.gap_weight, 2);
  EXPECT_EQ(job.settings.objective.length_exponent, 1);
  EXPECT_EQ(job.settings.objective.scale_exponent, 1.5f);
  EXPECT_EQ(job.settings.objective.repetition_exponent, 0);
  EXPECT_EQ(job.settings.objective.near_twin_factor, 1);
  EXPECT_EQ(job.settings.stop.pieces, 100);
  EXPECT_EQ(job.settings.stop.coverage, 0.8f);
  EXPECT_EQ(job.settings.stop.seconds, 2.5);
  EXPECT_EQ(job.devices, "2,0");
  EXPECT_EQ(job.output.width_px, 640);
  EXPECT_EQ(job.output.background, "#ffeedd");
}

TEST_F(JobFile, names_line_key_found_and_allowed) {
  EXPECT_EQ(mistake(minimal_ + "[pieces]\nscale_px = [180, 14]\n"),
            "job.toml:4: pieces.scale_px: found [ 180, 14 ], allowed: one value, [min, max] with the smaller one "
            "first, a list of three "
            "values or more, or a list of [min, max], from 2 to 5000 px");
  EXPECT_EQ(mistake("seed = -1"), "job.toml:1: seed: found -1, allowed: a whole number from 0 to 9007199254740991");
  EXPECT_EQ(mistake("[objective]\nkind = \"papre\""),
            "job.toml:2: objective.kind: found \"papre\", allowed: \"scale_aware\" or \"paper\"");
}

TEST_F(JobFile, names_the_nearest_key) {
  EXPECT_EQ(
      mistake("[pieces]\n\nscale = [20, 160]"),
      "job.toml:3: unknown key pieces.scale (did you mean pieces.scale_px?); allowed in [pieces]: scale_px, "
      "sizes, size_map, rotation_deg, mirrored, uses, fit, least_scale_px, balance, padding_px, apart_px, overlap_px");
  EXPECT_EQ(mistake("[checkpoint]\nuses = 3"),
            "job.toml:2: unknown key checkpoint.uses (did you mean pieces.uses?); "
            "allowed in [checkpoint]: every_s");
  EXPECT_EQ(mistake("uses = 3"),
            "job.toml:1: unknown key uses (did you mean pieces.uses?); allowed at top level: seed, quality");
  EXPECT_EQ(mistake("[piece]\nuses = 3"),
            "job.toml:2: unknown section [piece] (did you mean [pieces]?); allowed: library, canvas, pieces, start, "
            "match, objective, improve, stop, deform, checkpoint, comm, colour, style, devices, output, [[shapes]], "
            "[[regions]], "
            "[[given]], [[keep_out]]");
  EXPECT_EQ(mistake("[stop]\nzzzzzzzzz = 3"),
            "job.toml:2: unknown key stop.zzzzzzzzz; allowed in [stop]: pieces, coverage, seconds");
}

TEST_F(JobFile, reports_the_first_line_first) {
  EXPECT_EQ(mistake("[stop]\npieces = -1\n[canvas]\nsize_px = 3\n").substr(0, 11), "job.toml:2:");
}

TEST_F(JobFile, tells_sections_from_keys) {
  EXPECT_EQ(mistake("pieces = 3"),
            "job.toml:1: pieces is a section with the keys scale_px, sizes, size_map, rotation_deg, mirrored, uses, "
            "fit, least_scale_px, balance, padding_px, apart_px, overlap_px, found 3");
  EXPECT_NE(mistake("[[pieces]]\nuses = 1").find("pieces is a section"), std::string::npos);
  EXPECT_NE(mistake("[seed]\nuses = 1").find("seed: found"), std::string::npos);
  EXPECT_NE(mistake("[nonsense]").find("unknown section [nonsense]"), std::string::npos);
}

TEST_F(JobFile, says_where_the_toml_is_broken) {
  EXPECT_EQ(mistake("seed = 1\nuses = = 2\n").substr(0, 21), "job.toml:2: not TOML:");
  EXPECT_EQ(mistake("seed = 1\nseed = 2\n").substr(0, 21), "job.toml:2: not TOML:");
  EXPECT_EQ(mistake("\xff\xfe = 1").substr(0, 21), "job.toml:1: not TOML:");
  EXPECT_EQ(mistake("a = " + std::string(5000, '[')).substr(0, 21), "job.toml:1: not TOML:");
}

TEST_F(JobFile, says_that_texts_need_quotes) {
  const auto hints = [&](const std::string& text) {
    return mistake(text).find("; texts need quotes: ") != std::string::npos;
  };
  EXPECT_NE(mistake("seed = 1\n[pieces]\nfit = all\n").find("; texts need quotes: \"all\""), std::string::npos);
  EXPECT_TRUE(hints("[output]\nbackground = none"));
  EXPECT_TRUE(hints("[canvas]\nfile = ../heart.svg"));
  EXPECT_TRUE(hints("[canvas]\nfile = /heart.svg"));
  EXPECT_FALSE(hints("seed = 1\nseed = 2\n"));
  EXPECT_FALSE(hints("seed = \n"));
  EXPECT_FALSE(hints("seed"));
}

TEST_F(JobFile, misses_the_library) {
  EXPECT_EQ(mistake("seed = 1"),
            "job.toml: library.file is missing; needed: the library of shapes, made by `tessera library build`");
  EXPECT_NE(mistake("[library]\nfile = \"\"").find("library.file is missing"), std::string::npos);
}

TEST_F(JobFile, survives_deep_keys_and_endless_files) {
  std::string deep;
  for (int i = 0; i < 8000; ++i) deep += "a.";
  EXPECT_NE(mistake(deep + "a = 1").find("unknown section [a]"), std::string::npos);
  EXPECT_NE(mistake(std::string((1 << 20) + 1, ' ')).find("2 MiB, more than the 1 MiB allowed"), std::string::npos);
  EXPECT_THROW(load_job("/dev/zero", {}), InputError);
  EXPECT_THROW(load_job(folder_.path("missing.toml"), {}), InputError);
  EXPECT_THROW(load_job(folder_.path(""), {}), InputError);
}

TEST_F(JobFile, shows_hostile_text_in_one_short_line) {
  const std::string message = mistake("\"new\\nline" + std::string(10000, 'x') + "\" = 1");
  EXPECT_EQ(message.find('\n'), std::string::npos);
  EXPECT_LT(message.size(), 200u);
  EXPECT_LT(mistake("seed = \"" + std::string(10000, 'x') + "\"").size(), 200u);
}

TEST_F(JobFile, intervals_may_be_several_or_one_value) {
  using Pairs = std::vector<double>;
  const auto read = [&](const std::string& value) {
    const Job job = load(minimal_ + "[pieces]\nscale_px = " + value);
    return find_job_key("pieces", "scale_px")->get(job).numbers;
  };
  EXPECT_EQ(read("50"), (Pairs{50, 50}));
  EXPECT_EQ(read("[50]"), (Pairs{50, 50}));
  EXPECT_EQ(read("[20, 160]"), (Pairs{20, 160}));
  EXPECT_EQ(read("[20, 160, 40]"), (Pairs{20, 20, 160, 160, 40, 40}));
  EXPECT_EQ(read("[[20, 30], [80, 90]]"), (Pairs{20, 30, 80, 90}));
  EXPECT_EQ(read("[[20, 30], 80]"), (Pairs{20, 30, 80, 80}));
  const Job job = load(minimal_ + "[pieces]\nscale_px = [[20, 30], [60, 90]]");
  EXPECT_EQ(job.settings.pieces.min_scale_px, 20);
  EXPECT_EQ(job.settings.pieces.max_scale_px, 90);
}

TEST_F(JobFile, tables_come_any_number_of_times) {
  const Job job = load(minimal_ +
                       "[[shapes]]\nnames = 'owl'\nweight = 2\n"
                       "[[shapes]]\nnames = ['a*', 'b']\nuses = [1, 3]\n");
  ASSERT_EQ(job.tables.at("shapes").size(), 2u);
  EXPECT_EQ(job.tables.at("shapes")[0].at("names").texts, std::vector<std::string>{"owl"});
  EXPECT_EQ(job.tables.at("shapes")[0].at("weight").numbers, std::vector<double>{2});
  EXPECT_EQ(job.tables.at("shapes")[1].at("uses").numbers, (std::vector<double>{1, 3}));
}

TEST_F(JobFile, mistakes_in_tables_name_line_key_found_and_allowed) {
  EXPECT_EQ(mistake(minimal_ + "[[shapes]]\nname = 'owl'"),
            "job.toml:4: unknown key name (did you mean names?); allowed in [[shapes]]: names, weight, uses, scale_px, "
            "rotation_deg, mirrored, regions, apart_px, deform, group");
  EXPECT_EQ(mistake(minimal_ + "[[shapes]]\nweight = 2"),
            "job.toml:3: names is missing in [[shapes]]; needed: patterns of names, as in "
            "library.include");
  EXPECT_EQ(mistake(minimal_ + "[[shapes]]\nnames = 'a'\nweight = -1"),
            "job.toml:5: [[shapes]] weight: found -1, allowed: a number from 0 to 100");
  EXPECT_EQ(mistake(minimal_ + "[[shapes]]\nnames = []").substr(0, 55),
            "job.toml:4: [[shapes]] names: found [], allowed: a text");
  EXPECT_EQ(mistake(minimal_ + "[shapes]\nnames = 'a'"),
            "job.toml:4: [shapes] is a table that may come several times; allowed: [[shapes]], with two brackets on "
            "each side");
  EXPECT_EQ(mistake("shapes = 3\n" + minimal_),
            "job.toml:1: shapes: found 3, allowed: tables that begin with [[shapes]]");
  EXPECT_NE(mistake(minimal_ + "[[shape]]\nnames = 'a'").find("unknown tables [[shape]] (did you mean [[shapes]]?)"),
            std::string::npos);
}

TEST_F(JobFile, lists_of_texts_and_paths) {
  const Job job = load(
      "[library]\nfiles = [\"a.h5\", \"../b.h5\"]\n"
      "include = [\"cat*\", \"*\\\"dog\\\"*\"]\nexclude = \"x\"");
  EXPECT_EQ(job.library, "");
  EXPECT_EQ(job.library_files,
            (std::vector<std::string>{folder_.path("a.h5"),
                                      std::filesystem::path(folder_.path("../b.h5")).lexically_normal()}));
  EXPECT_EQ(job.library_include, (std::vector<std::string>{"cat*", "*\"dog\"*"}));
  EXPECT_EQ(job.library_exclude, std::vector<std::string>{"x"});
  EXPECT_NE(to_toml(job).find("file = \"\"\n"), std::string::npos) << to_toml(job);
  EXPECT_NE(to_toml(job).find("exclude = [\"x\"]\n"), std::string::npos) << to_toml(job);
  const Job overridden = load(to_toml(job), {"library.include=*a*", "library.exclude=", "library.files=[\"y.h5\"]"});
  EXPECT_EQ(overridden.library_include, std::vector<std::string>{"*a*"});
  EXPECT_TRUE(overridden.library_exclude.empty());
  EXPECT_EQ(overridden.library_files, std::vector<std::string>{std::filesystem::current_path() / "y.h5"});
}

TEST_F(JobFile, lists_hold_texts_alone) {
  for (const char* value : {"1", "[1]", "[\"a\", 2]", "[[\"a\"]]", "[\"\"]", "\"a\\u0000\"", "{a = \"b\"}"}) {
    EXPECT_EQ(mistake("[library]\nfile = \"a.h5\"\ninclude = " + std::string(value)).substr(0, 35),
              "job.toml:3: library.include: found ")
        << value;
  }
  EXPECT_NE(mistake(minimal_ + "include = [1]").find("allowed: a text, or a list of texts"), std::string::npos);
}

TEST_F(JobFile, takes_one_library_or_a_list) {
  EXPECT_EQ(mistake(minimal_ + "files = [\"b.h5\"]"),
            "job.toml: library.file and library.files: both are given; allowed: one of them, the other empty");
  EXPECT_EQ(load(minimal_, {"library.file=", "library.files=b.h5"}).library, "");
  EXPECT_EQ(mistake("[library]\nfiles = []").substr(0, 34), "job.toml: library.file is missing;");
}

TEST_F(JobFile, reads_zones_to_keep_out_of) {
  const Job job = load(minimal_ +
                       "[canvas]\nkeep_out = \"zoo.svg\"\n"
                       "[[keep_out]]\nat_px = [500, 480]\nsize_px = [300, 100]\n"
                       "rotation_deg = 90\ncorner_px = 12\n"
                       "[[keep_out]]\nat_px = [1, 2]\nsize_px = [30, 10]\n");
  EXPECT_EQ(job.canvas.keep_out, folder_.path("zoo.svg"));
  ASSERT_EQ(job.canvas.keep_out_rectangles.size(), 2u);
  const KeepOutRectangle& zone = job.canvas.keep_out_rectangles[0];
  EXPECT_EQ(zone.middle_px, (Vec2{500, 480}));
  EXPECT_EQ(zone.half_size_px, (Vec2{150, 50}));
  EXPECT_NEAR(zone.across.x, 0, 1e-6);
  EXPECT_NEAR(zone.across.y, 1, 1e-6) << "clockwise, y being down";
  EXPECT_EQ(zone.corner_px, 12);
  EXPECT_EQ(job.canvas.keep_out_rectangles[1].across, (Vec2{1, 0}));
  EXPECT_EQ(job.canvas.keep_out_rectangles[1].corner_px, 0);
  EXPECT_EQ(job_from_toml(to_toml(job), "job.toml").canvas.keep_out_rectangles.size(), 2u);
}

TEST_F(JobFile, reads_where_to_start_from) {
  const Job job = load(minimal_ + "[start]\npieces = \"../out/old\"\nkeep = \"free\"\ngrow = \"outward\"\n");
  EXPECT_EQ(job.start.pieces, (std::filesystem::path(folder_.path("")) / "../out/old").lexically_normal().string());
  EXPECT_EQ(job.start.keep, StartKeep::free);
  EXPECT_TRUE(job.settings.start.grow_outward);
  const Job plain = load(minimal_);
  EXPECT_TRUE(plain.start.pieces.empty());
  EXPECT_EQ(plain.start.keep, StartKeep::locked);
  EXPECT_FALSE(plain.settings.start.grow_outward);
}

TEST_F(JobFile, reads_which_pieces_go_and_which_are_locked) {
  const std::string start = minimal_ + "[start]\npieces = \"old\"\nkeep = \"standing\"\n";
  const Job job = load(start + "remove = [17, 3]\nlock = 5\nnot_anew = [\"a*b\"]\n");
  EXPECT_EQ(job.start.keep, StartKeep::standing);
  EXPECT_EQ(job.start.remove, (std::vector<int>{17, 3}));
  EXPECT_EQ(job.start.lock, std::vector<int>{5});
  const Job again = job_from_toml(to_toml(job), "job.toml");
  EXPECT_EQ(again.start.remove, job.start.remove);
  EXPECT_EQ(again.start.lock, job.start.lock);
  EXPECT_EQ(again.start.not_anew, std::vector<std::string>{"a*b"});
  EXPECT_TRUE(load(start + "remove = []\n").start.remove.empty());
  const std::string allowed = ", allowed: a list of distinct whole numbers from 0 to 99999";
  for (const std::string wrong : {"[3, 3]", "[-1]", "[100000]", "[0.5]", "\"a\"", "true"}) {
    const std::string said = mistake(start + "remove = " + wrong + "\n");
    EXPECT_NE(said.find("start.remove"), std::string::npos) << said;
    EXPECT_NE(said.find(allowed), std::string::npos) << said;
  }
  EXPECT_EQ(mistake(minimal_ + "[start]\nremove = [1]\n"),
            "job.toml: start.remove: found pieces, allowed without start.pieces: []");
  EXPECT_EQ(mistake(start + "remove = [1, 2]\nlock = [2]\n"),
            "job.toml: start.lock: found 2, which start.remove has, too");
  EXPECT_EQ(mistake(minimal_ + "[start]\npieces = \"old\"\nkeep = \"free\"\nremove = [1]\n"),
            "job.toml: start.remove: found with start.keep = \"free\", allowed: \"standing\" or \"locked\"");
}

TEST_F(JobFile, what_has_no_edges_does_not_grow_outward) {
  EXPECT_EQ(mistake(minimal_ + "[canvas]\nseamless = \"x\"\n[start]\ngrow = \"outward\"\n"),
            "job.toml: start.grow: found \"outward\" with canvas.seamless, allowed with it: \"inward\"");
}

}  // namespace test_job_file
}  // namespace tessera
