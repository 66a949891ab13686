#include "files/leftover_file.h"

#include <limits.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace tessera {
namespace {

enum class State { free, being_noted, noted };

/// An entry of the table. It allocates and frees no memory: the signal may come in the middle of an allocation.
struct Slot {
  std::atomic<State> state = State::free;
  pid_t owner = 0;                  // a forked child has a copy of the table
  std::array<char, PATH_MAX> path;  // absolute
};
static_assert(std::atomic<State>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

/// A run has about ten of them: locks, folders that it made, and files that it is writing.
constexpr int kMostFiles = 64;
std::array<Slot, kMostFiles> slots;

}  // namespace

LeftoverFile::LeftoverFile(const std::string& path) {
  // A library may end the process by exit() (LLVM does when its file cannot grow): our destructors do not run then.
  [[maybe_unused]] static const int registered = std::atexit(remove_leftover_files);
  std::error_code error;
  const std::string absolute = std::filesystem::absolute(path, error).string();
  if (error || absolute.size() >= PATH_MAX) return;
  for (int i = 0; i < kMostFiles; ++i) {
    State expected = State::free;
    if (!slots[std::size_t(i)].state.compare_exchange_strong(expected, State::being_noted)) continue;
    std::memcpy(slots[std::size_t(i)].path.data(), absolute.c_str(), absolute.size() + 1);
    slots[std::size_t(i)].owner = ::getpid();
    slots[std::size_t(i)].state = State::noted;
    slot_ = i;
    return;
  }
}

LeftoverFile::~LeftoverFile() {
  if (slot_ >= 0) slots[std::size_t(slot_)].state = State::free;
}

void remove_leftover_files() {
  const auto counts = [](const Slot& slot) { return slot.state == State::noted && slot.owner == ::getpid(); };
  for (const Slot& slot : slots) {
    if (counts(slot)) ::unlink(slot.path.data());
  }
  // Slots are reused, so a folder may stand before or after its parent: repeats until nothing more can be removed.
  for (bool again = true; again;) {
    again = false;
    for (const Slot& slot : slots) again |= counts(slot) && ::rmdir(slot.path.data()) == 0;
  }
}

}  // namespace tessera
