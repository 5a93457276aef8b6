// The Python module gpf.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gpf/base/error.hpp"
#include "gpf/base/hash.hpp"
#include "gpf/flow/range.hpp"
#include "gpf/io/provenance.hpp"
#include "gpf/io/record.hpp"
#include "gpf/measure/bins.hpp"
#include "gpf/scene/scene_file.hpp"
#include "verify/simulate.hpp"

namespace py = pybind11;

namespace gpf {
namespace {

/// A text that begins with a table or has several lines is a scene, anything else is the path of one.
SceneFile read_scene(const std::filesystem::path& scene) {
  const std::string text = scene.string();
  return text.find('\n') != std::string::npos || text.starts_with('[') ? parse_scene(text, "scene") : load_scene(scene);
}

/// Lets Python see to its signals and other threads, about five times a second.
void heed_python(const Progress&) {
  const py::gil_scoped_acquire gil;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

std::shared_ptr<Record> run(const std::filesystem::path& scene, std::optional<std::int64_t> seed) {
  SceneFile file = read_scene(scene);
  if (seed && *seed < 0) throw InputError("the seed is negative", "seeds count from 0", "choose another one");
  if (seed) file.scene.seed = static_cast<std::uint64_t>(*seed);
  for (const std::string& warning : range_warnings(file.scene, {}))
    if (PyErr_WarnEx(PyExc_UserWarning, warning.c_str(), 1) != 0) throw py::error_already_set();
  SimulationOptions options;
  options.progress = heed_python;
  options.command = {"python", "gpf.run"};
  const py::gil_scoped_release others;
  return std::make_shared<Record>(*simulate(file, options));
}

py::array_t<double> vectors(const std::vector<Vec2>& values) {
  py::array_t<double> array({values.size(), std::size_t{2}});
  auto at = array.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < at.shape(0); ++i) {
    at(i, 0) = values[static_cast<std::size_t>(i)].x;
    at(i, 1) = values[static_cast<std::size_t>(i)].y;
  }
  return array;
}

py::array_t<double> bin_centres(const Record& record) {
  const Bins bins(record.run.bins);
  py::array_t<double> array(bins.count());
  for (int b = 0; b < bins.count(); ++b) array.mutable_at(b) = bins.centre(b);
  return array;
}

py::dict quantities(const Record& record) {
  const py::object estimate = py::module_::import("gpf").attr("Estimate");
  py::dict all;
  for (const auto& [name, measured] : quantities_of(record)) {
    const auto numbers = [&values = measured.values, several = measured.several](double Estimate::*part) -> py::object {
      if (!several) return py::float_(values.front().*part);
      py::array_t<double> array(static_cast<py::ssize_t>(values.size()));
      for (std::size_t k = 0; k < values.size(); ++k) array.mutable_at(k) = values[k].*part;
      return array;
    };
    all[py::str(name)] = estimate(numbers(&Estimate::mean), numbers(&Estimate::error));
  }
  return all;
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const InputError& error) {
    PyErr_SetString(PyExc_ValueError, error.what());
  } catch (const StorageError& error) {
    PyErr_SetString(PyExc_OSError, error.what());
  }  // the rest, PhysicsError among it, becomes RuntimeError
}

constexpr const char* run_help = R"(run(scene, seed=None) -> Record

Simulates a scene: the text of a scene file, or the path of one. `seed` replaces that of the scene. The same scene and
seed give the trajectory of `gpf run`, bit by bit. Other threads run meanwhile, and Ctrl-C ends it.
Raises ValueError for a scene that cannot be used, OSError for a file that cannot be read, RuntimeError when the engine
meets a state that it must not continue from. Warns (UserWarning) of a scene beyond the range that the method was found
to hold in.)";

void define(py::module_& m) {
  m.doc() =
      "Granular Poiseuille flow, event by event. Units: W = m = 1; time in W/v with v = sqrt(g W), or the unit of the "
      "start velocities without gravity.";
  m.attr("__version__") = build_provenance().version;
  m.attr("Estimate") =
      py::module_::import("collections").attr("namedtuple")("Estimate", "mean error", py::arg("module") = "gpf");
  py::register_exception_translator(translate);

  py::class_<Record, std::shared_ptr<Record>>(m, "Record", "A finished run.")
      .def_property_readonly("quantities", &quantities,
                             "dict: name -> Estimate(mean, error) of all that was measured, as `gpf run --json` prints "
                             "it. Profiles are arrays over the bins (density_power_*: over wavenumbers 1, 2, ...), "
                             "numbers of the whole flow are floats; nan: not measured.")
      .def_property_readonly("bins", &bin_centres, "Heights of the bins' centres, array [bins].")
      .def_property_readonly(
          "positions", [](const Record& r) { return vectors(r.final_state.position); }, "At the end, array [disks, 2].")
      .def_property_readonly(
          "velocities", [](const Record& r) { return vectors(r.final_state.velocity); },
          "At the end, array [disks, 2].")
      .def_readonly("time", &Record::time, "Of the end.")
      .def_property_readonly(
          "trace_hash", [](const Record& r) { return hexadecimal(r.trace_hash); },
          "Of all collisions, sixteen hexadecimal digits.")
      .def_property_readonly(
          "scene", [](const Record& r) { return canonical_text(r.scene, r.run); },
          "The scene and its run as the text of a scene file, seed and defaults included; run() takes it.")
      .def(
          "write", [](const Record& r, const std::filesystem::path& path) { write_record(r, path); }, py::arg("path"),
          "Writes the record as `gpf run -o` does; a file that is there is replaced. Raises OSError.")
      .def("__repr__", [](const Record& r) {
        return "<gpf.Record of " + std::to_string(r.scene.particles) + " disks, trace hash " +
               hexadecimal(r.trace_hash) + ">";
      });

  m.def("run", &run, py::arg("scene"), py::arg("seed") = py::none(), run_help);
  m.def(
      "read", [](const std::filesystem::path& path) { return std::make_shared<Record>(read_record(path)); },
      py::arg("path"),
      "read(path) -> Record\n\nReads the record that `gpf run` or Record.write wrote. Raises OSError when the file "
      "cannot "
      "be read, ValueError when it is no record.");
}

}  // namespace
}  // namespace gpf

PYBIND11_MODULE(gpf, m) { gpf::define(m); }
