// Searches a library for queries. Its lots of shapes (RecognitionQuestion) are shared among the ranks.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "comm/communicator.h"
#include "library/storage/shape_library.h"
#include "run/recognition/recognition_messages.h"

namespace tessera {

/// Receives how many of rank 0's lots are searched. It may throw to end the search.
using LotProgress = std::function<void(std::size_t done, std::size_t all)>;

/// Called by rank 0: sends the question to all ranks and returns the best shapes of all lots for each query. `library`: the one
/// that the question names. Throws InputError where it is damaged.
Recognitions recognised_by_all_ranks(comm::Communicator& ranks, const RecognitionQuestion& question,
                                     const ShapeLibrary& library, const LotProgress& progress);

using OpenLibrary = std::function<std::unique_ptr<const ShapeLibrary>(const std::string& path)>;

/// Called by every other rank: searches its lots of the library that `open` returns. Leaves by JobEnded. Throws InputError where
/// this rank's library has other content than rank 0's, EnvironmentError where rank 0 runs another program.
[[noreturn]] void work_on_recognition(comm::Communicator& ranks, const OpenLibrary& open);

}  // namespace tessera
