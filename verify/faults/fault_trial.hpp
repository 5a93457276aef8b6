// One fault, tried: which claims of a tier catch it.
#pragma once

#include <csignal>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "verify/claim.hpp"
#include "verify/faults/fault.hpp"

namespace gpf {

enum class Caught {
  no,         ///< the verdict is the expected one, as if nothing were wrong
  undecided,  ///< the claim needs more data, or a health check fails as it might by chance
  health,     ///< a health check fails, by chance less often than alarm_chance
  yes         ///< decided against its expectation; or its runs or its estimator stopped with an error
};
inline constexpr double alarm_chance = 1e-5;  ///< with some thousand pairs of claim and fault: none by chance
constexpr bool is_caught(Caught caught) { return caught >= Caught::health; }

std::string_view name_of(Caught caught);

/// What became of the claims of a tier with the fault at work.
struct FaultTrial {
  std::string fault;
  double dose = 0;
  Tier tier = Tier::quick;
  struct Answer {
    Caught caught = Caught::no;
    std::string words;        ///< the verdict's summary, or what went wrong
    std::uint64_t asked = 0;  ///< hash of the claim file that was judged and of the scenes that it reads
  };
  std::map<std::string, Answer> claims;
};

struct FaultOptions {
  Tier tier = Tier::quick;
  std::filesystem::path store = "records", reference = "reference";
  int jobs = 1;
  const volatile std::sig_atomic_t* stop = nullptr;
};

/// Judges the claims with every run made with the fault. Answers that the store has, of the same claim file, scenes,
/// dose and sources, are taken from there (<store>/faults/<fault>/); records are removed when they have been judged.
/// Nothing when it was stopped by a signal. Throws as validate(), StorageError when a run or verdict could not be
/// written, and InputError for a dose that is none.
std::optional<FaultTrial> try_fault(const Fault& fault, double dose, const std::vector<Claim>& claims,
                                    const FaultOptions& options);

/// Throws InputError unless every claim is as expected when nothing is wrong. Nothing is said of a run that was
/// stopped: false.
bool all_green_without_fault(const std::vector<Claim>& claims, const FaultOptions& options);

/// The claims of a tier that read records: the others run the engine themselves, where no fault reaches them.
std::vector<Claim> claims_with_records(const std::filesystem::path& reference, Tier tier);

/// The smallest dose that a claim catches lies between the two; `missed` is 0 when everything down to a 2^-14th of the
/// fault's dose was caught.
struct SmallestDose {
  std::string fault, claim;
  double missed = 0, caught = 0;
};

/// By bisection on a logarithmic scale, down to a factor 1.2, from the fault's dose, assuming that larger doses are
/// caught more surely. Nothing when it was stopped. Throws InputError when the claim does not catch the fault's dose.
std::optional<SmallestDose> smallest_dose(const Fault& fault, const Claim& claim, const FaultOptions& options);

}  // namespace gpf
