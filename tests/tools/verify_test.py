"""verify: replays results, and tells equal from tampered, foreign and not replayable ones."""
import json
import os
import shutil
import unittest

from program import MAPS, ProgramTest


class Verify(ProgramTest):
    def setUp(self):
        super().setUp()
        shutil.copy(os.path.join(MAPS, "fan400x200.map"), self.path("fan.map"))

    def save(self, *arguments, name="r.json", **question):
        run = self.plan("--json", "--iterations", "8", *arguments,
                        **{"map_file": "fan.map", "start": "14,14", "goal": "380,179", **question})
        self.write(name, run.out)
        return run.json

    def test_equal_with_any_number_of_threads(self):
        self.save("--threads", "1", "--set", "persistence=0.65", "--seed", "9007199254740991")
        for threads in ("1", "2", "3"):
            run = self.run_program("verify", "r.json", "--threads", threads)
            self.assertEqual((run.code, run.out, run.err),
                             (0, "1 of 1 result is equal to the replay\n", ""))

    def test_options_that_shape_a_result_are_replayed(self):
        for arguments in (["--algorithm", "as"], ["--polish", "none"], ["--ants", "3"],
                          ["--neighbours", "8", "--corners", "one-side"],
                          ["--time-limit", "1000"], ["--gap"], ["--target-gap", "3"]):
            with self.subTest(arguments=arguments):
                self.assertEqual(self.save(*arguments)["status"], "solved")
                self.assertEqual(self.run_program("verify", "r.json").code, 0)

    def test_values_that_are_not_read_are_told_and_replayed(self):
        for arguments in (["--set", "ranks=9"], ["--preset", "book", "--set", "omega=3"],
                          ["--neighbours", "4", "--corners", "allow"]):
            with self.subTest(arguments=arguments):
                result = self.save("--algorithm", "as", *arguments)
                name, _, value = arguments[-1].rpartition("=")
                self.assertEqual(str(result["parameters"][name or "corners"]), value)
                self.assertEqual(self.run_program("verify", "r.json").code, 0)
        early = self.save("--algorithm", "as", "--preset", "book")
        early["parameters"]["omega"] = 10  # which `as` does not read
        self.write("r.json", json.dumps(early))
        self.assertEqual(self.run_program("verify", "r.json").code, 0)

    def test_a_parameter_that_came_later(self):
        result = self.save("--algorithm", "as", "--preset", "book")
        if result["version"] == "0.3.0":
            self.skipTest("SKIPPED: 0.3.0 is the oldest version whose results are replayed")
        for name in ("band", "trail_entropy", "iteration_best"):
            del result[name]
        del result["parameters"]["walk_cut"]
        result["version"] = "0.3.0"
        self.write("r.json", json.dumps(result))
        self.assertEqual(self.run_program("verify", "r.json").code, 0)
        del result["parameters"]["ants"]
        self.write("r.json", json.dumps(result))
        self.refused(self.run_program("verify", "r.json"), 3, "parameters/ants")

    def test_an_optimum_that_was_cut_off_is_no_difference(self):
        result = self.save("--gap")
        self.write("r.json", json.dumps({**result, "optimum": None, "optimum_gap": None,
                                         "grid_optimum": None, "grid_gap": None}))
        self.assertEqual(self.run_program("verify", "r.json").code, 0)
        self.write("r.json", json.dumps({**result, "optimum": result["optimum"] - 1}))
        self.ended(self.run_program("verify", "r.json"), 1, "'optimum'")

    def test_an_optimum_that_was_cut_off_has_no_gap(self):
        result = self.save("--gap")
        for change in ({"optimum": None}, {"optimum_gap": None}, {"optimum": None, "optimum_gap": 0}):
            with self.subTest(change=change):
                self.write("r.json", json.dumps({**result, **change}))
                self.refused(self.run_program("verify", "-q", "r.json"), 1, "'optimum_gap'")
        del result["optimum_gap"]
        self.write("r.json", json.dumps({**result, "optimum": None}))
        self.refused(self.run_program("verify", "-q", "r.json"), 1, "'optimum_gap'")

    def test_versions(self):
        result = self.save()
        own = result["version"]
        for version in ("0.3.0", own):
            self.write("r.json", json.dumps({**result, "version": version}))
            run = self.ended(self.run_program("verify", "r.json"), 0)
            self.assertEqual("made by version" in run.err, version != own)
        major = int(own.split(".")[0])
        for version in (f"{major + 1}.0.0", own + "1", "0.1.0", "0.2.9", "0.3", "0.3.0.1", "0.3.0-x", "-1.2.3",
                        "new", "", None, 2, 0.3, ["0.3.0"], {"is": "0.3.0"}, "9" * 40 + ".0.0"):
            with self.subTest(version=version):
                self.write("r.json", json.dumps({**result, "version": version}))
                self.refused(self.run_program("verify", "-q", "r.json"), 3, "r.json",
                             "its version is " + json.dumps(version, separators=(",", ":")))
        del result["version"]
        self.write("r.json", json.dumps(result))
        self.refused(self.run_program("verify", "-q", "r.json"), 3, "r.json", 'lacks its "version"')

    def test_what_may_differ_must_be_there_and_a_number(self):
        result = self.save()
        for key in ("threads", "elapsed_ms"):
            for changed in ({k: v for k, v in result.items() if k != key}, {**result, key: None},
                            {**result, key: -1}, {**result, key: "1"}):
                self.write("r.json", json.dumps(changed))
                self.refused(self.run_program("verify", "-q", "r.json"), 1, f"'{key}'")
            self.write("r.json", json.dumps({**result, key: 7}))
            self.quiet(self.run_program("verify", "-q", "r.json"))

    def test_names_that_are_given_twice(self):
        text = json.dumps(self.save())
        for old, new in (('"seed": 1', '"seed": 1, "seed": 2'),
                         ('"ants": 10', '"ants": 10, "ants": 3'),
                         ('"file": "fan.map"', '"file": "fan.map", "file": "fan.map"')):
            name = old.split(":")[0]
            with self.subTest(name=name):
                self.assertIn(old, text)
                self.write("r.json", text.replace(old, new))
                byte = text.index(old) + new.rindex(name) + len(name) - 1
                self.refused(self.run_program("verify", "r.json"), 3,
                             f"r.json, line 1, byte {byte}: {name} is given again")

    def test_members_of_another_kind(self):
        result = self.save()
        self.write("r.json", json.dumps({**result, "robot": 3}))
        self.refused(self.run_program("verify", "-q", "r.json"), 1, "'robot'")

    def test_a_radius_is_replayed(self):
        rows = [("." * 12 + "@@" + "." * 12) if 8 <= y < 18 else "." * 26 for y in range(26)]
        self.write("block.map", "type octile\nheight 26\nwidth 26\nmap\n" + "\n".join(rows))
        lengths = [self.save("--radius", radius, map_file="block.map", start="4,12",
                             goal="21,12")["length"] for radius in ("0", "2.5")]
        self.assertLess(lengths[0], lengths[1])
        self.assertEqual(self.run_program("verify", "r.json").code, 0)
        run = self.plan("--json", "--radius", "2.5", "--algorithm", "exact", map_file="block.map", start="4,12",
                        goal="21,12")
        old = run.json
        self.write("r.json", json.dumps({**old, "version": "0.3.0"}))
        self.ended(self.run_program("verify", "r.json"), 2, "the radius asked is now the radius kept")
        old["curve"][2]["turn"] *= -1
        self.write("r.json", json.dumps(old))
        self.ended(self.run_program("verify", "r.json"), 1, "'curve'")

    def test_failures_are_results_too(self):
        for goal in ("399,0", "1000,0"):
            self.assertIn(self.save(goal=goal)["status"], ("invalid", "unreachable"))
            self.assertEqual(self.run_program("verify", "r.json").code, 0)

    def test_a_result_that_nests_too_deep_is_broken(self):
        result = json.dumps(self.save())
        for text in (result[:-1] + ', "more": ' + "[" * 200000 + "]" * 200000 + "}",
                     result.replace('"start": [', '"start": [' + "[" * 200000)):
            self.write("r.json", text)
            self.refused(self.run_program("verify", "r.json"), 3, "nests too deep")

    def test_tampering_is_found_and_named(self):
        result = self.save()
        changes = {
            "length": result["length"] - 1e-12 * result["length"],
            "path": result["path"][:-1] + [[1.5, 1.5]],
            "best": result["best"][:-1] + [1.0],
            "mean": [result["mean"][0] + 1] + result["mean"][1:],
            "status": "no_path",
            "optimal": True,
        }
        for key, value in changes.items():
            with self.subTest(key=key):
                self.refused(self.replay_of({**result, key: value}, "-q"), 1, key)
        self.assertEqual(self.replay_of({**result, "seed": 2}).code, 1)

    def test_what_a_clock_ended_cannot_be_replayed(self):
        result = self.save()
        for status in ("limit", "interrupted"):
            self.write("r.json", json.dumps({**result, "status": status}))
            self.ended(self.run_program("verify", "r.json"), 2, "cannot be replayed")

    def test_what_own_rules_found_cannot_be_replayed(self):
        self.write("r.json", json.dumps({**self.save(), "own_rules": True}))
        self.ended(self.run_program("verify", "r.json"), 2, "rules of the caller's own")

    def test_what_came_when_it_came_cannot_be_replayed(self):
        asked = ("plan", "small.map", "--start", "0,0", "--goal", "9,5", "--algorithm", "acs", "--iterations", "3", "--islands",
                 "2", "-q", "-o", "r.json", "--exchange")
        self.quiet(self.run_program(*asked, "asynchronous"))
        self.assertEqual(json.loads(self.read("r.json"))["parameters"]["exchange"], "asynchronous")
        self.ended(self.run_program("verify", "r.json"), 2, "cannot be replayed", "which another run may not repeat")
        self.quiet(self.run_program(*asked, "scheduled"))
        self.assertEqual(self.run_program("verify", "r.json").code, 0)

    def test_another_map_is_refused(self):
        result = self.save()
        self.write("fan.map", self.read("small.map"))
        self.refused(self.run_program("verify", "r.json"), 3, "fan.map", result["map"]["hash"])
        os.remove(self.path("fan.map"))
        self.refused(self.run_program("verify", "r.json"), 3, "fan.map")

    def test_a_map_that_moved(self):
        self.save()
        os.mkdir(self.path("sub"))
        os.rename(self.path("fan.map"), self.path("sub/fan.map"))
        self.assertEqual(self.run_program("verify", "r.json", "--map", "sub/fan.map").code, 0)
        os.rename(self.path("r.json"), self.path("sub/r.json"))
        self.assertEqual(self.run_program("verify", "sub/r.json").code, 0)

    def test_the_lines_of_a_batch(self):
        self.write("q.tsv", "sx\tsy\tgx\tgy\n14\t14\t60\t40\n0\t0\t-1\t0\n60\t40\t14\t14\n")
        run = self.run_program("batch", "fan.map", "q.tsv", "--iterations", "3")
        self.write("lines.json", run.out)
        verified = self.run_program("verify", "lines.json")
        self.assertEqual((verified.code, verified.out),
                         (0, "3 of 3 results are equal to the replay\n"))
        lines = run.lines
        lines[2]["length"] += 1
        self.write("lines.json", "".join(json.dumps(line) + "\n" for line in lines))
        self.ended(self.run_program("verify", "lines.json"), 1, "result 3")

    def test_a_result_that_is_laid_out_for_people(self):
        self.write("r.json", json.dumps(self.save(), indent=2))
        self.assertEqual(self.run_program("verify", "r.json").code, 0)

    def test_broken_results(self):
        result = self.save()
        cases = {"missing.json": None, "empty.json": "", "text.json": "hello", "array.json": "[1]",
                 "cut.json": json.dumps(result)[:200], "other.json": '{"format": "other/1"}',
                 "number.json": '{"format": 3}', "null.json": "null",
                 "half.json": json.dumps({**result, "start": [True, 0]}),
                 "point.json": json.dumps({**result, "goal": [1]}),
                 "bare.json": json.dumps({"format": "lasius-plan/1", "status": "solved"}),
                 "typed.json": json.dumps({**result, "seed": "one"})}
        for name, content in cases.items():
            with self.subTest(name=name):
                if content is not None:
                    self.write(name, content)
                self.refused(self.run_program("verify", name), 3, name)

    def test_a_broken_result_is_named_by_its_byte(self):
        good = json.dumps(self.save()) + "\n"
        seed = good.index('"seed": 1') + len('"seed": ')
        cases = [(good + good[:100], f"result 2, line 2, byte {len(good) + 100}", "not JSON"),
                 (good + good.replace('"seed": 1', '"seed": 1e999'),
                  f"result 2, line 2, byte {len(good) + seed + len('1e99')}",
                  "a number is too large"),
                 ("\n\n" + good.replace('"seed": 1', '"sed": 1'), "byte 2", "seed"),
                 (good + "[]", f"result 2, byte {len(good)}", "format")]
        for content, place, word in cases:
            with self.subTest(place=place):
                self.write("bad.json", content)
                self.refused(self.run_program("verify", "bad.json", "-q"), 3, "bad.json", place,
                             word)

    def test_a_broken_input_is_named(self):
        result = self.save()
        cases = [({"seed": -1}, '"seed"'), ({"seed": 1 << 60}, '"seed"'), ({"seed": 1.5}, '"seed"'),
                 ({"map": {"file": "fan.map"}}, '"map/hash"'), ({"start": "a"}, '"start"'),
                 ({"parameters": {**result["parameters"], "target_gap": -1}}, "target_gap"),
                 ({"parameters": {**result["parameters"], "time_limit": -1}}, "time_limit"),
                 ({"parameters": {**result["parameters"], "ants": 0}}, "ants")]
        for change, word in cases:
            with self.subTest(change=change):
                self.write("bad.json", json.dumps({**result, **change}))
                run = self.run_program("verify", "bad.json")
                self.refused(run, 3, "bad.json", word)
                self.assertNotIn("exception", run.err)
        del result["map"]
        self.refused(self.replay_of(result), 3, "bad.json", 'lacks', '"map"')

    def test_cells_that_no_map_holds(self):
        for goal in ("4294967297,3", "-99999999999999999999,0", "0," + "9" * 400):
            result = self.save(goal=goal)
            self.assertEqual(result["status"], "invalid")
            self.assertEqual(self.run_program("verify", "r.json").code, 0)


if __name__ == "__main__":
    unittest.main()
