"""Builds the extension with CMake, and lays the library beside it."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

SOURCE = Path(__file__).resolve().parents[2]


class BuiltByCMake(build_ext):
    def build_extension(self, ext):
        build = Path(self.build_temp).resolve()
        to = Path(self.get_ext_fullpath(ext.name)).parent
        to.mkdir(parents=True, exist_ok=True)
        options = {
            "CMAKE_BUILD_TYPE": "Release",
            "CMAKE_INTERPROCEDURAL_OPTIMIZATION": "ON",
            "CMAKE_BUILD_WITH_INSTALL_RPATH": "ON",
            "CMAKE_INSTALL_RPATH": "$ORIGIN",
            "DAPPLE_PROGRAM": "OFF",
            "Python_EXECUTABLE": sys.executable,
        }
        subprocess.check_call(
            [
                "cmake",
                "-S",
                SOURCE,
                "-B",
                build,
                "-G",
                "Ninja",
                *(f"-D{name}={value}" for name, value in options.items()),
            ]
        )
        subprocess.check_call(["cmake", "--build", build, "--target", "dapple_python"])
        for file in [*build.glob("python/dapple/_dapple.*.so"), build / "library/libdapple.so.0"]:
            shutil.copy(file, to)


BUILD = SOURCE / "build/wheel"  # with what else is built, not among the sources
BUILD.mkdir(parents=True, exist_ok=True)
setup(
    version=re.search(r"project\(dapple VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text())[1],
    ext_modules=[Extension("dapple._dapple", [])],
    cmdclass={"build_ext": BuiltByCMake},
    options={"build": {"build_base": str(BUILD)}, "egg_info": {"egg_base": str(BUILD)}},
)
