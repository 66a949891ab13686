#include "text/libxml_state.h"

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <pthread.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

#include "text/xml_writer.h"

namespace {

std::atomic<int> making{0};       // threads in pthread_mutex_init()
std::atomic<int> most_making{0};  // at the same time

}  // namespace

/// Replaces the C library's function, with which libxml2 makes its locks. It takes so long that any other thread that may enter it does.
extern "C" int pthread_mutex_init(pthread_mutex_t* mutex, const pthread_mutexattr_t* attributes) {
  const int now = ++making;
  for (int most = most_making; most < now && !most_making.compare_exchange_weak(most, now);) {
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  --making;
  using Function = int(pthread_mutex_t*, const pthread_mutexattr_t*);
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, "pthread_mutex_init"))(mutex, attributes);
}

namespace tessera {
namespace {

/// The tests of this file run in a separate process that has not used libxml2 before.
TEST(LibxmlState, IsMadeByOneThread) {
  std::atomic<int> waiting{4};
  std::vector<std::thread> threads;
  for (int i = waiting; i > 0; --i) {
    threads.emplace_back([&] {
      --waiting;
      while (waiting > 0) std::this_thread::yield();
      XmlWriter().start("svg").attribute("width", "1").end().finish();
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(most_making, 1);
}

}  // namespace
}  // namespace tessera
