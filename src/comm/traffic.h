// The messages and bytes that a rank sent and received, by tag.
#pragma once

#include <array>
#include <cstdint>

#include "comm/message.h"

namespace tessera::comm {

struct TrafficCount {
  std::uint64_t messages = 0;
  std::uint64_t bytes = 0;  // of the messages' content, without the transport's own headers

  void add(std::size_t message_bytes) {
    ++messages;
    bytes += message_bytes;
  }
};

struct Traffic {
  std::array<TrafficCount, kTags> sent_by_tag{};
  std::array<TrafficCount, kTags> received_by_tag{};

  const TrafficCount& sent(Tag tag) const { return sent_by_tag[std::size_t(tag)]; }
  const TrafficCount& received(Tag tag) const { return received_by_tag[std::size_t(tag)]; }
  /// Messages sent in the loop: requests to the workers, or their answers.
  TrafficCount sent_in_loop() const {
    TrafficCount sum;
    for (std::size_t tag = std::size_t(Tag::start_field); tag <= std::size_t(Tag::replace_reply); ++tag) {
      sum.messages += sent_by_tag[tag].messages;
      sum.bytes += sent_by_tag[tag].bytes;
    }
    return sum;
  }
  TrafficCount total_sent() const { return total(sent_by_tag); }
  TrafficCount total_received() const { return total(received_by_tag); }

 private:
  static TrafficCount total(const std::array<TrafficCount, kTags>& counts) {
    TrafficCount sum;
    for (const TrafficCount& count : counts) {
      sum.messages += count.messages;
      sum.bytes += count.bytes;
    }
    return sum;
  }
};

}  // namespace tessera::comm
