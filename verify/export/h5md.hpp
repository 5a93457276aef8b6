// States as an H5MD file (de Buyl, Colberg & Hofling, Comput. Phys. Commun. 185, 1546 (2014)), version 1.1.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "verify/export/states.hpp"

namespace gpf {

struct H5mdForm {
  int dimension = 3;   ///< 2, or 3 for programs that know nothing else: z = 0 in a box of one diameter
  std::string author;  ///< H5MD wants a name
};

/// Writes the states, atomically:
/// /particles/disks/{position,velocity}/{step,time,value [states][disks][dimension]}, species (0) and radius of
/// the disks, and the box: its edges L, W (2-D), or at each time the three vectors L, W, diameter (3-D);
/// /observables/{kinetic_energy,granular_temperature} of each state, per disk: <c.c>/2, and <u.u>/2 about the mean of
/// the bin; /parameters: the scene as text, where the states come from, the diameter, and the record's trace hash.
/// `step` counts the states.
/// No units are given: W = m = 1. Positions and velocities are as they were, to the last bit.
///
/// Memory is that of one state. `shown` is told how many states are done. Throws StorageError, and what
/// ExportedStates::show_all throws.
void write_h5md(const ExportedStates& states, const H5mdForm& form, const std::filesystem::path& path,
                const std::function<void(int)>& shown);

/// The real name of who runs the program, or else the name that the system knows.
std::string name_of_user();

}  // namespace gpf
