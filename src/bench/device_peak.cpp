#include "bench/device_peak.h"

#include <algorithm>
#include <vector>

#include "core/base/stopwatch.h"
#include "worker/devices/device_kernel.h"
#include "worker/devices/opencl_devices.h"

namespace tessera::bench {
namespace {

constexpr int kChains = 8;  // independent, so that no step waits for the previous one
constexpr std::size_t kItems = 1 << 14;
constexpr std::size_t kGroup = 64;

/// The compiler cannot foresee that nobody uses the results, as they are written to memory.
const char* const kSource = R"(
typedef uchar uchar64 __attribute__((ext_vector_type(64)));

#define CHAINS(DO) DO(0) DO(1) DO(2) DO(3) DO(4) DO(5) DO(6) DO(7)

kernel void float_steps(uint rounds, global float* out) {
  float16 a = (float16)(get_global_id(0));
#define START(k) float16 b##k = (float16)(k * rounds), d##k = 0;
  CHAINS(START)
  for (uint i = 0; i < rounds; ++i) {
    a += 1;
#define STEP(k) { const float16 difference = fabs(a - b##k); d##k = d##k > difference ? d##k : difference; }
    CHAINS(STEP)
  }
#define ADD(k) sum += d##k;
  float16 sum = 0;
  CHAINS(ADD)
  if (any(sum < 0)) out[0] = 1;
}

kernel void byte_steps(uint rounds, global float* out) {
  uchar64 a = (uchar64)((uchar)get_global_id(0));
#define START_BYTES(k) uchar64 b##k = (uchar64)((uchar)(k * rounds)), d##k = (uchar64)((uchar)0);
  CHAINS(START_BYTES)
  for (uint i = 0; i < rounds; ++i) {
    a += (uchar64)((uchar)1);
#define STEP_BYTES(k) { \
      const uchar64 difference = a > b##k ? a - b##k : b##k - a; \
      d##k = d##k > difference ? d##k : difference; \
    }
    CHAINS(STEP_BYTES)
  }
#define JOIN(k) joined |= d##k;
  uchar64 joined = (uchar64)((uchar)0);
  CHAINS(JOIN)
  uint sum = rounds;
  for (int lane = 0; lane < 64; ++lane) sum += joined[lane];
  if (sum == 0) out[0] = 1;
}

kernel void read_floats(global const float* values, global float* out) {
  const float16 v = vload16(get_global_id(0), values);
  const float8 s = v.lo + v.hi;
  const float4 t = s.lo + s.hi;
  if (t.s0 + t.s1 + t.s2 + t.s3 > 0) out[0] = t.s0;
}
)";

class Probe {
 public:
  explicit Probe(const cl::Device& device) : session_(device, kSource, "-cl-std=CL1.2"), out_(session_) {
    out_.reserve(1);
  }

  /// Steps each second. The rounds are doubled until a launch takes `least_s`, so that its start does not matter.
  double steps_per_s(const char* name, double lanes, double least_s) {
    worker::DeviceKernel kernel(session_, name);
    const auto seconds_for = [&](std::uint32_t rounds) {
      return seconds_of([&] { kernel.launch({.x = kItems, .group = kGroup}, {{"rounds", rounds}, {"out", out_}}); });
    };
    seconds_for(1);  // some devices compile at the first launch
    for (std::uint32_t rounds = 64;; rounds *= 2) {
      const double seconds = seconds_for(rounds);
      if (seconds >= least_s) return double(kItems) * rounds * kChains * lanes / seconds;
    }
  }

  double read_bytes_per_s(std::size_t bytes) {
    worker::DeviceKernel kernel(session_, "read_floats");
    worker::DeviceBuffer<float> values(session_);
    values.clear(bytes / sizeof(float));
    double best_s = 1e9;
    for (int run = 0; run < 5; ++run) {
      best_s = std::min(best_s, seconds_of([&] {
                          kernel.launch({.x = bytes / 64, .group = kGroup}, {{"values", values}, {"out", out_}});
                        }));
    }
    return double(bytes) / best_s;
  }

 private:
  template <class Work>
  double seconds_of(Work&& work) {
    session_.queue().finish();
    const Stopwatch watch;
    work();
    session_.queue().finish();
    return watch.seconds();
  }

  worker::DeviceSession session_;
  worker::DeviceBuffer<float> out_;
};

}  // namespace

DevicePeak measure_device_peak(const std::string& devices_use, bool quick) {
  const double least_s = quick ? 0.02 : 0.2;
  DevicePeak peak;
  for (const cl::Device& device : worker::chosen_devices(devices_use)) {
    Probe probe(device);
    peak.float_steps_per_s += probe.steps_per_s("float_steps", 16, least_s);
    peak.byte_steps_per_s += probe.steps_per_s("byte_steps", 64, least_s);
    peak.read_bytes_per_s += probe.read_bytes_per_s(std::size_t(quick ? 16 : 256) << 20);
  }
  return peak;
}

}  // namespace tessera::bench
