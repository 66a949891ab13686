// Several libraries as one, chosen shapes, and copies of them: the same shapes with the same digests, each once.
#include <gtest/gtest.h>
#include <hdf5.h>

#include <filesystem>
#include <set>

#include "core/base/error.h"
#include "job/pieces/job_library.h"
#include "library/library_copy.h"
#include "library/library_view.h"
#include "support/colours.h"
#include "support/input_error.h"
#include "support/random_shape.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_library_view {

using test::message_of;
using test::RandomShape;

using Variants = std::vector<std::uint32_t>;

const LibraryParts kEverything{
    .outline = true, .field = true, .levels = ~0u, .artwork = true, .original = true, .surroundings = true};

/// A shape whose silhouette follows from the seed.
Shape make_shape(const std::string& name, std::uint64_t seed, float lightness = 50) {
  Shape shape = RandomShape(seed, 5).make();
  shape.name = name;
  shape.mean_lab = {lightness, 0, 0};
  shape.artwork.path = "/drawings/" + name + ".svg";
  return shape;
}

class LibraryViews : public testing::Test {
 protected:
  std::string write(const std::string& name, const std::vector<Shape>& shapes, const PadParameters& pad = {},
                    const Variants& variant_of = {}, const std::vector<float>& palettes = {}) const {
    LibraryWriter writer(folder_.path(name), pad);
    for (std::size_t i = 0; i < shapes.size(); ++i)
      writer.append(shapes[i], variant_of.empty() ? std::uint32_t(i) : variant_of[i],
                    palettes.empty() ? StyleFeatures{} : StyleFeatures{.palette = palettes[i]});
    writer.finish();
    return folder_.path(name);
  }

  std::string copied(const ShapeLibrary& library, const std::string& name) const {
    copy_library(library, folder_.path(name), [](std::size_t) {});
    return folder_.path(name);
  }

  static std::vector<std::string> names(const ShapeLibrary& library) {
    std::vector<std::string> names;
    for (const Shape& shape : library.read(0, library.size(), kEverything)) names.push_back(shape.name);
    return names;
  }

  test::ScratchFolder folder_;
  const std::vector<Shape> animals_{make_shape("cat", 1), make_shape("cow", 2), make_shape("dog", 3),
                                    make_shape("Cat", 4)};
};

using Names = std::vector<std::string>;

TEST_F(LibraryViews, OfOneWholeFileIsTheFile) {
  const std::string path = write("a.h5", animals_);
  const LibraryFile file(path);
  const LibraryView view({{path}, {}});
  EXPECT_EQ(view.size(), 4u);
  EXPECT_EQ(view.path(), path);
  EXPECT_EQ(view.content_digest(), file.content_digest());
  EXPECT_EQ(names(view), names(file));
  EXPECT_EQ(LibraryView({{path}, {{"*"}, {}}}).content_digest(), file.content_digest());
}

/// A library that is built again, now with sizes, still draws the collages made from it before.
TEST_F(LibraryViews, DrawnSizesCountInTheDigestOnlyForThoseWhoUseThem) {
  std::vector<Shape> drawn = animals_;
  const auto digests = [&](bool drawn_sizes) {
    std::set<std::uint64_t> all;
    for (const float scale_px : {0.f, 30.f, 31.f}) {
      drawn[1].drawn_scale_px = scale_px;
      const std::string path = write("a.h5", drawn);
      for (const NameGlobs& names : {NameGlobs{}, NameGlobs{{"*"}, {}}})
        all.insert(LibraryView({{path}, names, {}, drawn_sizes}).content_digest());
    }
    return all.size();
  };
  EXPECT_EQ(digests(false), 1u);
  EXPECT_EQ(digests(true), 3u);
}

TEST_F(LibraryViews, JobsWithDrawnSizesTellThemApart) {
  Job job;
  job.library = write("a.h5", animals_);
  const std::uint64_t any_sizes = open_library_of(job).content_digest();
  EXPECT_EQ(any_sizes, LibraryFile(job.library).content_digest());
  job.drawn_sizes = true;
  EXPECT_NE(open_library_of(job).content_digest(), any_sizes);
}

TEST_F(LibraryViews, ChooseByColour) {
  std::vector<Shape> drawn = animals_;
  const Lab red{53, 80, 67}, dark_red{45, 72, 58}, blue{32, 79, -108}, white{100, 0, 0};
  drawn[0].colour_grid = test::two_toned_grid(red, red);
  drawn[1].colour_grid = test::two_toned_grid(red, white);
  drawn[2].colour_grid = test::two_toned_grid(dark_red, dark_red);
  drawn[3].colour_grid = test::two_toned_grid(blue, blue);
  const std::string path = write("a.h5", drawn);
  Job job;
  job.path = "job.toml";
  job.library = path;
  const auto chosen = [&](const std::vector<std::string>& colours, double within) {
    job.library_colours = colours;
    job.library_colours_within = within;
    return names(open_library_of(job));
  };
  EXPECT_EQ(chosen({"all"}, 3), (Names{"cat", "cow", "dog", "Cat"}));
  EXPECT_EQ(chosen({"#ff0000"}, 3), (Names{"cat"}));
  EXPECT_EQ(chosen({"#ff0000"}, 15), (Names{"cat", "dog"}));
  EXPECT_EQ(chosen({"#ff0000", "#ffffff"}, 3), (Names{"cat", "cow"}));
  EXPECT_EQ(chosen({"#ff0000", "#0000ff"}, 3), (Names{"cat", "Cat"}));
  job.library_include = {"c*"};
  EXPECT_EQ(chosen({"#ff0000", "#0000ff"}, 3), (Names{"cat"})) << "both choices hold";
  EXPECT_NE(
      message_of([&] { chosen({"#00ff00"}, 5); })
          .find("job.toml: library.colours: no drawing that is chosen is within 5.0 CIEDE2000 of these colours; the "
                "nearest is at "),
      std::string::npos);
  job.library_include = {"Cat"};
  EXPECT_EQ(message_of([&] { chosen({"#ff0000"}, 3); }).find("nearest is at 0."), std::string::npos)
      << "red ones are there, but not chosen";
  drawn[0].colour_grid = {};
  job.library = write("b.h5", drawn);
  EXPECT_EQ(chosen({"#0000ff"}, 3), (Names{"Cat"})) << "who is not chosen need not have colours";
  job.library_include.clear();
  job.library = write("old.h5", drawn);
  EXPECT_NE(message_of([&] { chosen({"#ff0000"}, 5); }).find("build it again"), std::string::npos);
}

TEST_F(LibraryViews, StylesCountInTheDigestOnlyForThoseWhoUseThem) {
  const std::string old = write("a.h5", animals_), other = write("b.h5", animals_, {}, {}, {1, 2, 3, 4});
  const auto digest = [](const std::string& path, bool styles) {
    return LibraryView({.files = {path}, .names = {}, .styles = styles}).content_digest();
  };
  EXPECT_EQ(digest(old, false), digest(other, false));
  EXPECT_NE(digest(old, true), digest(other, true));
  Job job;
  job.library = other;
  EXPECT_EQ(open_library_of(job).content_digest(), digest(other, false));
  job.style.like = {"cat"};
  EXPECT_EQ(open_library_of(job).content_digest(), digest(other, true));
  job.style.weight = 0;
  EXPECT_EQ(open_library_of(job).content_digest(), digest(other, false));
}

/// Styles that differ in bits of the palette; each bit is a style distance of 1.
TEST_F(LibraryViews, ChooseByStyle) {
  const std::string path = write("a.h5", animals_, {}, {}, {1, 5, 2.5f, 1.25f});
  const auto chosen = [&](const StyleChoice& style, const NameGlobs& globs = {}) {
    return names(LibraryView({.files = {path}, .names = globs, .style = style}));
  };
  EXPECT_EQ(chosen({{"cat"}, 1, {}}), (Names{"cat"}));
  EXPECT_EQ(chosen({{"cat"}, 2, {}}), (Names{"cat", "Cat"}));
  EXPECT_EQ(chosen({{"cat"}, {}, 2.f}), (Names{"cat", "dog", "Cat"}));
  EXPECT_EQ(chosen({{"cat"}, 3, 1.f}), (Names{"cat", "Cat"})) << "both limits hold";
  EXPECT_EQ(chosen({{"c?w", "cat"}, 1, {}}), (Names{"dog"})) << "nearest to the mean of both";
  EXPECT_EQ(chosen({{"cat"}, 1, {}}, {{"c*"}, {"cat"}}), (Names{"cow"})) << "of those that are chosen by name";
  EXPECT_EQ(chosen({{"auto"}, 9, {}}), (Names{"cat", "cow", "dog", "Cat"}));
  EXPECT_NE(message_of([&] {
              chosen({{"cat"}, {}, 1.f}, {{"cow"}, {}});
            }).find("no drawing that is chosen is within 1.00 of the style of cat; the nearest is at 4.00"),
            std::string::npos);
  EXPECT_NE(message_of([&] { chosen({{"Cow"}, 1, {}}); }).find("near it are: cow"), std::string::npos);
  const std::string old = write("old.h5", animals_);
  EXPECT_NE(message_of([&] {
              names(LibraryView({.files = {old}, .names = {}, .style = {{"cat"}, 1, {}}}));
            }).find("does not know the style of cat, because an older version built it; build it again"),
            std::string::npos);
}

TEST_F(LibraryViews, StylesGoAlongIntoCopiesAndMirrorImages) {
  const std::string path = write("a.h5", animals_, {}, {}, {1, 2, 3, 4});
  const LibraryView view({{path}, {{"c*"}, {}}, {{{"*"}, Mirroring::also}}});
  ASSERT_EQ(view.size(), 4u);
  EXPECT_EQ(view.styles()[3].palette, 2);
  EXPECT_EQ(LibraryFile(copied(view, "copy.h5")).styles(), view.styles());
}

TEST_F(LibraryViews, ChooseByName) {
  const std::string path = write("a.h5", animals_);
  EXPECT_EQ(names(LibraryView({{path}, {{"c*"}, {}}})), (Names{"cat", "cow"}));
  EXPECT_EQ(names(LibraryView({{path}, {{"d?g", "[cC]at"}, {}}})), (Names{"cat", "dog", "Cat"}));
  EXPECT_EQ(names(LibraryView({{path}, {{}, {"c*", "x*"}}})), (Names{"dog", "Cat"}));
  EXPECT_EQ(names(LibraryView({{path}, {{"?at"}, {"C*"}}})), (Names{"cat"}));
  const LibraryView two({{path}, {{"cat", "dog"}, {}}});
  EXPECT_NE(two.content_digest(), LibraryView({{path}, {{"cat", "cow"}, {}}}).content_digest());
  EXPECT_EQ(two.read(1, 9, kEverything).at(0).outline, animals_[2].outline);
  EXPECT_EQ(two.read(1, 9, kEverything).size(), 1u);
}

TEST_F(LibraryViews, SayWhatNamesAreNear) {
  const std::string path = write("a.h5", animals_);
  EXPECT_EQ(message_of([&] {
              LibraryView({{path}, {{"cat", "DOG*"}, {}}});
            }),
            "include: no shape of " + path + " has a name like \"DOG*\"; near it are: dog, Cat, cat, cow");
  const std::string many =
      write("many.h5", {make_shape("emu", 5), make_shape("snowy_owl_3", 6), make_shape("owl_of_night", 7),
                        make_shape("hen", 8), make_shape("ox", 9), make_shape("yak", 10)});
  const auto near = [&](const std::string& glob) {
    const std::string said = message_of([&] { LibraryView({{many}, {{glob}, {}}}); });
    return said.substr(said.find("near it are: ") + 13);
  };
  EXPECT_EQ(near("owll*").substr(0, 12), "owl_of_night") << near("owll*");
  EXPECT_EQ(near("*_owll_?").substr(0, 11), "snowy_owl_3") << near("*_owll_?");
  EXPECT_EQ(near("[kx]ak").substr(0, 3), "yak") << near("[kx]ak");
  EXPECT_EQ(message_of([&] {
              LibraryView({{path}, {{}, {"*"}}});
            }),
            "exclude: nothing is left of the 4 shapes of " + path);
}

/// As a pattern, "logo [final]" would match "logo f" and "logo i".
TEST_F(LibraryViews, TheNameOfAShapeThatWasLeftOutSelectsNoOther) {
  const std::string path =
      write("logos.h5", {make_shape("logo [final]", 1), make_shape("logo f", 2), make_shape("logo i", 3)});
  const std::vector<MirroringRule> rules{{{"logo [final]"}, Mirroring::also}};
  EXPECT_EQ(names(LibraryView({{path}, {}, rules})), (Names{"logo [final]", "logo f", "logo i", "logo [final]"}));
  const LibraryView view({{path}, {{}, {"logo [final]"}}, rules});
  EXPECT_EQ(names(view), (Names{"logo f", "logo i"}));
  Job job = load_job(folder_.write("job.toml",
                                   "[library]\nfile = 'logos.h5'\nexclude = 'logo [final]'\n[pieces]\n"
                                   "scale_px = [30, 50]\n[[shapes]]\nnames = ['logo [final]', 'logo*']\n"),
                     {});
  EXPECT_EQ(names_like_patterns(view, job), (Names{"logo [final]"}));
  EXPECT_NE(message_of([&] { resolve_wishes(view, job); }).find("has a name like \"logo [final]\""), std::string::npos);
}

TEST_F(LibraryViews, JoinFilesInOrderAndLeaveTwinsOut) {
  const std::string a = write("a.h5", animals_);
  const std::string b = write(
      "b.h5", {make_shape("hen", 5), make_shape("kitty", 1, 52), make_shape("cow", 6), make_shape("pale", 1, 90)});
  const LibraryView view({{a, b}, {}});
  EXPECT_EQ(names(view), (Names{"cat", "cow", "dog", "Cat", "hen", "cow (drawings)", "pale"}));
  ASSERT_EQ(view.twins().size(), 1u);
  EXPECT_EQ(view.twins()[0].path + " " + view.twins()[0].name + " " + view.twins()[0].kept, b + " kitty cat");
  EXPECT_EQ(view.variant_of(), (Variants{0, 1, 2, 3, 4, 5, 0}));
  EXPECT_EQ(view.path(), a + ", " + b);
  const std::vector<Shape> across = view.read(3, 6, kEverything);
  EXPECT_EQ(across[0].outline, animals_[3].outline);
  EXPECT_EQ(across[1].outline, make_shape("hen", 5).outline);
  EXPECT_EQ(across[2].outline, make_shape("cow", 6).outline);
  EXPECT_NE(view.content_digest(), LibraryView({{b, a}, {}}).content_digest());
}

TEST_F(LibraryViews, ChoosePatternsInAllFiles) {
  const std::string a = write("a.h5", animals_), b = write("b.h5", {make_shape("hen", 5), make_shape("cow", 6)});
  EXPECT_EQ(names(LibraryView({{a, b}, {{"hen", "dog"}, {}}})), (Names{"dog", "hen"}));
}

TEST_F(LibraryViews, KeepVariantsOfWhatIsNotChosen) {
  const std::string path = write(
      "a.h5", {make_shape("red", 1, 10), make_shape("dog", 2), make_shape("blue", 1, 40), make_shape("green", 1, 70)},
      {}, {0, 1, 0, 0});
  EXPECT_EQ(LibraryFile(path).variant_of(), (Variants{0, 1, 0, 0}));
  EXPECT_EQ(LibraryView({{path}, {}}).variant_of(), (Variants{0, 1, 0, 0}));
  EXPECT_EQ(LibraryView({{path}, {{}, {"red"}}}).variant_of(), (Variants{0, 1, 1}));
}

/// The columns are copied, so rounded values are not rounded again.
TEST_F(LibraryViews, AreCopiedToTheBit) {
  std::vector<Shape> many;
  Variants variant_of;
  for (std::uint32_t i = 0; i < 40; ++i) {
    many.push_back(make_shape("shape " + std::to_string(i), i / 2, i % 2 ? 20 : 80));
    variant_of.push_back(i / 2 * 2);
  }
  const std::string a = write("a.h5", many, {}, variant_of), b = write("b.h5", animals_);
  for (const LibraryChoice& choice :
       {LibraryChoice{{a}, {}}, LibraryChoice{{a}, {{"*[37]"}, {}}}, LibraryChoice{{b, a}, {}}}) {
    const LibraryView view(choice);
    const LibraryFile copy(copied(view, "copy.h5"));
    EXPECT_EQ(copy.content_digest(), view.content_digest());
    EXPECT_EQ(copy.variant_of(), view.variant_of());
    EXPECT_EQ(names(copy), names(view));
    const std::vector<Shape> from = view.read(0, view.size(), kEverything), to = copy.read(0, copy.size(), kEverything);
    for (std::size_t i = 0; i < from.size(); ++i) {
      EXPECT_EQ(from[i].field.distance.data(), to[i].field.distance.data());
      EXPECT_EQ(from[i].artwork.path, to[i].artwork.path);
      EXPECT_EQ(from[i].artwork.sha256, to[i].artwork.sha256);
      EXPECT_EQ(from[i].artwork.thumbnail_png, to[i].artwork.thumbnail_png);
      EXPECT_EQ(from[i].artwork.original, to[i].artwork.original);
    }
  }
}

TEST_F(LibraryViews, CopiesFindArtworkThatMovedWithItsLibrary) {
  Shape shape = make_shape("cat", 1);
  shape.artwork.path = folder_.path("old/art/cat.svg");
  std::filesystem::create_directories(folder_.path("old"));
  std::filesystem::create_directories(folder_.path("copies"));
  write("old/a.h5", {shape});
  std::filesystem::rename(folder_.path("old"), folder_.path("new"));
  const LibraryFile copy(copied(LibraryFile(folder_.path("new/a.h5")), "copies/copy.h5"));
  const Artwork artwork = copy.read(0, 1, kEverything)[0].artwork;
  EXPECT_EQ(artwork.path, folder_.path("old/art/cat.svg"));
  EXPECT_EQ(artwork.path_beside_library, folder_.path("new/art/cat.svg"));
}

LibraryChoice mirroring(const std::string& path, std::vector<MirroringRule> rules) { return {{path}, {}, rules}; }

TEST_F(LibraryViews, HaveMirrorImagesBehindTheirShapes) {
  const std::string path = write("a.h5", animals_, {}, {0, 1, 0, 3});
  const LibraryView view(mirroring(path, {{{"*"}, Mirroring::also}, {{"cow"}, Mirroring::never}}));
  EXPECT_EQ(names(view), (Names{"cat", "cow", "dog", "Cat", "cat", "dog", "Cat"}));
  EXPECT_EQ(view.drawings(), (Variants{0, 1, 2, 3, 0, 2, 3}));
  EXPECT_EQ(view.variant_of(), (Variants{0, 1, 0, 3, 0, 0, 3})) << "with the variants of their shapes";
  const std::vector<Shape> shapes = view.read(0, view.size(), kEverything);
  for (const std::size_t own : {4u, 5u, 6u}) {
    const Shape& shape = shapes[view.drawings()[own]];
    EXPECT_FALSE(shape.artwork.mirrored);
    EXPECT_TRUE(shapes[own].artwork.mirrored);
    EXPECT_EQ(shapes[own].outline.curves[0][0].x, -shape.outline.curves[0][0].x);
    EXPECT_EQ(shapes[own].artwork.path, shape.artwork.path);
  }
  EXPECT_EQ(view.read(5, 6, kEverything).at(0).outline, shapes[5].outline) << "one by one as all together";
}

TEST_F(LibraryViews, ShapesThatStandMirroredOnlyAreNotThereTwice) {
  const std::string path = write("a.h5", animals_);
  const LibraryView view(
      mirroring(path, {{{"*"}, Mirroring::never}, {{"c*", "dog"}, Mirroring::only}, {{"dog"}, Mirroring::never}}));
  EXPECT_EQ(names(view), (Names{"cat", "cow", "dog", "Cat"}));
  EXPECT_EQ(view.drawings(), (Variants{0, 1, 2, 3}));
  const std::vector<Shape> shapes = view.read(0, 4, kEverything);
  EXPECT_TRUE(shapes[1].artwork.mirrored);
  EXPECT_FALSE(shapes[2].artwork.mirrored) << "the last rule holds";
  EXPECT_FALSE(shapes[3].artwork.mirrored) << "no rule of its own";
}

TEST_F(LibraryViews, MirrorImagesCountInTheDigest) {
  const std::string path = write("a.h5", animals_);
  const auto digest = [&](std::vector<MirroringRule> rules) {
    return LibraryView(mirroring(path, std::move(rules))).content_digest();
  };
  const std::uint64_t plain = LibraryFile(path).content_digest();
  EXPECT_EQ(digest({{{"*"}, Mirroring::never}}), plain);
  EXPECT_EQ(digest({{{"nobody"}, Mirroring::also}}), plain);
  const std::uint64_t only_cat = digest({{{"cat"}, Mirroring::only}});
  EXPECT_NE(only_cat, plain);
  EXPECT_NE(digest({{{"cow"}, Mirroring::only}}), only_cat);
  EXPECT_NE(digest({{{"cat"}, Mirroring::also}}), digest({{{"cow"}, Mirroring::also}}));
}

TEST_F(LibraryViews, AreOfLibrariesBuiltAlike) {
  const std::string a = write("a.h5", animals_), b = write("b.h5", animals_, {5, 0.25f});
  EXPECT_EQ(message_of([&] {
              LibraryView({{a, b}, {}});
            }),
            b + ": built with --pad-levels 5 --delta-tau 0.250000, but " + a +
                " with --pad-levels 5 --delta-tau 0.200000; allowed: libraries built alike (tessera library build)");
}

TEST_F(LibraryViews, VariantsDecideAboutACollageAndCountInTheDigest) {
  const LibraryFile apart(write("a.h5", animals_)), family(write("b.h5", animals_, {}, {0, 0, 2, 3}));
  EXPECT_NE(apart.content_digest(), family.content_digest());
}

TEST_F(LibraryViews, OfOlderLibrariesKnowNoVariants) {
  const std::string path = write("a.h5", animals_, {}, {0, 0, 0, 0});
  const std::string apart = write("b.h5", animals_);
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  H5Ldelete(file, "/shapes/variant_of", H5P_DEFAULT);
  H5Fclose(file);
  EXPECT_EQ(LibraryFile(path).variant_of(), (Variants{0, 1, 2, 3}));
  EXPECT_EQ(LibraryFile(path).content_digest(), LibraryFile(apart).content_digest());
}

TEST_F(LibraryViews, RefuseAFamilyWithoutAHead) {
  for (const Variants& variants : {Variants{0, 0, 1, 3}, Variants{0, 2, 2, 3}}) {
    const std::string path = write("a.h5", animals_, {}, variants);
    EXPECT_NE(message_of([&] { (void)LibraryFile(path).variant_of(); }), "");
  }
}

}  // namespace test_library_view
}  // namespace tessera
