// Prints one line for each function of libm that Tessera calls: its name and a digest of its results for 100,000 arguments.
// Two runs in different environments show which functions give different bits there.
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace {

constexpr std::uint64_t kFnvOffset = 14695981039346656037ull;
constexpr std::uint64_t kFnvPrime = 1099511628211ull;

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }
std::uint64_t bits(float value) { return std::bit_cast<std::uint32_t>(value); }

template <class Function>
void print_digest(const char* name, Function&& function) {
  std::uint64_t digest = kFnvOffset;
  for (int i = 1; i <= 100000; ++i) digest = (digest ^ bits(function(i * 1e-4))) * kFnvPrime;
  std::printf("%s %016llx\n", name, static_cast<unsigned long long>(digest));
}

}  // namespace

int main() {
  print_digest("exp", [](double x) { return std::exp(x); });
  print_digest("log", [](double x) { return std::log(x); });
  print_digest("pow", [](double x) { return std::pow(x, 0.37); });
  print_digest("sin", [](double x) { return std::sin(x); });
  print_digest("cos", [](double x) { return std::cos(x); });
  print_digest("atan2", [](double x) { return std::atan2(x, 3.0); });
  print_digest("cbrt", [](double x) { return std::cbrt(x); });
  print_digest("expf", [](double x) { return std::exp(float(x)); });
  print_digest("logf", [](double x) { return std::log(float(x)); });
  print_digest("powf", [](double x) { return std::pow(float(x), 0.37f); });
  print_digest("sinf", [](double x) { return std::sin(float(x)); });
  print_digest("cosf", [](double x) { return std::cos(float(x)); });
  print_digest("atan2f", [](double x) { return std::atan2(float(x), 3.0f); });
  print_digest("cbrtf", [](double x) { return std::cbrt(float(x)); });
}
