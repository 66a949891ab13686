#include "worker/devices/arithmetic_probe.h"

#include <array>
#include <bit>
#include <cmath>
#include <stdexcept>

#include "worker/devices/device_kernel.h"

namespace tessera::worker {
namespace {

constexpr int kProbesOfAKind = 256;

std::uint32_t bits(float value) { return std::bit_cast<std::uint32_t>(value); }
float number(std::uint32_t value) { return std::bit_cast<float>(value); }

/// The result of this processor; the build keeps products and sums apart (-ffp-contract=off).
std::uint32_t expected(const ProbeRecord& probe) {
  const float a = number(probe.a);
  const float b = number(probe.b);
  const float c = number(probe.c);
  switch (ProbeOperation(probe.operation)) {
    case kProbeProductAndSum: return bits(a * b + c);
    case kProbeProductAndDifference: return bits(a * b - c);
    case kProbeProduct: return bits(a * b);
    case kProbeQuotient: return bits(a / b);
    case kProbeRoot: return bits(std::sqrt(a));
    case kProbeSum: return bits(a + b + c);
    case kProbeFromInt: return bits(float(std::int32_t(probe.a)));
    case kProbeFromUint: return bits(float(probe.a));
    case kProbeToInt: return std::uint32_t(std::int32_t(a));
    case kProbeFloor: return bits(std::floor(a));
  }
  throw std::logic_error("an unknown operation");
}

class Probes {
 public:
  void add(ProbeOperation operation, float a, float b = 0, float c = 0) {
    add_bits(operation, bits(a), bits(b), bits(c));
  }

  void add_bits(ProbeOperation operation, std::uint32_t a, std::uint32_t b = 0, std::uint32_t c = 0) {
    const ProbeRecord record = {u32(operation), a, b, c};
    probes_.push_back({record, expected(record)});
  }

  std::vector<ArithmeticProbe> take() { return std::move(probes_); }

 private:
  std::vector<ArithmeticProbe> probes_;
};

/// Adds probes that find a fused multiply-add. (1 + j 2^-12) (1 + k 2^-12) has more bits than a float: minus its rounded
/// value it is zero only where the product is rounded before the sum.
void add_products_and_sums(Probes& probes) {
  for (int i = 0; i < kProbesOfAKind; ++i) {
    const float a = 1 + float(2 * i + 1) * 0x1p-12f;
    const float b = 1 + float(2 * i + 3) * 0x1p-13f;
    const float product = a * b;
    probes.add(kProbeProductAndSum, a, b, -product);
    probes.add(kProbeProductAndDifference, a, b, product);
  }
}

/// The number whose product with the odd `factor` is 1 modulo 2^32.
std::uint32_t inverse(std::uint32_t factor) {
  std::uint32_t found = factor;                             // right in three bits
  for (int i = 0; i < 4; ++i) found *= 2 - factor * found;  // twice as many each time
  return found;
}

/// Adds quotients as near as possible to the middle between two floats: 2^25 a = q b + r with r = 1 or -1, where q has 25
/// bits and is odd. So a / b differs from q 2^-25 by r / b, less than 2^-22 of the distance of two floats.
void add_quotients(Probes& probes) {
  constexpr std::uint32_t kModulus = 1u << 25;
  constexpr std::uint32_t kLeast = 1u << 23;  // the least of the 24 bits of a float
  int found = 0;
  for (std::uint32_t q = (1u << 24) + 1; found < kProbesOfAKind; q += 65'538 - (q & 2)) {
    if (q >= kModulus) q -= kLeast * 2 - 2;
    const bool above = found % 2 == 0;
    const std::uint32_t b = (above ? 0u - inverse(q) : inverse(q)) % kModulus;
    if (b < kLeast || b >= 2 * kLeast) continue;
    const std::uint64_t a = (std::uint64_t(q) * b + (above ? 1 : std::uint64_t(-1))) / kModulus;
    probes.add(kProbeQuotient, float(a), float(b));
    ++found;
  }
}

/// A root of `square` (1 modulo 8) modulo 2^26. Each step makes one more bit right.
std::uint64_t root_modulo(std::uint64_t square) {
  std::uint64_t root = 1;
  for (int bit = 3; bit < 27; ++bit) {
    if (((root * root - square) >> bit & 1) != 0) root += std::uint64_t(1) << (bit - 1);
  }
  return root;
}

/// Adds roots as near as possible to the middle between two floats: s^2 = 2^26 x + r, where s has 25 bits and is odd, and r
/// is small. So the root of 2^26 x differs from s by r / 2 s.
void add_roots(Probes& probes) {
  constexpr std::uint64_t kModulus = std::uint64_t(1) << 26;
  constexpr std::uint64_t kLeast = std::uint64_t(1) << 24;
  int found = 0;
  for (std::int64_t r = 1; found<kProbesOfAKind; r = r> 0 ? -r - 6 : -r + 2) {  // 1, -7, 9, -15, 17 ...
    const std::uint64_t root = root_modulo(std::uint64_t(r) % kModulus) % kModulus;
    for (const std::uint64_t s :
         {root, kModulus - root, (root + kModulus / 2) % kModulus, (kModulus / 2 + kModulus - root) % kModulus}) {
      if (s < kLeast || s >= 2 * kLeast) continue;
      const std::uint64_t x = (s * s - std::uint64_t(r)) / kModulus;
      if (x >= kLeast) continue;  // 25 bits: no float
      probes.add(kProbeRoot, float(x) * float(kModulus));
      ++found;
    }
  }
}

/// Adds products and sums whose operands or results are denormal numbers.
void add_denormals(Probes& probes) {
  for (int i = 1; i <= kProbesOfAKind; ++i) {
    probes.add(kProbeProduct, float(2 * i + 1) * 0x1p-100f, 0x1.8p-50f);
    probes.add_bits(kProbeProduct, std::uint32_t(i), bits(3.f));
    probes.add_bits(kProbeSum, std::uint32_t(i), std::uint32_t(3 * i), 0);
    probes.add_bits(kProbeQuotient, std::uint32_t(977 * i), bits(1.5f));
  }
}

/// Adds sums half-way between two floats, which must go to the even one, and sums that must be added in order.
void add_sums(Probes& probes) {
  for (int i = 0; i < kProbesOfAKind; ++i) {
    const float large = 0x1p24f + float(2 * i);
    probes.add(kProbeSum, large, 1.f, 0.f);
    probes.add(kProbeSum, large, 1.f, 1.f);
    probes.add(kProbeSum, large, float(i) + 0.5f, -large);
  }
}

void add_conversions(Probes& probes) {
  for (std::uint32_t i = 0; i < std::uint32_t(kProbesOfAKind); ++i) {
    const std::uint32_t odd = (1u << 24) + 2 * i + 1;  // half-way between two floats
    for (const std::uint32_t value : {odd, 0u - odd, odd << 4, (odd << 4) + 1, (odd << 4) - 1}) {
      probes.add_bits(kProbeFromInt, value);
      probes.add_bits(kProbeFromUint, value);
    }
    const float value = (float(i) - 100) * 0.37f;
    probes.add(kProbeToInt, value);
    probes.add(kProbeFloor, value);
    probes.add(kProbeFloor, value * 0x1p-140f);
  }
}

struct Subject {
  ProbeOperation first;
  ProbeOperation last;
  const char* name;
};

constexpr std::array<Subject, 6> kSubjects = {{
    {kProbeProductAndSum, kProbeProductAndDifference, "sums of products, which it rounds once (fused multiply-add)"},
    {kProbeProduct, kProbeProduct, "products that are denormal numbers"},
    {kProbeQuotient, kProbeQuotient, "divisions"},
    {kProbeRoot, kProbeRoot, "square roots"},
    {kProbeSum, kProbeSum, "sums"},
    {kProbeFromInt, kProbeFloor, "conversions of numbers"},
}};

bool is_of(const Subject& subject, const ArithmeticProbe& probe) {
  return probe.record.operation >= u32(subject.first) && probe.record.operation <= u32(subject.last);
}

}  // namespace

std::vector<ArithmeticProbe> arithmetic_probes() {
  Probes probes;
  add_products_and_sums(probes);
  add_quotients(probes);
  add_roots(probes);
  add_denormals(probes);
  add_sums(probes);
  add_conversions(probes);
  return probes.take();
}

std::string wrong_arithmetic(const std::vector<ArithmeticProbe>& probes, const std::vector<std::uint32_t>& results) {
  std::string text;
  for (const Subject& subject : kSubjects) {
    std::size_t all = 0;
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < probes.size(); ++i) {
      if (!is_of(subject, probes[i])) continue;
      ++all;
      if (results.at(i) != probes[i].expected) ++wrong;
    }
    if (wrong == 0) continue;
    text += (text.empty() ? "" : ", ") + std::string(subject.name) + " (" + std::to_string(wrong) + " of " +
            std::to_string(all) + " differ)";
  }
  return text;
}

std::vector<std::uint32_t> probe_results(const DeviceSession& session, const std::vector<ArithmeticProbe>& probes) {
  std::vector<ProbeRecord> records;
  records.reserve(probes.size());
  for (const ArithmeticProbe& probe : probes) records.push_back(probe.record);
  const DeviceBuffer<ProbeRecord> operands(session, records);
  DeviceBuffer<std::uint32_t> results(session);
  results.clear(probes.size());
  DeviceKernel kernel(session, "probe_arithmetic");
  constexpr std::size_t kGroup = 64;
  kernel.launch({probes.size(), 1, kGroup},
                {{"count", u32(probes.size())}, {"probes", operands}, {"results", results}});
  return results.read(probes.size());
}

void check_arithmetic(const DeviceSession& session) {
  const std::vector<ArithmeticProbe> probes = arithmetic_probes();
  const std::string wrong = wrong_arithmetic(probes, probe_results(session, probes));
  if (wrong.empty()) return;
  throw EnvironmentError("OpenCL device \"" + session.name() + "\" does not compute as IEEE 754 requires: " + wrong +
                         "; a collage made there would differ from one made elsewhere. Choose other devices by "
                         "devices.use or --devices (tessera devices lists them), or another driver");
}

}  // namespace tessera::worker
