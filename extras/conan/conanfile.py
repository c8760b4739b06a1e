# SPDX-License-Identifier: MIT
"""irg as a Conan 2 package, made from the copy this file stands in: conan create extras/conan"""
import os
import re

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.files import copy, load
from conan.tools.layout import basic_layout


class Irg(ConanFile):
    name = "irg"
    description = "A header-only C++20 library of computer-graphics algorithms"
    license = "MIT"
    topics = ("computer-graphics", "geometry", "rasterization", "header-only")
    package_type = "header-library"
    settings = "compiler"
    no_copy_source = True

    def set_version(self):
        config = load(self, os.path.join(self.recipe_folder, "../../include/irg/core/config.hpp"))
        self.version = ".".join(re.findall(r"#define IRG_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", config))

    def export_sources(self):
        top = os.path.join(self.recipe_folder, "../..")
        for pattern in ("LICENSE", "include/*.hpp"):
            copy(self, pattern, top, self.export_sources_folder)

    def layout(self):
        basic_layout(self)

    def validate(self):
        check_min_cppstd(self, 20)

    def package_id(self):
        self.info.clear()

    def package(self):
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        copy(self, "*.hpp", os.path.join(self.source_folder, "include"), os.path.join(self.package_folder, "include"))

    def package_info(self):
        self.cpp_info.bindirs = []
        self.cpp_info.libdirs = []
        self.cpp_info.set_property("cmake_target_name", "irg::irg")
