#include "gpf/base/random.hpp"

#include <Random123/philox.h>

#include <cmath>

#include "gpf/base/hash.hpp"

namespace gpf {

std::string hexadecimal(std::uint64_t value) {
  constexpr char digits[] = "0123456789abcdef";
  std::string text(16, '0');
  for (std::size_t k = 16; k-- > 0; value >>= 4) text[k] = digits[value & 15u];
  return text;
}

std::array<std::uint32_t, 4> random_words(std::uint64_t key, std::uint64_t stream, std::uint64_t index) {
  const auto low = [](std::uint64_t v) { return static_cast<std::uint32_t>(v); };
  const auto high = [](std::uint64_t v) { return static_cast<std::uint32_t>(v >> 32); };
  const r123::Philox4x32::ctr_type counter{{low(index), high(index), low(stream), high(stream)}};
  const r123::Philox4x32::key_type k{{low(key), high(key)}};
  const auto words = r123::Philox4x32{}(counter, k);
  return {words[0], words[1], words[2], words[3]};
}

std::uint64_t replica_seed(std::uint64_t scene_hash, std::uint64_t replica) {
  const auto words = random_words(scene_hash, 0x7265706c69636173u, replica);
  return (std::uint64_t{words[1]} << 32) | words[0];
}

double portable_log(double x) {
  int exponent = 0;
  double m = std::frexp(x, &exponent);  // exact: x = m 2^exponent, m in [1/2, 1)
  if (m < 0.70710678118654752) {
    m *= 2;
    --exponent;
  }
  // log m = 2 artanh s with s = (m - 1)/(m + 1), |s| < 0.1716: 11 terms of the series reach 1e-18.
  const double s = (m - 1) / (m + 1), s2 = s * s;
  double sum = 0;
  for (int k = 21; k >= 1; k -= 2) sum = sum * s2 + 1.0 / k;
  constexpr double ln2 = 0.693147180559945309417;
  return exponent * ln2 + 2 * s * sum;
}

Vec2 gaussian_pair(std::uint64_t key, std::uint64_t index) {
  for (std::uint64_t attempt = 0;; ++attempt) {
    const auto w = random_words(key, attempt, index);
    const auto uniform = [](std::uint32_t hi, std::uint32_t lo) {  // 53 bits in (-1, 1)
      const std::uint64_t bits = ((std::uint64_t{hi} << 32) | lo) >> 11;
      return static_cast<double>(bits) * 0x1p-52 - 1 + 0x1p-53;
    };
    const double a = uniform(w[0], w[1]), b = uniform(w[2], w[3]);
    const double s = a * a + b * b;
    if (s >= 1 || s == 0) continue;
    const double factor = std::sqrt(-2 * portable_log(s) / s);
    return {a * factor, b * factor};
  }
}

}  // namespace gpf
