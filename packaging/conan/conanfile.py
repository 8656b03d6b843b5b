# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""A recipe of Conan 2: the library in one precision, shared or static. `conan create packaging/conan` builds this tree."""

import os

from conan import ConanFile
from conan.tools.build import check_min_cppstd, stdcpp_library
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy


class Epode(ConanFile):
    name = "epode"
    version = "0.1.0"
    description = "Rigid bodies with exact joints and hard contacts, behind the API of the Open Dynamics Engine"
    license = "BSD-3-Clause"
    topics = ("physics", "simulation", "robotics", "ode")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False], "fPIC": [True, False], "precision": ["double", "single"]}
    default_options = {"shared": False, "fPIC": True, "precision": "double"}
    provides = "ode"

    def export_sources(self):
        tree = os.path.join(self.recipe_folder, "..", "..")
        for part in ("CMakeLists.txt", "LICENSE", "README.md", "CHANGES.md", "include/*", "src/*", "packaging/*", "cmake/*"):
            copy(self, part, src=tree, dst=self.export_sources_folder)

    def configure(self):
        if self.options.shared:
            self.options.rm_safe("fPIC")

    def validate(self):
        check_min_cppstd(self, 20)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["EPODE_PRECISIONS"] = str(self.options.precision)
        for part in ("TESTS", "TOOLS"):
            toolchain.cache_variables[f"EPODE_{part}"] = False
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "LICENSE", src=self.source_folder, dst=os.path.join(self.package_folder, "licenses"))
        CMake(self).install()

    def package_info(self):
        is_single = self.options.precision == "single"
        self.cpp_info.libs = ["ode_single" if is_single else "ode"]
        self.cpp_info.defines = ["dIDESINGLE" if is_single else "dIDEDOUBLE"]
        self.cpp_info.set_property("cmake_file_name", "ode")
        self.cpp_info.set_property("cmake_target_name", "ODE::ODE")
        self.cpp_info.set_property("pkg_config_name", "ode-single" if is_single else "ode")
        if self.settings.os == "Linux":
            self.cpp_info.system_libs = ["m", "pthread"]
            # A program of C does not bring what a static library of C++ needs.
            if not self.options.shared:
                self.cpp_info.system_libs.append(stdcpp_library(self))
