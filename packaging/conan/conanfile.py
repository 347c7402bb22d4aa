"""A recipe of Conan 2: `conan create packaging/conan` in a checkout packs the library of that checkout."""
import os

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy


class Batten(ConanFile):
    name = "batten"
    version = "0.2.0"
    license = "MIT"
    description = "B-spline curve shaping: strokes that redraw curves, levels of detail, fits within a tolerance"
    settings = "os", "compiler", "build_type", "arch"
    options = {"shared": [True, False], "fPIC": [True, False]}
    default_options = {"shared": False, "fPIC": True}

    def export_sources(self):
        root = os.path.join(self.recipe_folder, "..", "..")
        for pattern in ("CMakeLists.txt", "LICENSE", "cmake/*", "include/*", "src/*", "expat/*"):
            copy(self, pattern, root, self.export_sources_folder)

    def configure(self):
        self.settings.rm_safe("compiler.cppstd")
        self.settings.rm_safe("compiler.libcxx")
        if self.options.shared:
            self.options.rm_safe("fPIC")

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["BATTEN_PROGRAM"] = False
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build(target="batten_shared" if self.options.shared else "batten")

    def package(self):
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        CMake(self).install()

    def package_info(self):
        self.cpp_info.libs = ["batten"]
        self.cpp_info.set_property("cmake_target_name", "batten::batten")
        self.cpp_info.set_property("pkg_config_name", "batten")
        if self.settings.os != "Windows":
            self.cpp_info.system_libs = ["m"]
        elif self.options.shared:
            self.cpp_info.libs = ["batten-dll"]
            self.cpp_info.defines = ["BATTEN_DLL=dllimport"]
