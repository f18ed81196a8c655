"""Builds the extension module with CMake, from the repository that this folder lies in."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent.parent


class CMakeBuild(build_ext):
    """In build/wheel, so that building again takes what is there. LASIUS_CMAKE_ARGS are passed on."""

    def build_extension(self, ext):
        target = pathlib.Path(self.get_ext_fullpath(ext.name)).resolve()
        folder = ROOT / "build/wheel"
        off = ["TOOLS", "TESTS", "BENCH", "FILM"]
        generator = ["-G", "Ninja"] if shutil.which("ninja") else []
        configure = ["cmake", *generator, "-S", ROOT, "-B", folder, "-DCMAKE_BUILD_TYPE=Release", "-DLASIUS_UNITY=ON",
                     "-DLASIUS_INSTALL=OFF", "-DLASIUS_BUILD_PYTHON=ON", f"-DPython_EXECUTABLE={sys.executable}",
                     *(f"-DLASIUS_BUILD_{name}=OFF" for name in off),
                     *os.environ.get("LASIUS_CMAKE_ARGS", "").split()]
        subprocess.run(configure, check=True)
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL") or str(os.cpu_count())
        subprocess.run(["cmake", "--build", folder, "--target", "lasius_python", "-j", jobs], check=True)
        self.copy_file(folder / "python/lasius" / target.name, target)


def version():
    """Of the project, as CMake knows it."""
    return re.search(r"project\(lasius VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]


setup(version=version(), ext_modules=[Extension("lasius._lasius", sources=[])], cmdclass={"build_ext": CMakeBuild})
