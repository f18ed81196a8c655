"""The measures are right, and a limit that is broken is told."""
import unittest

from tree import TreeTest


class CheckSizes(TreeTest):
    def setUp(self):
        super().setUp()
        self.write("README.md", "one two\nthree\n")
        for length in range(1, 11):
            self.write(f"core/file{length}.cpp", "int x;\n" * length)

    def test_a_small_tree(self):
        out = self.assert_passes("check_sizes")
        for value, name in ((55, "C++, lines in all"), (6, "C++, lines of the median file"),
                            (10, "C++, lines at the 90th percentile"),
                            (10, "C++, lines of the longest file"),
                            (10, "largest folder, files of its own"),
                            (2, "README.md, lines"), (3, "README.md, words")):
            self.assertRegex(out, rf"(?m)^ *{value}  {name.replace('+', '[+]')} ")

    def test_untracked_files_do_not_count(self):
        self.write("core/generated.cpp", "int x;\n" * 60000, tracked=False)
        self.assert_passes("check_sizes")

    def broken(self, measure):
        out = self.assert_fails("check_sizes", "1 of the limits broken")
        self.assertRegex(out, rf"(?m)^ *\d+  {measure} .*TOO MUCH: at most \d+$")

    def test_too_much_code(self):
        for number in range(2310):
            self.write(f"core/{number // 40}/{number}.h", "\n" * 70)
        self.broken("C[+][+], lines in all")

    def test_too_long_code(self):
        for number in range(20):
            self.write(f"core/{number}.h", "\n" * 70)
        self.write("core/long.h", "\n" * 400)
        self.broken("C[+][+], lines of the longest file")

    def test_too_large_a_folder(self):
        for number in range(61):
            self.write(f"core/full/{number}.txt", "")
        self.broken("largest folder, files of its own")

    def test_files_of_folders_inside_do_not_count(self):
        for number in range(80):
            self.write(f"core/{number % 2}/{number}.txt", "")
        self.assert_passes("check_sizes")

    def test_too_long_a_document(self):
        self.write("ARCHITECTURE.md", "\n" * 151)
        self.broken("ARCHITECTURE.md, lines")
        self.write("ARCHITECTURE.md", "\n" * 150)
        self.write("README.md", "word " * 1201)
        self.broken("README.md, words")
        self.write("README.md", "\n" * 151)
        self.broken("README.md, lines")

    def test_too_large_a_file(self):
        self.write("maps/large.map", "." * 200001)
        self.broken("largest file, bytes")


if __name__ == "__main__":
    unittest.main()
