"""ogive for Conan 2: headers and the CMake package, from the project that this file lies in."""
import os

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy


class OgiveConan(ConanFile):
    name = "ogive"
    version = "1.0.0"
    license = "BSD-3-Clause"
    description = "Perforation of metal plates with coupled SPH and 8-node hexes"
    package_type = "header-library"
    settings = "os", "arch", "compiler", "build_type"
    no_copy_source = True

    def export_sources(self):
        root = os.path.join(self.recipe_folder, "..", "..")
        for pattern in ("CMakeLists.txt", "LICENSE", "README.md", "CHANGELOG.md", "CITATION.cff", "cmake/*", "include/*",
                        "examples/*"):
            copy(self, pattern, src=root, dst=self.export_sources_folder)

    def layout(self):
        cmake_layout(self)

    def requirements(self):
        self.requires("eigen/3.4.0", transitive_headers=True)

    def validate(self):
        check_min_cppstd(self, 20)

    def package_id(self):
        self.info.clear()

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        for option in ("BUILD_APPS", "BUILD_TESTS", "BUILD_BENCH", "BUILD_EXAMPLES"):
            toolchain.cache_variables[f"OGIVE_{option}"] = False
        # VTK is not a requirement of this recipe: ogive::vtk is in the Debian package and in the project itself.
        toolchain.cache_variables["CMAKE_DISABLE_FIND_PACKAGE_VTK"] = True
        toolchain.generate()

    def package(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.install()
        copy(self, "LICENSE", src=self.source_folder, dst=os.path.join(self.package_folder, "licenses"))

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "ogive")
        self.cpp_info.set_property("cmake_target_name", "ogive::ogive")
        self.cpp_info.bindirs = []
        self.cpp_info.libdirs = []
        self.cpp_info.cxxflags = ["-fopenmp"]
        self.cpp_info.exelinkflags = ["-fopenmp"]
