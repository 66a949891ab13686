// Messages between ranks: bytes with a tag that says what they are.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string_view>
#include <vector>

namespace tessera::comm {

using Bytes = std::vector<char>;
/// Bytes of a message to many ranks; they share them without a copy.
using SharedBytes = std::shared_ptr<const Bytes>;

enum class Tag : int {
  hello,        // worker -> its parent in the tree: its part of the library, with those below it
  breadth,      // worker -> its parent: how many windows it and those below it work on at a time
  start_field,  // down the tree of ranks (worker_tree.h), like the requests below; replies have the request's name
  update_field,
  limit,
  count_request,
  count_reply,
  dock_request,
  dock_reply,
  refine_request,
  refine_reply,
  measure_request,
  measure_reply,
  replace_request,
  replace_reply,
  times_request,
  times_reply,
  broadcast,
  barrier,
  nest_layout,   // worker -> rank 0: the best layout of its chains of a nesting
  recognitions,  // worker -> rank 0: the best shapes that it found for each query
  site,          // worker -> rank 0: its machine and its devices
  turn,          // worker -> worker of the same node: it is your turn
  failure,       // any rank -> rank 0: this rank cannot go on
  end,           // rank 0 -> all: leave
  bye,           // any rank -> rank 0: I send nothing more
  leave,         // rank 0 -> all: nobody sends anything more
  heartbeat,     // worker -> rank 0: it is alive
};

inline constexpr std::size_t kTags = std::size_t(Tag::heartbeat) + 1;

// clang-format off
inline constexpr std::array<std::string_view, kTags> kTagNames = {
    "hello",          "breadth",       "start field",   "update field",    "limit",         "count request",
    "count reply",    "dock request",  "dock reply",    "refine request",  "refine reply",  "measure request",
    "measure reply",  "replace request", "replace reply", "times request", "times reply",   "broadcast",
    "barrier",        "nest layout",   "recognitions", "site",          "turn",          "failure",         "end",           "bye",
    "leave",          "heartbeat"};
// clang-format on

inline std::string_view tag_name(Tag tag) { return kTagNames[std::size_t(tag)]; }

struct Message {
  int from = 0;
  Tag tag = Tag::hello;
  Bytes bytes;
};

}  // namespace tessera::comm
