"""An #include against the arrows of .ci/modules is found."""
import unittest

from tree import TreeTest

MODULES = """# Bottom first.
kernels/walk ->
core/grid -> kernels/walk
grid.h in core/grid
core/plan -> core/grid
planner.h in core/plan
tests/oracle -> lasius/grid.h
tools/* -> lasius/
tools/draw ->
bench -> lasius/ core/plan tests/oracle
tests/MODULE -> tests/oracle
tests/core/grid -> lasius/
"""


class CheckModules(TreeTest):
    def setUp(self):
        super().setUp()
        self.write(".ci/modules", MODULES)
        self.write("kernels/walk/walk.h", "#include <vector>\n")
        self.write("core/lasius/grid.h", '#include "lasius/export.h"\n')
        self.write("core/grid/cells.h", '#include "kernels/walk/walk.h"\n#include "lasius/grid.h"\n')
        self.write("core/lasius/planner.h", '#include "lasius/grid.h"\n')
        self.write("core/plan/planner.cpp",
                   '#include "lasius/planner.h"\n#include "core/grid/cells.h"\n')

    def fails(self, *sentences):
        return self.assert_fails("check_modules", *sentences)

    def test_a_tree_that_follows_the_arrows(self):
        self.assert_passes("check_modules")

    def test_an_include_that_climbs(self):
        self.write("core/grid/grid.cpp", '#include <vector>\n\n #  include "core/plan/search.h"\n')
        self.fails('core/grid/grid.cpp:3: core/grid may not include "core/plan/search.h"')

    def test_a_public_header_counts_as_of_its_module(self):
        self.write("core/grid/grid.cpp", '#include "lasius/planner.h"\n')
        self.fails('core/grid/grid.cpp:1: core/grid may not include "lasius/planner.h" of core/plan')

    def test_a_public_header_that_climbs(self):
        self.write("core/lasius/grid.h", '#include "lasius/planner.h"\n')
        self.fails('lasius/grid.h:1: core/grid may not include "lasius/planner.h"')

    def test_a_public_header_in_angle_brackets(self):
        self.write("core/grid/grid.cpp", "#include <lasius/planner.h>\n")
        self.fails('core/grid may not include "lasius/planner.h"')

    def test_an_arrow_is_not_passed_on(self):
        self.write("core/plan/search.cpp", '#include "kernels/walk/walk.h"\n')
        self.fails('core/plan may not include "kernels/walk/walk.h" of kernels/walk')

    def test_an_include_that_is_not_written_from_the_root(self):
        self.write("core/grid/grid.cpp", '#include "cells.h"\n')
        self.fails('core/grid/grid.cpp:1: "cells.h" is in no module')

    def test_an_include_by_way_of_the_folder_above(self):
        self.write("core/grid/grid.cpp", '#include "core/grid/../plan/search.h"\n')
        self.fails('core/grid/grid.cpp:1: "core/grid/../plan/search.h"')

    def test_a_file_without_a_module(self):
        self.write("core/attic/old.h", "")
        self.write("core/lasius/nobody.h", "")
        self.fails("core/attic/old.h: is in no module", "lasius/nobody.h: is in no module")

    def test_modules_of_a_top_folder_include_what_all_of_them_may(self):
        self.write("tools/draw/draw.cpp", '#include "lasius/planner.h"\n')
        self.assert_passes("check_modules")
        self.write("tools/draw/draw.cpp", '#include "core/plan/search.h"\n')
        self.fails('tools/draw/draw.cpp:1: tools/draw may not include "core/plan/search.h"')

    def test_tests_include_what_their_module_may_and_its_tests(self):
        self.write("tests/core/plan/search_test.cpp",
                   '#include "core/plan/search.h"\n#include "core/grid/cells.h"\n#include "lasius/planner.h"\n'
                   '#include "tests/core/grid/cells.h"\n#include "tests/oracle/optimum.h"\n')
        self.assert_passes("check_modules")

    def test_tests_against_the_arrows(self):
        self.write("tests/core/plan/search_test.cpp",
                   '#include "kernels/walk/walk.h"\n#include "tools/draw/draw.h"\n#include "bench/clocks.h"\n')
        self.write("tests/kernels/walk/walk_test.cpp", '#include "tests/core/grid/cells.h"\n')
        self.fails('tests/core/plan/search_test.cpp:1: tests/core/plan may not include "kernels/walk/walk.h"',
                   'tests/core/plan/search_test.cpp:2: tests/core/plan may not include "tools/draw/draw.h"',
                   'tests/core/plan/search_test.cpp:3: tests/core/plan may not include "bench/clocks.h"',
                   'tests/kernels/walk/walk_test.cpp:1: tests/kernels/walk may not include "tests/core/grid/cells.h"')

    def test_a_line_of_its_own_adds_to_a_mirror(self):
        include = '#include "lasius/planner.h"\n'
        self.write("tests/core/grid/cells_test.cpp", include + '#include "core/grid/cells.h"\n')
        self.assert_passes("check_modules")
        self.write("tests/kernels/walk/walk_test.cpp", include)
        self.fails('tests/kernels/walk/walk_test.cpp:1: tests/kernels/walk may not include "lasius/planner.h"')

    def test_a_test_that_mirrors_no_module(self):
        self.write("tests/core/attic/old_test.cpp", "")
        self.fails("tests/core/attic/old_test.cpp: is in no module")

    def test_a_benchmark_against_the_arrows(self):
        self.write("bench/clocks.cpp", '#include "lasius/planner.h"\n#include "core/plan/search.h"\n')
        self.assert_passes("check_modules")
        self.write("bench/clocks.cpp", '#include "core/grid/cells.h"\n#include "tests/core/plan/plans.h"\n')
        self.fails('bench/clocks.cpp:1: bench may not include "core/grid/cells.h"',
                   'bench/clocks.cpp:2: bench may not include "tests/core/plan/plans.h"')

    def test_an_oracle_that_includes_the_library(self):
        self.write("tests/oracle/optimum.h", '#include "lasius/grid.h"\n')
        self.assert_passes("check_modules")
        self.write("tests/oracle/optimum.h", '#include "lasius/planner.h"\n#include "core/grid/cells.h"\n')
        self.fails('tests/oracle/optimum.h:1: tests/oracle may not include "lasius/planner.h" of core/plan',
                   'tests/oracle/optimum.h:2: tests/oracle may not include "core/grid/cells.h" of core/grid')

    def test_an_arrow_upwards(self):
        self.write(".ci/modules", "core/grid -> core/plan\ncore/plan ->\n")
        self.fails("core/grid -> core/plan: not a module above it")

    def test_a_mirror_arrow_upwards(self):
        self.write(".ci/modules", MODULES.replace("core/grid -> lasius/", "core/grid -> tests/core/plan"))
        self.fails("tests/core/grid -> tests/core/plan: not a module above it")

    def test_an_arrow_to_a_header_that_there_is_not(self):
        self.write(".ci/modules", MODULES + "docs/examples -> lasius/nobody.h\n")
        self.fails("docs/examples -> lasius/nobody.h: not a module above it")

    def test_an_arrow_to_a_header_of_a_module_that_has_none_such(self):
        self.write(".ci/modules", MODULES + "docs/examples -> core/grid/cells.h\n")
        self.assert_passes("check_modules")
        self.write(".ci/modules", MODULES + "docs/examples -> core/grid/nobody.h\n")
        self.fails("docs/examples -> core/grid/nobody.h: no such file")

    def test_a_module_named_twice(self):
        self.write(".ci/modules", MODULES + "core/grid -> core/plan\n")
        self.fails("core/grid: named twice")

    def test_a_line_that_says_nothing(self):
        self.write(".ci/modules", MODULES + "core/genetic\n")
        self.fails(".ci/modules:13: neither MODULE -> WHAT...")


if __name__ == "__main__":
    unittest.main()
