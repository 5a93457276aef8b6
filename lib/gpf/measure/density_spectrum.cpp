#include "gpf/measure/density_spectrum.hpp"

#include <fftw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "gpf/base/error.hpp"
#include "gpf/base/vec2.hpp"

namespace gpf {
namespace {

struct Free {
  void operator()(void* memory) const { fftw_free(memory); }
};

}  // namespace

DensityField density_field(const Scene& scene, const State& state, int along, int across) {
  if (along < 1 || across < 1)
    throw InputError(fmt::format("a mesh of {} x {} cells", along, across), "it has no cell",
                     "give two positive numbers");
  DensityField field{along, across,
                     std::vector<double>(static_cast<std::size_t>(along) * static_cast<std::size_t>(across))};
  const double cell = scene.length() / along / across;
  const double share = std::numbers::pi / 4 * square(scene.diameter()) / cell;
  const auto place = [](double part, int cells) {
    return std::clamp(static_cast<int>(std::floor(part * cells)), 0, cells - 1);
  };
  for (const Vec2 r : state.position) field.at(place(r.x / scene.length(), along), place(r.y, across)) += share;
  return field;
}

DensitySpectrum::DensitySpectrum(const DensityField& field) : along_(field.along), across_(field.across) {
  const auto half = static_cast<std::size_t>(across_) / 2 + 1, rows = static_cast<std::size_t>(along_);
  const std::unique_ptr<double[], Free> in(fftw_alloc_real(field.value.size()));
  const std::unique_ptr<fftw_complex[], Free> out(fftw_alloc_complex(rows * half));
  // FFTW_ESTIMATE: the same plan, and so the same bits, each time.
  fftw_plan_s* const plan = fftw_plan_dft_r2c_2d(along_, across_, in.get(), out.get(), FFTW_ESTIMATE);
  std::copy(field.value.begin(), field.value.end(), in.get());
  fftw_execute(plan);
  fftw_destroy_plan(plan);
  const double cells = static_cast<double>(field.value.size());
  for (std::size_t k = 0; k < rows * half; ++k)
    power_.push_back(2 * (square(out[k][0]) + square(out[k][1])) / square(cells));
}

double DensitySpectrum::power(int kx, int ky) const {
  if (ky < 0) kx = -kx, ky = -ky;
  const int row = ((kx % along_) + along_) % along_;
  return power_[static_cast<std::size_t>(row) * (static_cast<std::size_t>(across_) / 2 + 1) +
                static_cast<std::size_t>(ky)];
}

double noise_of_spectrum(const Scene& scene) { return 2 * square(scene.area_fraction()) / scene.particles; }

}  // namespace gpf
