"""plan --spacing and -o path.yaml: the path as robots take it."""
import json
import math
import unittest

import yaml

from program import ProgramTest

MAP = "image: m.pgm\nresolution: 0.5\norigin: [-2, 1, 0.3]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"


def turned(a, b):
    return abs(math.remainder(a - b, 2 * math.pi))


class Poses(ProgramTest):
    algorithm = "exact"

    def setUp(self):
        super().setUp()
        pixels = bytearray(b"\xfe" * 30 * 20)
        for y in range(4, 20):
            pixels[30 * y + 15] = 0
        self.write("m.pgm", b"P5\n30 20\n255\n" + bytes(pixels))
        self.write("m.yaml", MAP)

    def along(self, poses, path, spacing):
        """Poses lie along a path, a vertex each and others between, and look where it goes on."""
        self.assertEqual(poses[0][:2], path[0])
        self.assertEqual(poses[-1][:2], path[-1])
        for vertex in path:
            self.assertIn(vertex, [pose[:2] for pose in poses])
        for a, b in zip(poses, poses[1:]):
            self.assertLess(math.dist(a[:2], b[:2]), spacing + 1e-12)
            self.assertLess(turned(a[2], math.atan2(b[1] - a[1], b[0] - a[0])), 1e-9)
        self.assertEqual(poses[-1][2], poses[-2][2])

    def messages(self, name):
        """The poses of a nav_msgs/Path."""
        message = yaml.safe_load(self.read(name))
        self.assertEqual(message["header"], {"stamp": {"sec": 0, "nanosec": 0}, "frame_id": "map"})
        found = []
        for stamped in message["poses"]:
            self.assertEqual(stamped["header"], message["header"])
            place, turn = stamped["pose"]["position"], stamped["pose"]["orientation"]
            for number in (*place.values(), *turn.values()):
                self.assertIsInstance(number, float)
            self.assertEqual((place["z"], turn["x"], turn["y"]), (0, 0, 0))
            found.append([place["x"], place["y"], 2 * math.atan2(turn["z"], turn["w"])])
        return found

    def test_cells(self):
        run = self.quiet(self.plan("-q", "--spacing", "0.7", "-o", "r.json", "-o", "p.yaml", "-o", "p.csv"))
        answer = json.loads(self.read("r.json"))
        self.assertEqual(answer["parameters"]["spacing"], 0.7)
        self.assertNotIn("poses_world", answer)
        self.along(answer["poses"], answer["path"], 0.7)
        for told, pose in zip(self.messages("p.yaml"), answer["poses"], strict=True):
            self.assertEqual(told[:2], pose[:2])
            self.assertLess(turned(told[2], pose[2]), 1e-12)
        self.assertEqual([[float(v) for v in row.values()] for row in self.rows("p.csv")], answer["poses"])
        self.assertEqual(list(self.rows("p.csv")[0]), ["x", "y", "yaw"])
        self.ended(self.run_program("verify", "r.json"), 0)
        self.assertEqual(run.out, self.plan("-q").out)

    def test_only_where_asked(self):
        answer = self.quiet(self.plan("--json", "-o", "p.yaml", "-o", "p.csv")).json
        self.assertNotIn("poses", answer)
        self.assertNotIn("spacing", answer["parameters"])
        self.along(self.messages("p.yaml"), answer["path"], 0.5)
        self.assertEqual(list(self.rows("p.csv")[0]), ["x", "y"])

    def test_metres(self):
        ends = ("--frame", "world", "--json", "--spacing", "0.4", "-o", "p.yml", "-o", "p.csv")
        answer = self.quiet(self.plan(*ends, map_file="m.yaml", start="-2,3", goal="10,6")).json
        self.assertEqual(answer["parameters"]["spacing"], 0.8)
        self.along(answer["poses"], answer["path"], 0.8)
        self.along(answer["poses_world"], answer["path_world"], 0.4)
        self.assertEqual([p[:2] for p in self.messages("p.yml")], [p[:2] for p in answer["poses_world"]])
        self.assertEqual(list(self.rows("p.csv")[0]), ["x_m", "y_m", "yaw"])
#Of a map with a frame poses are in it whatever the command's coordinates.
        ((sx, sy), (gx, gy)) = answer["path"][0], answer["path"][-1]
        self.ended(self.plan("--spacing", "0.8", "-o", "q.yaml", map_file="m.yaml", start=f"{sx},{sy}",
                             goal=f"{gx},{gy}"), 0)
        for told, pose in zip(self.messages("q.yaml"), answer["poses_world"], strict=True):
            self.assertLess(math.dist(told[:2], pose[:2]), 1e-9)
        self.replayed(answer)

    def replayed(self, answer):
        self.ended(self.replay_of(answer), 0)

    def test_discs_and_colonies(self):
        disc = self.quiet(self.plan("--json", "--radius", "1.5", "--spacing", "0.25", map_file="m.yaml", start="3,10",
                                    goal="26,10")).json
        arcs = [e for e in disc["curve"] if isinstance(e, dict)]
        self.assertEqual(len(arcs), 2)
        for arc in arcs:
            on_it = [p for p in disc["poses"] if abs(math.dist(p[:2], arc["centre"]) - arc["radius"]) < 1e-9]
            self.assertGreater(len(on_it), 3)
        self.replayed(disc)
        colony = self.quiet(self.plan("-q", "--algorithm", "as", "--iterations", "3", "--spacing", "1", "-o", "c.csv",
                                      "-o", "c.json"))
        self.assertEqual(list(self.rows("c.csv")[0]), ["iteration", "best", "mean", "arrived"])
        answer = json.loads(self.read("c.json"))
        self.along(answer["poses"], answer["path"], 1)
        self.assertIn("solved", colony.out)

    def test_batches(self):
        self.write("q.tsv", "sx sy gx gy\n0 0 9 5\n0 0 3 2\n")
        first, second = self.quiet(self.run_program("batch", "small.map", "q.tsv", "--spacing", "2")).lines
        self.along(first["poses"], first["path"], 2)
        self.assertIsNone(second["poses"])

    def test_none(self):
        self.ended(self.plan("-o", "p.yaml", goal="4,2"), 5)
        self.assertEqual(self.messages("p.yaml"), [])
        same = self.quiet(self.plan("--spacing", "1", "--json", goal="0,0")).json
        self.assertEqual(same["poses"], [[0.5, 0.5, 0]])

    def test_refused(self):
        self.refused(self.plan("--spacing", "0"), 2, "--spacing")
        self.refused(self.plan("--seed", "1-2", "-o", "p.yaml"), 2, "one seed")
        self.write("w.geojson", json.dumps({"type": "Polygon", "coordinates": [[[0, 0], [9, 0], [9, 9], [0, 9], [0, 0]]]}))
        self.refused(self.plan("-o", "p.yaml", map_file="w.geojson", start="1,1", goal="8,8"), 2, "bitmaps")


if __name__ == "__main__":
    unittest.main()
