"""A dead link in a document is found, and a good one is not."""
import unittest

from tree import TreeTest

GUIDE = """# The guide, in `short`

Over
----
## A part
## A part
<a id="by-hand"></a>
```
# no heading
```
"""


class CheckLinks(TreeTest):
    def setUp(self):
        super().setUp()
        self.write("docs/guide.md", GUIDE)
        self.write("docs/a picture.png", "")
        self.write("README.md", "")

    def accepts(self, text):
        self.write("README.md", text)
        self.assert_passes("check_links")

    def refuses(self, text, *sentences):
        self.write("README.md", text)
        self.assert_fails("check_links", *sentences)

    def test_files_and_folders(self):
        self.accepts("[a](docs/guide.md), [b](docs), ![c](<docs/a picture.png>), [d](docs/a%20picture.png 'x')\n")

    def test_headings(self):
        self.accepts("# Top\n[a](#top) [b](docs/guide.md#the-guide-in-short) [c](docs/guide.md#over)\n"
                     "[d](docs/guide.md#a-part-1) [e](docs/guide.md#by-hand)\n")

    def test_links_that_are_not_ours_to_check(self):
        self.accepts("[a](https://example.org/#x) <mailto:a@example.org> [b](mailto:a@example.org)\n"
                     "`[c](gone.md)`\n```\n[d](gone.md)\n```\nw[i][j]\n")

    def test_references(self):
        self.accepts("[a][guide] [Guide][]\n\n[guide]: docs/guide.md\n")
        self.refuses("[a][guide]\n", "README.md:1: [guide] is not defined")
        self.refuses("x\n\n[guide]: docs/gone.md\n", "README.md:3: docs/gone.md is not there")

    def test_a_file_that_is_not_there(self):
        self.refuses("text\n[a](docs/gone.md)\n", "README.md:2: docs/gone.md is not there")
        self.refuses('<img src="docs/gone.png">\n', "docs/gone.png is not there")

    def test_a_file_that_is_not_tracked(self):
        self.write("built.md", "", tracked=False)
        self.refuses("[a](built.md)\n", "built.md is not there")

    def test_a_link_is_relative_to_its_file(self):
        self.write("docs/more.md", "[a](docs/guide.md)\n")
        self.assert_fails("check_links", "docs/more.md:1: docs/guide.md is not there")
        self.write("docs/more.md", "[a](guide.md) [b](../README.md)\n")
        self.assert_passes("check_links")

    def test_a_heading_that_is_not_there(self):
        self.refuses("[a](docs/guide.md#no-heading)\n", "names no heading")
        self.refuses("[a](#top)\n", "README.md:1: #top names no heading")

    def test_a_link_out_of_the_repository(self):
        self.refuses("[a](../other/x.md) [b](/etc/passwd)\n", "leads out of the repository",
                     "/etc/passwd is not relative")


if __name__ == "__main__":
    unittest.main()
