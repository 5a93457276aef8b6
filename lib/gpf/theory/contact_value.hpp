// The pair correlation at contact of hard disks, g(d+), as approximations give it.
#pragma once

namespace gpf {

/// Henderson, Mol. Phys. 30, 971 (1975), as thesis eq 4.11: (1 - 7 nu/16)/(1 - nu)^2. The Z that follows is too large:
/// by .025 % at nu = .3, .45 % at .5, 2.2 % at .65.
constexpr double henderson_contact_value(double nu) { return (1 - 7 * nu / 16) / ((1 - nu) * (1 - nu)); }

/// d ln g/d ln nu of the same.
constexpr double henderson_contact_slope(double nu) { return nu * (2 / (1 - nu) - 7 / (16 - 7 * nu)); }

/// Luding's g4, PRE 63, 042201 (2001): Henderson's less nu^3/(128 (1 - nu)^4). Z within .075 % up to nu = .60,
/// -.11 % at .63.
constexpr double luding_contact_value(double nu) {
  return henderson_contact_value(nu) - nu * nu * nu / (128 * (1 - nu) * (1 - nu) * (1 - nu) * (1 - nu));
}

/// Z = pA/(NT) of elastic disks with contact value g: 1 + 2 nu g. With restitution e the second term takes the factor
/// (1 + e)/2 (Enskog).
constexpr double compressibility_from_contact(double nu, double contact_value) { return 1 + 2 * nu * contact_value; }

/// The contact value that belongs to Z: (Z - 1)/(2 nu), for nu > 0.
constexpr double contact_from_compressibility(double nu, double compressibility) {
  return (compressibility - 1) / (2 * nu);
}

}  // namespace gpf
