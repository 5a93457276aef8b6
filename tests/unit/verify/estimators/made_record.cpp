#include "unit/verify/estimators/made_record.hpp"

#include "gpf/event/physics_version.hpp"
#include "gpf/scene/scene_file.hpp"
#include "gpf/scene/start.hpp"

namespace gpf::test {

Record made_record(const std::string& text, const std::function<void(const SetTally&)>& fill, std::size_t blocks) {
  const SceneFile file = parse_scene(text, "test");
  Record r;
  r.scene_text = text;
  r.scene = file.scene;
  r.run = file.run;
  r.physics_version = physics_version;
  r.final_state = start_state(file.scene);
  r.blocks = blocks;
  const TallyLayout layout(r.run);
  std::vector<double> row(layout.size(), 0.0);
  const SetTally set = [&](Tally tally, int k, double value) { row[layout.at(tally, k)] = value; };
  set(Tally::measured_time, 0, 1);
  set(Tally::samples, 0, 1);
  fill(set);
  for (std::size_t b = 0; b < blocks; ++b) r.sums.insert(r.sums.end(), row.begin(), row.end());
  return r;
}

}  // namespace gpf::test
