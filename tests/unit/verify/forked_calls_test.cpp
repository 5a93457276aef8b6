#include "verify/forked_calls.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <csignal>
#include <map>
#include <new>
#include <stdexcept>
#include <string>

namespace gpf {
namespace {

std::map<std::size_t, ForkedAnswer> answers_of(std::size_t count, int jobs,
                                               const std::function<std::string(std::size_t)>& f) {
  std::map<std::size_t, ForkedAnswer> answers;
  const bool ended = forked_calls(count, jobs, f, [&](std::size_t k, const ForkedAnswer& answer) {
    BOOST_TEST(answers.emplace(k, answer).second);  // each once
  });
  BOOST_TEST(ended);
  BOOST_TEST(answers.size() == count);
  return answers;
}

bool no_child_is_left() { return ::waitpid(-1, nullptr, WNOHANG) < 0; }

BOOST_AUTO_TEST_SUITE(forked_calls_test)

BOOST_AUTO_TEST_CASE(long_answers_come_whole) {
  for (const int jobs : {1, 2, 7}) {
    const auto answers = answers_of(5, jobs, [](std::size_t k) { return std::string(200'000 * k, 'a') + "end"; });
    for (const auto& [k, answer] : answers) {
      BOOST_TEST(static_cast<int>(answer.status) == 0);
      BOOST_TEST(answer.text.size() == 200'000 * k + 3);
      BOOST_TEST(answer.text.ends_with("end"));
    }
  }
  BOOST_TEST(answers_of(0, 2, [](std::size_t) { return ""; }).empty());
}

BOOST_AUTO_TEST_CASE(only_processes_of_their_own_with_more_than_one_job) {
  const auto process = [](std::size_t) { return std::to_string(::getpid()); };
  BOOST_TEST(answers_of(1, 1, process).at(0).text == std::to_string(::getpid()));
  const auto answers = answers_of(2, 2, process);
  BOOST_TEST(answers.at(0).text != answers.at(1).text);
  BOOST_TEST(answers.at(0).text != std::to_string(::getpid()));
}

BOOST_AUTO_TEST_CASE(what_is_thrown_is_an_answer_and_so_is_a_crash) {
  for (const int jobs : {1, 2}) {
    const auto answers = answers_of(4, jobs, [](std::size_t k) -> std::string {
      if (k == 0) throw InputError("a", "b", "c");
      if (k == 1) throw std::bad_alloc();
      if (k == 2) throw std::runtime_error("odd");
      return "fine";
    });
    BOOST_TEST(answers.at(0).text.find("a") != std::string::npos);
    BOOST_TEST(static_cast<int>(answers.at(0).status) == static_cast<int>(ExitStatus::bad_input));
    BOOST_TEST(answers.at(1).text.find("memory ran out") != std::string::npos);
    BOOST_TEST(static_cast<int>(answers.at(1).status) == static_cast<int>(ExitStatus::storage));
    BOOST_TEST(answers.at(2).text == "odd");
    BOOST_TEST(static_cast<int>(answers.at(2).status) == static_cast<int>(ExitStatus::physics));
    BOOST_TEST(answers.at(3).text == "fine");
  }
  const auto killed = answers_of(1, 2, [](std::size_t) -> std::string {
    ::raise(SIGKILL);
    return "";
  });
  BOOST_TEST(killed.at(0).text.find("signal 9") != std::string::npos);
  BOOST_TEST(static_cast<int>(killed.at(0).status) == static_cast<int>(ExitStatus::storage));
}

BOOST_AUTO_TEST_CASE(a_stop_or_an_exception_ends_the_processes) {
  const auto forever = [](std::size_t k) -> std::string {
    while (k > 0) ::pause();
    return "first";
  };
  volatile std::sig_atomic_t stop = 0;
  int seen = 0;
  const auto stop_after_one = [&](std::size_t, const ForkedAnswer&) {
    ++seen;
    stop = 1;
  };
  BOOST_TEST(!forked_calls(3, 2, forever, stop_after_one, &stop));
  BOOST_TEST(seen == 1);
  BOOST_TEST(no_child_is_left());
  const auto fail = [](std::size_t, const ForkedAnswer&) { throw StorageError("a", "b", "c"); };
  BOOST_CHECK_THROW(forked_calls(3, 2, forever, fail), StorageError);
  BOOST_TEST(no_child_is_left());
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
}  // namespace gpf
