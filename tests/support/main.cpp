#include <boost/test/unit_test.hpp>

// Without BOOST_TEST_MODULE, which must be defined before the precompiled header: the same main() as Boost's.
int main(int argc, char* argv[]) {
  return boost::unit_test::unit_test_main([] { return true; }, argc, argv);
}
