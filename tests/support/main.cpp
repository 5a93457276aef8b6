#define BOOST_TEST_MODULE gpf
#include <boost/test/unit_test.hpp>
