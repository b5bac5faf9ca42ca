# SPDX-License-Identifier: BSD-3-Clause
"""ogive for Spack: `spack dev-build ogive@1.0.0` in the project's folder."""
from spack.package import *


class Ogive(CMakePackage):
    """Perforation of metal plates with coupled SPH and 8-node hexes, header-only."""

    version("1.0.0")
    license("BSD-3-Clause")

    variant("vtk", default=False, description="Frames for ParaView: ogive::vtk")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("eigen@3.4:")
    depends_on("vtk@9:", when="+vtk")

    conflicts("%gcc@:11", msg="ogive needs C++20")
    conflicts("%clang@:13", msg="ogive needs C++20")

    def cmake_args(self):
        options = ("BUILD_APPS", "BUILD_TESTS", "BUILD_BENCH", "BUILD_EXAMPLES")
        args = [self.define(f"OGIVE_{option}", False) for option in options]
        return args + [self.define("CMAKE_DISABLE_FIND_PACKAGE_VTK", not self.spec.satisfies("+vtk"))]
