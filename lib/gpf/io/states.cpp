#include "gpf/io/states.hpp"

#include <fmt/format.h>

#include <cmath>

#include "gpf/base/error.hpp"

namespace gpf {
namespace {

void append(std::vector<double>& flat, const std::vector<Vec2>& vectors) {
  flat.reserve(flat.size() + 2 * vectors.size());
  for (const Vec2 v : vectors) flat.push_back(v.x), flat.push_back(v.y);
}

std::vector<Vec2> vectors(const std::vector<double>& flat, std::size_t from, std::size_t count) {
  std::vector<Vec2> v(count);
  for (std::size_t k = 0; k < count; ++k) v[k] = {flat[2 * (from + k)], flat[2 * (from + k) + 1]};
  return v;
}

std::vector<double> read(const Hdf5Reader& file, const std::string& name, const Dims& dims) {
  auto array = file.doubles(name);
  if (array.dims != dims)
    throw InputError(name + " is not of its scene's size", "the file is damaged, or another program wrote it",
                     "delete it and run the scene again");
  return std::move(array.values);
}

}  // namespace

void write_state(Hdf5Writer& file, const std::string& group, const State& state) {
  std::vector<double> position, velocity;
  append(position, state.position);
  append(velocity, state.velocity);
  file.write(group + "/position", position, Dims{state.position.size(), 2});
  file.write(group + "/velocity", velocity, Dims{state.velocity.size(), 2});
}

State read_state(const Hdf5Reader& file, const std::string& group, std::size_t disks) {
  return {vectors(read(file, group + "/position", {disks, 2}), 0, disks),
          vectors(read(file, group + "/velocity", {disks, 2}), 0, disks)};
}

void write_snapshots(Hdf5Writer& file, const std::vector<Snapshot>& snapshots, std::size_t disks) {
  std::vector<double> time, position, velocity;
  for (const Snapshot& s : snapshots) {
    time.push_back(s.time);
    append(position, s.state.position);
    append(velocity, s.state.velocity);
  }
  file.write("/snapshots/time", time);
  file.write("/snapshots/position", position, Dims{time.size(), disks, 2});
  file.write("/snapshots/velocity", velocity, Dims{time.size(), disks, 2});
}

std::vector<Snapshot> read_snapshots(const Hdf5Reader& file, std::size_t disks, const Run& run) {
  const std::vector<double> time = file.doubles("/snapshots/time").values;
  const auto asked_for = [&](std::size_t s) {
    return s < run.snapshots.size() && std::abs(time[s] - run.snapshots[s]) <= run.sample_interval;
  };
  for (std::size_t s = 0; s < time.size(); ++s)
    if (!asked_for(s))
      throw InputError(fmt::format("there is a snapshot at {}, which was not asked for", time[s]),
                       "the file is damaged, or another program wrote it", "delete it and run the scene again");
  const Dims dims{time.size(), disks, 2};
  const std::vector<double> position = read(file, "/snapshots/position", dims),
                            velocity = read(file, "/snapshots/velocity", dims);
  std::vector<Snapshot> snapshots;
  for (std::size_t s = 0; s < time.size(); ++s)
    snapshots.push_back({time[s], {vectors(position, s * disks, disks), vectors(velocity, s * disks, disks)}});
  return snapshots;
}

}  // namespace gpf
