// Times that the ranks of a job spent in the loop, and the messages they sent. The figures never affect the picture.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace tessera {

/// The messages of matching and replacement that a rank sent, without the transport's own headers.
struct MessageCount {
  std::uint64_t messages = 0;
  std::uint64_t bytes = 0;

  friend bool operator==(const MessageCount&, const MessageCount&) = default;
};

/// The times of a worker from the first field to the end of the loop, in all regions and all attempts at sizes. The
/// stages add up to loop_s. If a worker passes questions on, its stages last until the workers below it have answered.
struct WorkerTimes {
  double count_s = 0;
  double dock_s = 0;
  double refine_s = 0;
  double measure_s = 0;
  double replace_s = 0;
  double field_s = 0;     // updates
  double messages_s = 0;  // reading, writing and sending messages between question and matcher
  double waiting_s = 0;   // for the next question
  double loop_s = 0;
  double processor_s = 0;    // of all threads, without waiting and without time lost to other processes
  std::uint64_t counts = 0;  // number of questions of each kind
  std::uint64_t docks = 0;
  std::uint64_t refines = 0;
  std::uint64_t measures = 0;
  std::uint64_t replaces = 0;
  MessageCount sent;

  friend bool operator==(const WorkerTimes&, const WorkerTimes&) = default;
};

/// The times of the master in the loop. The stages add up to loop_s.
struct MasterTimes {
  double objective_s = 0;
  double merge_s = 0;
  double questions_s = 0;  // asking questions and joining the answers
  double ahead_s = 0;      // checking candidates while the workers dock
  double waiting_s = 0;    // for the workers
  double other_s = 0;
  double loop_s = 0;
  double processor_s = 0;
  MessageCount sent;
  MessageCount sent_fields;  // the part of `sent` that is patches of the free field

  /// The time in which no worker has anything to do, unless messages cross.
  double serial_s() const { return loop_s - waiting_s - ahead_s; }
};

struct RankStatistics {
  MasterTimes master;
  std::vector<WorkerTimes> workers;  // of rank 1, 2, ...; empty: the master matched by itself
  int asked = 0;                     // number of workers that the master asks directly
  std::uint64_t rounds = 0;
  std::uint64_t target_samples = 0;
};

/// The stages of a worker's and of the master's time, in the order of a round, with their names in the table and the
/// card.
template <class Times>
struct TimedStage {
  std::string_view name;
  double Times::*seconds;
};

inline constexpr TimedStage<WorkerTimes> kWorkerStages[] = {
    {"count", &WorkerTimes::count_s},       {"dock", &WorkerTimes::dock_s},       {"refine", &WorkerTimes::refine_s},
    {"measure", &WorkerTimes::measure_s},   {"replace", &WorkerTimes::replace_s}, {"field", &WorkerTimes::field_s},
    {"messages", &WorkerTimes::messages_s}, {"waiting", &WorkerTimes::waiting_s}};

inline constexpr TimedStage<MasterTimes> kMasterStages[] = {
    {"objective", &MasterTimes::objective_s}, {"merge", &MasterTimes::merge_s},
    {"questions", &MasterTimes::questions_s}, {"ahead", &MasterTimes::ahead_s},
    {"waiting", &MasterTimes::waiting_s},     {"other", &MasterTimes::other_s}};

}  // namespace tessera
