// The range of sizes in which a card judges the balance.
#include "job/pieces/wished_sizes.h"

#include "job/pieces/wish_resolution.h"
#include "job_file_fixture.h"

namespace tessera {
namespace test_wished_sizes {

class WishedSizes : public JobFile {
 protected:
  static constexpr const char* kRegion = "[canvas]\nfile = 'c.svg'\n[[regions]]\nname = 'sea'\ncolour = '#0000ff'\n";

  std::optional<SizeRange> sizes_of(const std::string& text) const {
    Job job = load(minimal_ + "[pieces]\nscale_px = [14, 60]\n" + text);
    const std::optional<SizeRange> sizes = wished_sizes(job);
    resolve_wishes({{"cat", 40}, {"cow", 80}}, job);
    EXPECT_EQ(wished_sizes(job).has_value(), sizes.has_value()) << "a run's own card is to be that of tessera card";
    return sizes;
  }
};

TEST_F(WishedSizes, AreThoseOfTheJob) {
  const std::string tables = "[[shapes]]\nnames = 'cat'\nweight = 2\n";
  for (const std::string& text : {std::string(), tables, kRegion + tables}) {
    const std::optional<SizeRange> sizes = sizes_of(text);
    ASSERT_TRUE(sizes) << text;
    EXPECT_EQ(sizes->min_px, 14) << text;
    EXPECT_EQ(sizes->max_px, 60) << text;
  }
}

TEST_F(WishedSizes, AreNotSaidWherePiecesHaveOthers) {
  const std::string shapes = "[[shapes]]\nnames = 'cat'\nscale_px = [30, 50]\n";
  for (const std::string& text :
       {std::string("fit = 'all'\n"), std::string("sizes = 'drawn'\n"), shapes,
        kRegion + std::string("scale_px = 20\n"), "[[shapes]]\nnames = 'cow'\nuses = 1\n" + shapes}) {
    EXPECT_FALSE(sizes_of(text)) << text;
  }
}

TEST_F(WishedSizes, AreNotSaidWhereATableOfWishesMayKnowOthers) {
  Job job = load(minimal_);
  ASSERT_TRUE(wished_sizes(job));
  job.wishes = "/nowhere/wishes.csv";
  EXPECT_FALSE(wished_sizes(job));
}

}  // namespace test_wished_sizes
}  // namespace tessera
