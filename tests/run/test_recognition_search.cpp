// Several ranks look up queries: the answer is the same on any number of them, and another library gives no answer.
#include "run/recognition/recognition_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <mutex>
#include <thread>

#include "comm/in_process_communicator.h"
#include "comm/rank_program.h"
#include "core/base/error.h"
#include "library/storage/library_file.h"
#include "support/matching_scene.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_recognition_search {

constexpr std::uint32_t kShapes = 11;
constexpr std::uint32_t kLot = 3;

void write_library(const std::string& path, std::uint32_t count) {
  LibraryWriter writer(path, PadParameters());
  std::uint32_t number = 0;
  for (Shape& shape : test::formula_shapes(int(count), PadParameters())) {
    shape.name = "shape " + std::to_string(number++);
    shape.artwork.width_px = shape.artwork.height_px = 600;
    shape.drawn_scale_px = 100;
    writer.append(shape);
  }
  writer.finish();
}

/// A question with a few of the shapes, each turned and twice as large as drawn.
RecognitionQuestion question_of(const std::string& path) {
  const LibraryFile library(path);
  RecognitionQuestion question;
  question.library = path;
  question.library_digest = library.content_digest();
  question.lot_shapes = kLot;
  question.most = 4;
  for (const std::uint32_t shape : {0u, 4u, 8u, 10u}) {
    Curve curve{library.read(shape, shape + 1, {}).front().outline.curves.front(), true};
    const Similarity pose{200 * std::cos(float(shape)), 200 * std::sin(float(shape)), 5, 7};
    for (Vec2& p : curve.points) p = pose.apply(p);
    question.queries.push_back({{curve}, 1});
  }
  return question;
}

/// HDF5 allows only one thread at a time. These ranks are threads, so they read one after the other.
class OneAtATime : public ShapeLibrary {
  template <class Read>
  static auto locked(Read read) -> decltype(read()) {
    const std::lock_guard lock(mutex_);
    return read();
  }

 public:
  explicit OneAtATime(const std::string& path) {
    const std::lock_guard lock(mutex_);
    file_ = std::make_unique<LibraryFile>(path);
  }
  ~OneAtATime() override {
    const std::lock_guard lock(mutex_);
    file_.reset();
  }
  const std::string& path() const override { return file_->path(); }
  std::size_t size() const override {
    return locked([&] { return file_->size(); });
  }
  bool has_surroundings() const override {
    return locked([&] { return file_->has_surroundings(); });
  }
  PadParameters pad_parameters() const override {
    return locked([&] { return file_->pad_parameters(); });
  }
  std::uint64_t content_digest() const override {
    return locked([&] { return file_->content_digest(); });
  }
  std::vector<std::uint32_t> variant_of() const override {
    return locked([&] { return file_->variant_of(); });
  }
  std::vector<StyleFeatures> styles() const override {
    return locked([&] { return file_->styles(); });
  }
  std::vector<std::uint32_t> drawings() const override {
    return locked([&] { return file_->drawings(); });
  }
  std::vector<Shape> read(std::size_t begin, std::size_t end, const LibraryParts& parts) const override {
    return locked([&] { return file_->read(begin, end, parts); });
  }

 private:
  static inline std::mutex mutex_;
  std::unique_ptr<LibraryFile> file_;
};

Recognitions answer_of(int size, const RecognitionQuestion& question) {
  comm::InProcessNetwork network(size);
  std::vector<std::jthread> workers;
  for (int rank = 1; rank < size; ++rank) {
    workers.emplace_back([&network, rank] {
      const auto ranks = network.connect(rank);
      comm::run_rank(*ranks, {.run = [](comm::Communicator& own) -> int {
                                work_on_recognition(own, [](const std::string& path) {
                                  return std::make_unique<const OneAtATime>(path);
                                });
                              },
                              .report_error = [](const std::string&) {}});
    });
  }
  Recognitions answer;
  const auto ranks = network.connect(0);
  const OneAtATime library(question.library);
  std::string error;
  comm::run_rank(*ranks, {.run =
                              [&](comm::Communicator& own) {
                                answer = recognised_by_all_ranks(own, question, library, [](auto, auto) {});
                                return 0;
                              },
                          .report_error = [&](const std::string& line) { error = line; }});
  if (!error.empty()) throw std::runtime_error(error);
  return answer;
}

TEST(RecognitionSearch, IsTheSameOnAnyNumberOfRanks) {
  const test::ScratchFolder folder;
  const std::string path = folder.path("shapes.h5");
  write_library(path, kShapes);
  const RecognitionQuestion question = question_of(path);
  const Recognitions alone = answer_of(1, question);
  ASSERT_EQ(alone.size(), 4u);
  EXPECT_EQ(index_of(alone[0][0].shape), 0u);
  EXPECT_EQ(index_of(alone[1][0].shape), 4u);
  EXPECT_EQ(index_of(alone[2][0].shape), 8u);
  EXPECT_EQ(index_of(alone[3][0].shape), 10u) << "of the last lot, which is not full";
  EXPECT_EQ(alone[0].size(), 4u) << "from more than one lot";
  for (const int size : {2, 3, 5}) {
    const Recognitions shared = answer_of(size, question);
    ASSERT_EQ(shared.size(), alone.size());
    for (std::size_t q = 0; q < alone.size(); ++q) {
      ASSERT_EQ(shared[q].size(), alone[q].size());
      for (std::size_t k = 0; k < alone[q].size(); ++k) {
        EXPECT_EQ(shared[q][k].shape, alone[q][k].shape);
        EXPECT_EQ(shared[q][k].similarity, alone[q][k].similarity);
        EXPECT_EQ(shared[q][k].query_from_shape, alone[q][k].query_from_shape);
      }
    }
  }
}

TEST(RecognitionSearch, RefusesAnotherLibraryThanRankZeros) {
  const test::ScratchFolder folder;
  write_library(folder.path("shapes.h5"), kShapes);
  RecognitionQuestion question = question_of(folder.path("shapes.h5"));
  question.library_digest ^= 1;
  try {
    answer_of(2, question);
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("is another library than on rank 0"), std::string::npos) << error.what();
  }
}

}  // namespace test_recognition_search
}  // namespace tessera
