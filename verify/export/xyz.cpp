#include "verify/export/xyz.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <iterator>
#include <string>

#include "gpf/io/atomic_file.hpp"
#include "gpf/io/file_descriptor.hpp"

namespace gpf {

void write_xyz(const ExportedStates& states, const std::filesystem::path& path, const std::function<void(int)>& shown) {
  const Scene& scene = states.source().scene;
  const std::string frame = fmt::format(
      "{}\nLattice=\"{} 0 0 0 1 0 0 0 {}\" pbc=\"T {} F\" Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1",
      scene.particles, scene.length(), scene.diameter(), scene.geometry == Geometry::periodic ? 'T' : 'F');
  const std::string radius = fmt::format("{}", scene.diameter() / 2);
  write_atomically(path, [&](const std::filesystem::path& part) {
    FileDescriptor file(part, O_WRONLY | O_CREAT | O_TRUNC);
    std::string text;
    int done = 0;
    states.show_all([&](const Snapshot& s) {
      text = fmt::format("{} Time={}\n", frame, s.time);
      for (std::size_t i = 0; i < s.state.position.size(); ++i) {
        const Vec2 r = s.state.position[i], v = s.state.velocity[i];
        fmt::format_to(std::back_inserter(text), "X {} {} 0 {} {} 0 {}\n", r.x, r.y, v.x, v.y, radius);
      }
      file.write(text);
      shown(++done);
    });
    file.close();
  });
}

}  // namespace gpf
