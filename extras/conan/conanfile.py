# SPDX-License-Identifier: MIT
"""irg as a Conan 2 package, made from the copy this file stands in:
    conan create extras/conan                             header-only
    conan create extras/conan -o "irg/*:compiled=True"    with the library irg::compiled"""
import os
import re

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load
from conan.tools.layout import basic_layout


class Irg(ConanFile):
    name = "irg"
    description = "A header-only C++20 library of computer-graphics algorithms"
    license = "MIT"
    topics = ("computer-graphics", "geometry", "rasterization", "header-only")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"compiled": [True, False], "shared": [True, False], "fPIC": [True, False]}
    default_options = {"compiled": False, "shared": False, "fPIC": True}
    no_copy_source = True

    def set_version(self):
        config = load(self, os.path.join(self.recipe_folder, "../../include/irg/core/config.hpp"))
        self.version = ".".join(re.findall(r"#define IRG_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", config))

    def export_sources(self):
        top = os.path.join(self.recipe_folder, "../..")
        for pattern in ("LICENSE", "CMakeLists.txt", "cmake/*", "include/*.hpp", "src/*.cpp"):
            copy(self, pattern, top, self.export_sources_folder)

    def configure(self):
        if not self.options.compiled:
            self.package_type = "header-library"
            del self.options.shared, self.options.fPIC
        elif self.options.shared:
            del self.options.fPIC

    def layout(self):
        if self.options.compiled:
            cmake_layout(self)
        else:
            basic_layout(self)

    def validate(self):
        check_min_cppstd(self, 20)

    def package_id(self):
        if not self.info.options.compiled:
            self.info.clear()

    def generate(self):
        if self.options.compiled:
            toolchain = CMakeToolchain(self)
            toolchain.cache_variables.update(
                {"IRG_BUILD_COMPILED": True, "IRG_BUILD_TESTS": False, "IRG_BUILD_EXAMPLES": False})
            toolchain.generate()

    def build(self):
        if self.options.compiled:
            cmake = CMake(self)
            cmake.configure()
            cmake.build(target="irg_compiled")

    def package(self):
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        copy(self, "*.hpp", os.path.join(self.source_folder, "include"), os.path.join(self.package_folder, "include"))
        for pattern in ("*.a", "*.so*", "*.dylib", "*.lib", "*.dll"):
            copy(self, pattern, self.build_folder, os.path.join(self.package_folder, "lib"), keep_path=False)

    def package_info(self):
        headers = self.cpp_info.components["irg"]
        headers.set_property("cmake_target_name", "irg::irg")
        headers.bindirs = headers.libdirs = []
        if self.options.compiled:
            compiled = self.cpp_info.components["compiled"]
            compiled.set_property("cmake_target_name", "irg::compiled")
            compiled.set_property("pkg_config_name", "irg-compiled")
            compiled.requires = ["irg"]
            compiled.libs = ["irg_compiled"]
            compiled.defines = ["IRG_COMPILED"]
