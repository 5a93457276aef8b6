#include "verify/audit/commit_check.hpp"

#include "gpf/base/error.hpp"
#include "verify/audit/baseline.hpp"
#include "verify/audit/git.hpp"

namespace gpf {

CommitCheck check_last_commit() {
  CommitCheck check;
  if (!git({"rev-parse", "--verify", "--quiet", "HEAD"})) {
    check.skipped = "there is no git repository here";
    return check;
  }
  if (!git({"rev-parse", "--verify", "--quiet", "HEAD^1"})) {
    check.skipped = "the last commit has no parent here";
    return check;
  }
  const auto before = git({"show", "HEAD^1:reference/baseline.csv"}),
             after = git({"show", "HEAD:reference/baseline.csv"});
  if (!before) {
    check.skipped = "the parent of the last commit has no reference/baseline.csv";
    return check;
  }
  if (!after)
    throw InputError("the last commit has no reference/baseline.csv", "its parent has one",
                     "gpf audit --write-baseline writes it");
  const auto trailers = git({"log", "--format=%(trailers:key=Physics-Change,valueonly)", "HEAD^1..HEAD"});
  check.declared = strongest_declared(trailers.value_or(""));
  if (*before != *after)
    check.shown = least_class(parse_baseline(*before, "HEAD^1:reference/baseline.csv"),
                              parse_baseline(*after, "HEAD:reference/baseline.csv"));
  return check;
}

}  // namespace gpf
