"""An #include against the arrows of .ci/rooms is found."""
import unittest

from tree import TreeTest

ROOMS = """# Bottom first.
kernels/walk ->
core/grid -> kernels/walk
grid.h in core/grid
core/plan -> core/grid
planner.h in core/plan
"""


class CheckRooms(TreeTest):
    def setUp(self):
        super().setUp()
        self.write(".ci/rooms", ROOMS)
        self.write("kernels/walk/walk.h", "#include <vector>\n")
        self.write("core/lasius/grid.h", '#include "lasius/export.h"\n')
        self.write("core/grid/cells.h", '#include "kernels/walk/walk.h"\n#include "lasius/grid.h"\n')
        self.write("core/lasius/planner.h", '#include "lasius/grid.h"\n')
        self.write("core/plan/planner.cpp",
                   '#include "lasius/planner.h"\n#include "core/grid/cells.h"\n')

    def fails(self, *sentences):
        return self.assert_fails("check_rooms", *sentences)

    def test_a_tree_that_follows_the_arrows(self):
        self.assert_passes("check_rooms")

    def test_an_include_that_climbs(self):
        self.write("core/grid/grid.cpp", '#include <vector>\n\n #  include "core/plan/search.h"\n')
        self.fails('core/grid/grid.cpp:3: core/grid may not include "core/plan/search.h"')

    def test_a_public_header_counts_as_of_its_room(self):
        self.write("core/grid/grid.cpp", '#include "lasius/planner.h"\n')
        self.fails('core/grid/grid.cpp:1: core/grid may not include "lasius/planner.h" of core/plan')

    def test_a_public_header_that_climbs(self):
        self.write("core/lasius/grid.h", '#include "lasius/planner.h"\n')
        self.fails('lasius/grid.h:1: core/grid may not include "lasius/planner.h"')

    def test_a_public_header_in_angle_brackets(self):
        self.write("core/grid/grid.cpp", "#include <lasius/planner.h>\n")
        self.fails('core/grid may not include "lasius/planner.h"')

    def test_a_header_of_a_folder_that_is_no_room(self):
        include = '#include "bench/peer.h"\n'
        self.write("core/plan/peer.cpp", include)
        self.fails('core/plan/peer.cpp:1: "bench/peer.h" is in no room')
        self.write(".ci/rooms", ROOMS + "bench/peer.h in core/plan\n")
        self.assert_passes("check_rooms")
        self.write("core/grid/peer.cpp", include)
        self.fails('core/grid/peer.cpp:1: core/grid may not include "bench/peer.h" of core/plan')

    def test_an_arrow_is_not_passed_on(self):
        self.write("core/plan/search.cpp", '#include "kernels/walk/walk.h"\n')
        self.fails('core/plan may not include "kernels/walk/walk.h" of kernels/walk')

    def test_an_include_that_is_not_written_from_the_root(self):
        self.write("core/grid/grid.cpp", '#include "cells.h"\n')
        self.fails('core/grid/grid.cpp:1: "cells.h" is in no room')

    def test_an_include_by_way_of_the_folder_above(self):
        self.write("core/grid/grid.cpp", '#include "core/grid/../plan/search.h"\n')
        self.fails('core/grid/grid.cpp:1: "core/grid/../plan/search.h"')

    def test_a_file_without_a_room(self):
        self.write("core/attic/old.h", "")
        self.write("core/lasius/nobody.h", "")
        self.fails("core/attic/old.h: is in no room", "lasius/nobody.h: is in no room")

    def test_an_arrow_upwards(self):
        self.write(".ci/rooms", "core/grid -> core/plan\ncore/plan ->\n")
        self.fails("core/grid -> core/plan: not a room above it")

    def test_a_room_named_twice(self):
        self.write(".ci/rooms", ROOMS + "core/grid -> core/plan\n")
        self.fails("core/grid: named twice")

    def test_a_line_that_says_nothing(self):
        self.write(".ci/rooms", ROOMS + "core/genetic\n")
        self.fails(".ci/rooms:7: neither ROOM -> ROOM...")


if __name__ == "__main__":
    unittest.main()
