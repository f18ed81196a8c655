"""Pictures: there, whole, and of the right size."""
import os
import unittest
import xml.etree.ElementTree

from program import MAPS, ProgramTest

FAN = dict(map_file=os.path.join(MAPS, "fan400x200.map"), start="14,14", goal="380,179")
SVG = "{http://www.w3.org/2000/svg}"


class Pictures(ProgramTest):
    def svg(self, name):
        root = xml.etree.ElementTree.fromstring(self.read(name))
        self.assertEqual(root.tag, SVG + "svg")
        return root, (int(root.get("width").removesuffix("px")),
                      int(root.get("height").removesuffix("px")))

    def test_both_kinds_have_the_same_size(self):
        run = self.plan("--iterations", "12", "-o", "run.svg", "-o", "run.png", **FAN)
        self.assertEqual((run.code, run.err), (0, ""))
        root, size = self.svg("run.svg")
        self.assertEqual(self.png_size("run.png"), size)
        self.assertLessEqual(max(size), 2000)
        self.assertGreater(size[0], 1200)
        # Tracks at 10 and, for 50 and 120 were not reached, at the end; pheromone; map.
        self.assertEqual(len(list(root.iter(SVG + "image"))), 4)

    def test_the_iterations_of_the_tracks_can_be_chosen(self):
        self.plan("--iterations", "12", "--tracks", "3,6,9,12", "-o", "run.svg", **FAN)
        self.assertEqual(len(list(self.svg("run.svg")[0].iter(SVG + "image"))), 6)

    def test_a_run_without_iterations_has_the_map_alone(self):
        self.plan("-o", "run.svg", goal="4,2")
        self.assertEqual(len(list(self.svg("run.svg")[0].iter(SVG + "image"))), 1)

    def test_any_shape_of_map(self):
        for size in ("1x1", "300x1", "1x300", "2500x3", "3x2500", "2100x1500"):
            with self.subTest(size=size):
                self.run_program("generate", "open", "--size", size, "--density", "0", "-o", "m.pbm")
                run = self.plan("--iterations", "2", "-o", "m.png", map_file="m.pbm", goal="0,0")
                self.assertEqual(run.code, 0, run.err)
                self.assertLessEqual(max(self.png_size("m.png")), 2000)

    def test_a_picture_that_cannot_be_written(self):
        self.refused(self.plan("-o", "no/run.png"), 7, "no/run.png")


if __name__ == "__main__":
    unittest.main()
