"""Which cases of tests execute a function of core/ or kernels/: for mutate."""
import collections
import hashlib
import json
import os


class Executed:
    """What the cases of the tests execute, as tests/ci/executed.cpp and llvm-cov tell it."""

    def __init__(self, tree):
        self.tree = tree
        self.seconds = {}  # of each case: (program, name)
        self.cases = collections.defaultdict(set)  # by name of function
        self.functions = collections.defaultdict(list)  # by file: (begin, end, name, regions)

    def read_cases(self, program, text):
        for line in text.splitlines():
            name, seconds, state, *functions = line.split()
            if state != "ok":
                print("fails before anything is changed, and is left out:", program, name)
                continue
            self.seconds[program, name] = float(seconds)
            for function in functions:
                self.cases[function].add((program, name))

    def read_functions(self, exported):
        for function in json.loads(exported)["data"][0]["functions"]:
            path = os.path.relpath(function["filenames"][0], self.tree)
            if path.startswith(("core/", "kernels/")):
                name = str(int.from_bytes(hashlib.md5(function["name"].encode()).digest()[:8], "little"))
                regions = [(tuple(r[:2]), tuple(r[2:4]), r[4]) for r in function["regions"] if r[5] == 0 and r[7] == 0]
                if regions:
                    self.functions[path].append((*regions[0][:2], name, regions))

    def at(self, path, place, included_by):
        """The cases that execute the function at a place, none if it is not executed there. Outside of functions those
        that execute anything in the file, or in what includes it."""
        around = [f for f in self.functions[path] if f[0] <= place < f[1]]
        if around:
            inmost = max(f[0] for f in around)
            around = [f for f in around if f[0] == inmost]
            if not any(max((r for r in f[3] if r[0] <= place < r[1]), key=lambda r: r[0])[2] for f in around):
                return set()
        else:
            around = [f for file in {path, *included_by} for f in self.functions[file]]
        return set().union(*(self.cases[f[2]] for f in around))
