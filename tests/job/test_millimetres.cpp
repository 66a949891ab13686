// Lengths in mm: the keys that take them, their values in px, and every kind of mistake.
#include "job/millimetres.h"

#include "job_file_fixture.h"

namespace tessera {
namespace test_millimetres {

class Millimetres : public JobFile {
 protected:
  Job load(const std::string& text, const std::vector<std::string>& overrides = {}) const {
    return JobFile::load(minimal_ + text, overrides);
  }
  std::string mistake(const std::string& text, const std::vector<std::string>& overrides = {}) const {
    return JobFile::mistake(minimal_ + text, overrides);
  }

  const std::string poster_ = "[canvas]\nsize_mm = [600, 400]\nsize_px = [1200, 800]\n";
};

struct Length {
  std::string key;  // without its unit, after the text that must precede it
  std::string in_mm, in_px;
};

TEST_F(Millimetres, are_px_at_the_fineness_of_the_canvas) {
  const std::vector<Length> lengths = {{"[pieces]\nscale", "[[8, 12.5], 60]", "[[16, 25], 120]"},
                                       {"padding", "0.75", "1.5"},
                                       {"overlap", "0.5", "1"},
                                       {"[match]\ndelta", "2", "4"},
                                       {"[output]\noutline", "0.25", "0.5"},
                                       {"shadow_offset", "[-1, 2]", "[-2, 4]"},
                                       {"shadow_blur", "3", "6"},
                                       {"[[shapes]]\nnames = 'a'\nscale", "[10, 20]", "[20, 40]"},
                                       {"[[given]]\nshape = 'a'\nat", "[300, -5.5]", "[600, -11]"},
                                       {"scale", "7", "14"},
                                       {"[[keep_out]]\nat", "[100, 50]", "[200, 100]"},
                                       {"size", "[80.25, 20]", "[160.5, 40]"},
                                       {"corner", "5", "10"}};
  std::string text_in_mm = poster_, text_in_px = poster_;
  for (const Length& length : lengths) {
    text_in_mm += length.key + "_mm = " + length.in_mm + "\n";
    text_in_px += length.key + "_px = " + length.in_px + "\n";
  }
  const Job in_mm = load(text_in_mm);
  EXPECT_EQ(to_toml(in_mm), to_toml(load(text_in_px)));
  EXPECT_EQ(in_mm.settings.pieces.padding_px, 1.5f);
  EXPECT_EQ(to_toml(job_from_toml(to_toml(in_mm), "again.toml")), to_toml(in_mm));
}

TEST_F(Millimetres, without_px_the_longer_side_has_2000) {
  const Job wide = load("[canvas]\nsize_mm = [600, 400]\n[pieces]\nscale_mm = [9, 60]");
  EXPECT_EQ(wide.canvas.width_px, 2000);
  EXPECT_EQ(wide.canvas.height_px, 1333);
  EXPECT_FLOAT_EQ(wide.settings.pieces.min_scale_px, 30);
  const Job high = load("[canvas]\nsize_mm = [210, 297]");
  EXPECT_EQ(high.canvas.width_px, 1414);
  EXPECT_EQ(high.canvas.height_px, 2000);
}

TEST_F(Millimetres, may_stand_before_the_size_of_the_canvas) {
  EXPECT_EQ(load("[pieces]\npadding_mm = 2\n" + poster_).settings.pieces.padding_px, 4);
}

TEST_F(Millimetres, of_a_later_size_count) {
  const std::vector<std::string> finer{"canvas.size_px=[2400, 1600]"};
  EXPECT_EQ(load(poster_ + "[pieces]\npadding_mm = 2", finer).settings.pieces.padding_px, 8);
}

TEST_F(Millimetres, of_the_command_line_win_and_are_won_over) {
  const std::string in_mm = poster_ + "[pieces]\npadding_mm = 2", in_px = poster_ + "[pieces]\npadding_px = 2";
  EXPECT_EQ(load(in_px, {"pieces.padding_mm=3"}).settings.pieces.padding_px, 6);
  EXPECT_EQ(load(in_mm, {"pieces.padding_mm=3"}).settings.pieces.padding_px, 6);
  EXPECT_EQ(load(in_mm, {"pieces.padding_px=3"}).settings.pieces.padding_px, 3);
  EXPECT_EQ(load(in_mm, {"pieces.padding_px=3", "pieces.padding_mm=5"}).settings.pieces.padding_px, 10);
  EXPECT_EQ(load(in_mm, {"pieces.padding_mm=5", "pieces.padding_px=3"}).settings.pieces.padding_px, 3);
}

TEST_F(Millimetres, and_px_of_one_key_are_not_given_both) {
  EXPECT_EQ(mistake(poster_ + "[pieces]\nscale_px = [9, 60]\nscale_mm = [9, 60]"),
            "job.toml:8: pieces.scale_mm and pieces.scale_px: both are given; allowed: one of them");
  EXPECT_EQ(mistake(poster_ + "[[shapes]]\nnames = 'a'\nscale_px = 9\nscale_mm = 9"),
            "job.toml:9: [[shapes]] scale_mm and scale_px: both are given; allowed: one of them");
}

TEST_F(Millimetres, need_a_canvas_with_a_size_on_paper) {
  const std::string needed = "; needed: canvas.size_mm, the canvas' size on paper";
  EXPECT_EQ(mistake("[pieces]\nscale_mm = [9, 60]"), "job.toml:4: pieces.scale_mm: found [ 9, 60 ]" + needed);
  EXPECT_EQ(mistake("", {"pieces.padding_mm=1"}), "--set pieces.padding_mm=1: pieces.padding_mm: found 1" + needed);
  EXPECT_EQ(mistake("[[given]]\nshape = 'a'\nat_mm = [1, 2]\nscale_px = 3"),
            "job.toml:5: [[given]] at_mm: found [ 1, 2 ]" + needed);
}

TEST_F(Millimetres, are_allowed_as_far_as_the_px) {
  EXPECT_EQ(mistake(poster_ + "[pieces]\nscale_mm = [0.5, 60]"),
            "job.toml:7: pieces.scale_mm: found [ 0.5, 60 ], allowed: one value, [min, max] with the smaller one "
            "first, a list of three values or "
            "more, or a list of [min, max], from 1 to 2500 mm");
  EXPECT_EQ(mistake("[canvas]\nsize_mm = [600, 400]\n[pieces]\npadding_mm = 151"),
            "job.toml:6: pieces.padding_mm: found 151, allowed: a number from 0 to 150 mm");
  EXPECT_EQ(load(poster_ + "[pieces]\nscale_mm = [1, 2500]").settings.pieces.max_scale_px, 5000);
}

TEST_F(Millimetres, are_for_lengths_of_the_canvas_alone) {
  EXPECT_EQ(mistake(poster_ + "[match]\nlevels_mm = 3").substr(0, 40), "job.toml:7: unknown key match.levels_mm ");
  EXPECT_EQ(mistake("[output]\nwidth_mm = -1"),
            "job.toml:4: output.width_mm: found -1, allowed: a number from 0 to 20000 mm");
  EXPECT_EQ(load(poster_ + "[output]\nwidth_mm = 7").output.width_px, OutputSpec().width_px);
}

TEST_F(Millimetres, of_the_canvas_have_its_aspect_and_bounds) {
  EXPECT_EQ(mistake("[canvas]\nsize_mm = [600, 400]\nsize_px = [1000, 1000]"),
            "job.toml: canvas.size_px: found [1000, 1000], allowed with a canvas.size_mm of [600.000, 400.000]: "
            "the same aspect ratio, such as [1000, 667]");
  for (const char* size_px : {"[1000, 666]", "[1000, 667]", "[1000, 668]"}) {
    EXPECT_NO_THROW(load("[canvas]\nsize_mm = [600, 400]\nsize_px = " + std::string(size_px)));
  }
  EXPECT_EQ(mistake("[canvas]\nsize_mm = [20000, 10]"),
            "job.toml: canvas.size_mm: found [20000.000, 10.000], which makes [2000, 1] px; allowed: 16 px or more "
            "each, with a canvas.size_px");
  EXPECT_NO_THROW(load("[canvas]\nsize_mm = [0, 0]"));
  for (const char* size_mm :
       {"600", "[600]", "[600, 0]", "[0, 400]", "[-1, 1]", "[600, 2e4001]", "[1, 2, 3]", "[nan, 1]"}) {
    EXPECT_THROW(load("[canvas]\nsize_mm = " + std::string(size_mm)), InputError) << size_mm;
  }
}

/// The sizes are also known where a result is drawn.
TEST_F(Millimetres, are_known_of_a_result) {
  Job job = job_from_toml(to_toml(load(poster_)), "job.toml");
  set_drawing_keys(job, {"output.outline_mm=1.5"});
  EXPECT_EQ(job.output.outline_px, 3);
}

}  // namespace test_millimetres
}  // namespace tessera
