#include "gpf/theory/finite_size.hpp"

#include <fmt/format.h>

#include "gpf/base/error.hpp"

namespace gpf {
namespace {

void require_disks(std::int64_t disks) {
  if (disks < 2) {
    throw InputError(fmt::format("no pressure of {} disk(s)", disks), "it needs two to collide", "use more disks");
  }
}

}  // namespace

double finite_size_compressibility(double nu, std::int64_t disks) {
  require_disks(disks);
  if (!(nu >= 0 && nu <= finite_size_limit)) {
    throw InputError(fmt::format("no finite-size term at area fraction {}", nu),
                     "near freezing it is governed by the shape of the box", "stay at or below 0.685");
  }
  const Derivatives z = kolafa_rottner_derivatives(nu);
  return z.value + density_fluctuation_term(z, nu, disks);
}

double infinite_system_compressibility(double measured, double nu, std::int64_t disks) {
  require_disks(disks);
  if (!(nu >= 0 && nu < close_packing)) {
    throw InputError(fmt::format("no compressibility at area fraction {}", nu),
                     "disks fill from 0 to less than 0.9069 of the plane", "check the area fraction");
  }
  const double n = static_cast<double>(disks);
  if (nu >= melting) return measured * n / (n - 1);
  if (nu > finite_size_limit) return measured + 1 / n;
  return measured + 1 / n - density_fluctuation_term(kolafa_rottner_derivatives(nu), nu, disks);
}

double finite_size_rate_factor(std::int64_t disks) {
  require_disks(disks);
  const double z = static_cast<double>(disks - 1);
  return 1 + 1 / (8 * z) + 1 / (128 * z * z) - 5 / (1024 * z * z * z);
}

}  // namespace gpf
