#include "verify/export/h5md.hpp"

#include <fcntl.h>
#include <hdf5.h>
#include <pwd.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <vector>

#include "gpf/base/error.hpp"
#include "gpf/base/hash.hpp"
#include "gpf/io/atomic_file.hpp"
#include "gpf/io/file_descriptor.hpp"
#include "gpf/io/hdf5_handle.hpp"
#include "gpf/io/provenance.hpp"
#include "gpf/measure/history.hpp"

namespace gpf {
namespace {

using hdf5::check;
using hdf5::Handle;
using Lengths = std::vector<hsize_t>;

/// Where in the file an array stands that is filled one state at a time.
struct Place {
  off_t begin, bytes_per_state;
};
struct Places {
  Place position, velocity, edges, step, time, energy, temperature;
};

/// The file without its states. HDF5 lays it out, and is done with it before it grows: HDF5 1.10 ends the process when
/// the disk gets full.
class Layout {
 public:
  explicit Layout(const std::filesystem::path& path) : file_(create(path)) {}

  void group(const std::string& name) const {
    const Handle made(H5Gcreate2(file_.get(), name.c_str(), H5P_DEFAULT, timeless(H5P_GROUP_CREATE).get(), H5P_DEFAULT),
                      H5Gclose);
  }
  void attribute(const std::string& object, const char* name, hid_t type, const Lengths& lengths,
                 const void* data) const {
    const Handle opened(H5Oopen(file_.get(), object.c_str(), H5P_DEFAULT), H5Oclose), space = dataspace(lengths);
    const Handle made(H5Acreate2(opened.get(), name, type, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    check(H5Awrite(made.get(), type, data));
  }
  void attribute(const std::string& object, const char* name, const std::string& text) const {
    attribute(object, name, hdf5::text_type(text.size()).get(), {}, text.c_str());
  }
  void dataset(const std::string& name, hid_t type, const Lengths& lengths, const void* data) const {
    const Handle space = dataspace(lengths), properties = timeless(H5P_DATASET_CREATE);
    const Handle made(
        H5Dcreate2(file_.get(), name.c_str(), type, space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT), H5Dclose);
    check(H5Dwrite(made.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data));
  }
  void text(const std::string& name, const std::string& text) const {
    dataset(name, hdf5::text_type(text.size()).get(), {}, text.c_str());
  }
  /// An array of 8-byte numbers whose values come later; the first length is the number of states.
  [[nodiscard]] Place room(const std::string& name, hid_t type, const Lengths& lengths) const {
    const Handle space = dataspace(lengths), properties = timeless(H5P_DATASET_CREATE);
    check(H5Pset_alloc_time(properties.get(), H5D_ALLOC_TIME_EARLY));
    check(H5Pset_fill_time(properties.get(), H5D_FILL_TIME_NEVER));
    const Handle made(
        H5Dcreate2(file_.get(), name.c_str(), type, space.get(), H5P_DEFAULT, properties.get(), H5P_DEFAULT), H5Dclose);
    const haddr_t begin = H5Dget_offset(made.get());
    if (begin == HADDR_UNDEF) throw hdf5::Failure{"it gives no room to " + name};
    off_t bytes = 8;
    for (std::size_t axis = 1; axis < lengths.size(); ++axis) bytes *= static_cast<off_t>(lengths[axis]);
    return {static_cast<off_t>(begin), bytes};
  }
  void link(const std::string& existing, const std::string& name) const {
    check(H5Lcreate_hard(file_.get(), existing.c_str(), file_.get(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT));
  }
  void close() { file_.close(); }

 private:
  /// Creation properties that keep times out of the file.
  static Handle timeless(hid_t property_class) {
    Handle properties(H5Pcreate(property_class), H5Pclose);
    check(H5Pset_obj_track_times(properties.get(), false));
    return properties;
  }
  static Handle dataspace(const Lengths& lengths) {
    if (lengths.empty()) return {H5Screate(H5S_SCALAR), H5Sclose};
    return {H5Screate_simple(static_cast<int>(lengths.size()), lengths.data(), nullptr), H5Sclose};
  }
  static Handle create(const std::filesystem::path& path) {
    const Handle properties = timeless(H5P_FILE_CREATE);
    return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, properties.get(), H5P_DEFAULT), H5Fclose};
  }

  Handle file_;
};

void write_frame_of_file(const Layout& file, const ExportedStates& states, const H5mdForm& form) {
  file.group("/h5md");
  const std::array<int, 2> version{1, 1};
  file.attribute("/h5md", "version", H5T_NATIVE_INT, {2}, version.data());
  file.group("/h5md/author");
  file.attribute("/h5md/author", "name", form.author);
  file.group("/h5md/creator");
  file.attribute("/h5md/creator", "name", "gpf");
  file.attribute("/h5md/creator", "version", build_provenance().version);

  const ViewSource& source = states.source();
  const double diameter = source.scene.diameter();
  file.group("/parameters");
  file.text("/parameters/scene", canonical_text(source.scene, source.run));
  file.text("/parameters/origin", states.origin());
  file.dataset("/parameters/diameter", H5T_NATIVE_DOUBLE, {}, &diameter);
  if (source.record) file.text("/parameters/trace_hash", hexadecimal(source.record->trace_hash));
}

Places write_layout(const std::filesystem::path& path, const ExportedStates& states, const H5mdForm& form) {
  Layout file(path);
  write_frame_of_file(file, states, form);

  const Scene& scene = states.source().scene;
  const hsize_t count = states.count(), disks = static_cast<hsize_t>(scene.particles),
                dimension = static_cast<hsize_t>(form.dimension);
  Places places{};
  const std::string particles = "/particles/disks", box = particles + "/box";
  const auto share_times = [&](const std::string& group) {
    for (const char* name : {"/step", "/time"}) file.link(particles + "/position" + name, group + name);
  };
  file.group("/particles");
  file.group(particles);
  file.group(particles + "/position");
  places.step = file.room(particles + "/position/step", H5T_NATIVE_INT64, {count});
  places.time = file.room(particles + "/position/time", H5T_NATIVE_DOUBLE, {count});
  places.position = file.room(particles + "/position/value", H5T_NATIVE_DOUBLE, {count, disks, dimension});
  file.group(particles + "/velocity");
  share_times(particles + "/velocity");
  places.velocity = file.room(particles + "/velocity/value", H5T_NATIVE_DOUBLE, {count, disks, dimension});
  file.dataset(particles + "/species", H5T_NATIVE_INT32, {disks}, std::vector<std::int32_t>(disks, 0).data());
  file.dataset(particles + "/radius", H5T_NATIVE_DOUBLE, {disks},
               std::vector<double>(disks, scene.diameter() / 2).data());

  file.group(box);
  file.attribute(box, "dimension", H5T_NATIVE_INT, {}, &form.dimension);
  std::string boundary;
  for (int axis = 0; axis < form.dimension; ++axis)
    boundary += axis == 0 || (axis == 1 && scene.geometry == Geometry::periodic) ? std::string("periodic")
                                                                                 : std::string("none\0\0\0\0", 8);
  file.attribute(box, "boundary", hdf5::text_type(8).get(), {dimension}, boundary.data());
  if (form.dimension == 2) {
    const std::array<double, 2> edges{scene.length(), 1};
    file.dataset(box + "/edges", H5T_NATIVE_DOUBLE, {2}, edges.data());
  } else {
    file.group(box + "/edges");
    share_times(box + "/edges");
    places.edges = file.room(box + "/edges/value", H5T_NATIVE_DOUBLE, {count, 3, 3});
  }

  file.group("/observables");
  const auto observable = [&](const std::string& name) {
    file.group("/observables/" + name);
    share_times("/observables/" + name);
    return file.room("/observables/" + name + "/value", H5T_NATIVE_DOUBLE, {count});
  };
  places.energy = observable("kinetic_energy");
  places.temperature = observable("granular_temperature");
  file.close();
  return places;
}

/// Makes sure that the disk has room, while nothing depends on it.
void require_room(const std::filesystem::path& path, std::size_t bytes) {
  FileDescriptor file(path, O_WRONLY | O_CREAT | O_TRUNC);
  int error = EINTR;
  while (error == EINTR) error = ::posix_fallocate(file.get(), 0, static_cast<off_t>(bytes));
  if (error != 0) throw_system_error("cannot write " + path.string(), error);
  file.close();
}

/// Puts the states one after the other where the layout has room for them.
class StateFiller {
 public:
  StateFiller(const std::filesystem::path& path, const Places& places, const Scene& scene, int bins, int dimension)
      : file_(path, O_WRONLY), places_(places), scene_(scene), bins_(bins), dimension_(dimension) {}

  void add(const Snapshot& s) {
    const Moment moment = moment_of(s.state, bins_);
    put(places_.step, &done_);
    put(places_.time, &s.time);
    put(places_.position, vectors(s.state.position));
    put(places_.velocity, vectors(s.state.velocity));
    put(places_.energy, &moment.energy);
    put(places_.temperature, &moment.temperature);
    if (dimension_ == 3) {
      const std::array<double, 9> edges{scene_.length(), 0, 0, 0, 1, 0, 0, 0, scene_.diameter()};
      put(places_.edges, edges.data());
    }
    ++done_;
  }
  void close() { file_.close(); }

 private:
  const double* vectors(const std::vector<Vec2>& plane) {
    flat_.clear();
    for (const Vec2 v : plane) {
      flat_.insert(flat_.end(), {v.x, v.y});
      if (dimension_ == 3) flat_.push_back(0);
    }
    return flat_.data();
  }
  void put(const Place& place, const void* values) {
    if (::lseek(file_.get(), place.begin + done_ * place.bytes_per_state, SEEK_SET) < 0)
      throw_system_error("cannot write the states", errno);
    file_.write({static_cast<const char*>(values), static_cast<std::size_t>(place.bytes_per_state)});
  }

  FileDescriptor file_;
  Places places_;
  const Scene& scene_;
  int bins_, dimension_;
  std::int64_t done_ = 0;
  std::vector<double> flat_;
};

}  // namespace

void write_h5md(const ExportedStates& states, const H5mdForm& form, const std::filesystem::path& path,
                const std::function<void(int)>& shown) {
  const Scene& scene = states.source().scene;
  const auto disks = static_cast<std::size_t>(scene.particles), dimension = static_cast<std::size_t>(form.dimension);
  const std::size_t bytes = states.count() * (2 * disks * dimension + 13) * 8 + 12 * disks + (std::size_t{1} << 16);
  write_atomically(path, [&](const std::filesystem::path& part) {
    require_room(part, bytes);
    Places places{};
    try {
      const hdf5::Quiet quiet;
      places = write_layout(part, states, form);
    } catch (const hdf5::Failure& failure) {
      throw StorageError("cannot write " + path.string(), failure.why, "choose another output");
    }
    StateFiller filler(part, places, scene, states.source().run.bins, form.dimension);
    int done = 0;
    states.show_all([&](const Snapshot& s) {
      filler.add(s);
      shown(++done);
    });
    filler.close();
  });
}

std::string name_of_user() {
  const passwd* user = ::getpwuid(::getuid());
  if (user == nullptr) return "unknown";
  const std::string full(user->pw_gecos != nullptr ? user->pw_gecos : "");
  const std::string name = full.substr(0, full.find(','));
  return name.empty() ? user->pw_name : name;
}

}  // namespace gpf
