// The exit codes of tessera that are no errors. Those of errors are in comm/failure.h (1: the machine failed, 2: bad
// input). docs/reference/exit-codes.md and `tessera --help` list all of them.
#pragma once

namespace tessera {

inline constexpr int kDoneExitCode = 0;

/// The command is finished and all its files are written, but something that was counted is missing: a least number of
/// uses, a shape of `fit = "all"`, a piece without a place. Warnings name what is missing. Wishes that are only
/// preferences (weights, style, colours) never cause this code.
inline constexpr int kIncompleteExitCode = 3;

/// The command was interrupted and has more to do. The last line on stderr says how to go on: a collage from its
/// checkpoint, other commands from the start. sysexits.h calls 75 a temporary failure.
inline constexpr int kUnfinishedExitCode = 75;

}  // namespace tessera
