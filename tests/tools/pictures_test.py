"""Pictures: there, whole, of the right size, with words for all that they show."""
import os
import unittest

from program import MAPS, SVG, ProgramTest

FAN = dict(map_file=os.path.join(MAPS, "fan400x200.map"), start="14,14", goal="380,179")
GRID = dict(map_file=os.path.join(MAPS, "grid20a.map"), start="0,0", goal="19,19")


class Pictures(ProgramTest):
    def svg(self, name):
        root = self.svg_root(name)
        return root, (int(root.get("width").removesuffix("px")),
                      int(root.get("height").removesuffix("px")))

    def panels(self, name):
        """Panels that show the map."""
        return len(list(self.svg(name)[0].iter(SVG + "image")))

    def drawn(self, *arguments, algorithm="fan2004", **question):
        run = self.plan("--algorithm", algorithm, *arguments, "-q", "-o", "run.svg",
                        **(question or GRID))
        self.assertEqual(run.err, "")
        return self.words("run.svg")

    def test_both_kinds_have_the_same_size(self):
        self.quiet(self.plan("--iterations", "12", "-o", "run.svg", "-o", "run.png", **FAN))
        root, size = self.svg("run.svg")
        self.assertEqual(self.png_size("run.png"), size)
        self.assertLessEqual(max(size), 2000)
        self.assertGreater(size[0], 1200)
        # Tracks of 1, 10 (the critical time) and 12, alone and up to them; pheromone; path.
        self.assertEqual(len(list(root.iter(SVG + "image"))), 8)

    def test_the_iterations_of_the_tracks_can_be_chosen(self):
        self.plan("--iterations", "12", "--tracks", "3,6,9,12", "-o", "run.svg", **FAN)
        self.assertEqual(self.panels("run.svg"), 10)

    def test_a_run_without_iterations_has_the_map_alone(self):
        self.plan("-o", "run.svg", goal="4,2")
        self.assertEqual(self.panels("run.svg"), 1)

    def test_there_is_a_legend_for_everything(self):
        text = self.drawn("--iterations", "12")
        self.holds(text, "start", "goal", "blocked", "ants through a cell in one iteration",
                   "sum over all iterations so far", "x, cells", "y, cells", "best path so far",
                   "mean tour, as walked", "shortest tour after the cut",
                   "pheromone after iteration 12", "white: less than")
        for iteration in (1, 10, 12):
            self.holds(text, f"iteration {iteration} alone: 10 of 10 ants arrive, mean tour",
                       f"all ants up to iteration {iteration}")

    def test_tours_are_cut_or_as_walked(self):
        names = [f"{name} tour{what}" for what in (", as walked", " after the cut") for name in ("mean", "shortest")]
        for cut, shown in (("own-cells", [True, False, True, True]), ("none", [True, True, False, False])):
            text = self.drawn("--set", f"walk_cut={cut}", "--iterations", "3")
            self.assertEqual([name in text for name in names], shown, cut)

    def test_an_optimum_that_the_best_path_lies_on_is_said_to_be_reached(self):
        text = self.drawn("--gap", "--iterations", "3", algorithm="as", **GRID)
        self.holds(text, "optimum of its own moves 33.90 cells, reached in iteration ")
        self.assertEqual(text.count("reached in iteration"), 1)

    def test_obstacles_and_what_they_grow_by_have_two_greys(self):
        grown, wall = (212, 214, 218), (148, 154, 163)
        for radius in (0, 3):
            text = self.drawn("--radius", str(radius), "-o", "run.png", algorithm="exact",
                              **{**FAN, "goal": "60,63"})
            colours = {pixel for row in self.png_pixels("run.png") for pixel in row}
            self.assertIn(wall, colours)
            self.assertEqual(grown in colours, radius > 0)
            self.assertEqual("no place for the centre: nearer than 3.00 cells" in text, radius > 0)

    def test_unknown_cells_have_a_tone_of_their_own(self):
        self.write("world.pgm", b"P5 9 9 255\n" + (b"\xfe" * 6 + b"\xcd" * 2 + b"\x00") * 9)
        self.write("world.yaml", "image: world.pgm\nresolution: 0.5\norigin: [0, 0, 0]\nnegate: 0\n"
                   "occupied_thresh: 0.65\nfree_thresh: 0.196\n")
        for how, told in ((["--radius", "0.6"], "blocked"), (["--unknown-free"], "free")):
            text = self.drawn(*how, "-o", "run.png", map_file="world.yaml", start="2,2", goal="4,6", algorithm="exact")
            self.assertIn("unknown, counted as " + told, text)
            colours = {pixel for row in self.png_pixels("run.png") for pixel in row}
            self.assertLessEqual({(219, 201, 168), (148, 154, 163)}, colours)
        self.assertNotIn("unknown", self.drawn(map_file="small.map", goal="9,5"))

    def test_a_batch_says_how_many_paths_and_why_others_are_missing(self):
        self.write("q.tsv", "sx\tsy\tgx\tgy\n0\t0\t19\t19\n0\t0\t50\t50\n")
        self.quiet(self.run_program("batch", GRID["map_file"], "q.tsv", "-o", "run.svg"))
        text = self.words("run.svg")
        self.holds(text, "start", "goal", "1 path; answers: solved 1, invalid 1")
        self.assertNotIn("1 paths", text)

    def test_both_optima_are_named(self):
        text = self.drawn("--gap", "--iterations", "3", algorithm="acs", **GRID)
        self.holds(text, "any-angle optimum 31.21 cells", "optimum of its own moves 33.90 cells",
                   "above the any-angle optimum 31.21 cells", "the optimum of the algorithm's own moves")
        self.assertNotIn("optimum", self.drawn("--iterations", "3"))

    def test_a_terminal_index_is_named_so(self):
        text = self.drawn(algorithm="terminal-index", **GRID)
        self.holds(text, "terminal index after iteration", "white: unknown")
        self.assertNotIn("pheromone", text)

    def test_a_genetic_algorithm_has_no_ants(self):
        text = self.drawn(algorithm="grid-ga", **GRID)
        self.assertEqual(self.panels("run.svg"), 1)
        self.holds(text, "(a) path, length", "(b) convergence", "mean of the population")
        for word in ("ant ", "ants", "pheromone", "tracks"):
            self.assertNotIn(word, text)

    def test_a_name_is_whole_up_to_a_hundred_letters(self):
        for length, drawn in ((90, "m" * 90 + ".map"), (150, "m" * 99 + "\N{HORIZONTAL ELLIPSIS}")):
            name = "m" * length + ".map"
            self.write(name, self.read("small.map"))
            self.assertIn(drawn, self.drawn(map_file=name, goal="9,5", algorithm="exact").replace(" ", ""))

    def test_why_there_is_no_path(self):
        self.plan("-q", "-o", "run.svg", goal="4,2")
        self.assertIn("no path: the goal is unreachable", self.words("run.svg"))

    def test_an_unknown_border_is_left_out(self):
        rows = [[205] * 80 for _ in range(50)]
        for y in range(10, 30):
            rows[y][20:50] = [0] + [254] * 28 + [0]
        self.write("world.pgm", b"P5 80 50 255\n" + b"".join(map(bytes, rows)))
        self.write("world.yaml", "image: world.pgm\nresolution: 0.5\norigin: [-3, 2, 0]\n"
                   "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n")
        ends = dict(map_file="world.yaml", start="22,12", goal="45,25", algorithm="exact")
        note = "cropped to columns 18 to 51, rows 7 to 32: the rest, 78% of the map, has no free cell"
        self.assertIn(note + " (unknown or blocked)", self.drawn(**ends))
        self.assertNotIn("cropped", self.drawn("--unknown-free", **ends))
        ends.update(start="8.25,20.75", goal="19.75,14.25")
        self.holds(self.drawn("--frame", "world", **ends), note, "x, m", "y, m")
        self.assertNotIn("cropped", self.drawn(map_file="small.map", goal="9,5"))

    def test_marks_hide_nothing_of_the_path(self):
        self.plan("--algorithm", "exact", "-o", "run.png", goal="9,0")
        pixels = self.png_pixels("run.png")
        red = [(x, y) for y, row in enumerate(pixels) for x, p in enumerate(row)
               if p[0] > 200 and max(p[1], p[2]) < 60]
        # A line from the middle of the first cell of ten to that of the last, on 900 pixels; that of
        # the legend is higher.
        low = max(y for _, y in red)
        line = sorted(x for x, y in red if y == low)
        self.assertEqual(line, list(range(line[0], line[-1] + 1)))
        self.assertAlmostEqual(len(line), 810, delta=6)

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
