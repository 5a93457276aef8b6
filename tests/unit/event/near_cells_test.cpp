// Neighbours of cells along an axis against their definition.
#include "gpf/event/near_cells.hpp"

#include <boost/test/unit_test.hpp>
#include <vector>

using namespace gpf;
using Which = NearCellsOfAxis::Which;

namespace {

struct Expected {
  std::ptrdiff_t offset;
  double shift;
};

void expect(const NearCells& found, const std::vector<Expected>& expected) {
  BOOST_REQUIRE(found.count == expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    BOOST_TEST(found.offset[k] == expected[k].offset);
    BOOST_TEST(found.shift[k] == expected[k].shift);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(near_cells)

BOOST_AUTO_TEST_CASE(inside_and_at_the_ends_of_an_axis_that_closes_on_itself) {
  for (const std::ptrdiff_t stride : {1, 10}) {
    const NearCellsOfAxis axis(5, stride, 1.3);
    for (const Index inner : {1, 2, 3}) {
      expect(axis(inner, Which::before), {{-stride, 0}});
      expect(axis(inner, Which::after), {{stride, 0}});
      expect(axis(inner, Which::both), {{-stride, 0}, {0, 0}, {stride, 0}});
    }
    expect(axis(0, Which::before), {{4 * stride, -1.3}});
    expect(axis(0, Which::after), {{stride, 0}});
    expect(axis(0, Which::both), {{4 * stride, -1.3}, {0, 0}, {stride, 0}});
    expect(axis(4, Which::before), {{-stride, 0}});
    expect(axis(4, Which::after), {{-4 * stride, 1.3}});
    expect(axis(4, Which::both), {{-stride, 0}, {0, 0}, {-4 * stride, 1.3}});
  }
}

BOOST_AUTO_TEST_CASE(an_axis_between_walls_ends) {
  const NearCellsOfAxis axis(4, 7, 0);
  expect(axis(0, Which::before), {});
  expect(axis(0, Which::both), {{0, 0}, {7, 0}});
  expect(axis(2, Which::both), {{-7, 0}, {0, 0}, {7, 0}});
  expect(axis(3, Which::after), {});
  expect(axis(3, Which::both), {{-7, 0}, {0, 0}});
}

BOOST_AUTO_TEST_CASE(one_and_two_cells_between_walls) {
  const NearCellsOfAxis one(1, 7, 0), two(2, 7, 0);
  expect(one(0, Which::both), {{0, 0}});
  expect(one(0, Which::before), {});
  expect(one(0, Which::after), {});
  expect(two(0, Which::both), {{0, 0}, {7, 0}});
  expect(two(1, Which::both), {{-7, 0}, {0, 0}});
}

BOOST_AUTO_TEST_CASE(three_cells_round_a_period_are_all_near_each_other) {
  const NearCellsOfAxis axis(3, 1, 2);
  expect(axis(0, Which::both), {{2, -2}, {0, 0}, {1, 0}});
  expect(axis(1, Which::both), {{-1, 0}, {0, 0}, {1, 0}});
  expect(axis(2, Which::both), {{-1, 0}, {0, 0}, {-2, 2}});
}

BOOST_AUTO_TEST_SUITE_END()
