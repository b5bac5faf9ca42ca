# What cpack makes: a Debian package of headers and programs, and a .tar.gz of the same.
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PACKAGE_NAME ogive)
set(CPACK_PACKAGE_VENDOR "the ogive authors")
set(CPACK_PACKAGE_CONTACT "the ogive authors <ogive@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
    "Header-only C++20 library and programs that predict how a projectile
perforates a metal plate: particles (SPH) where the plate is destroyed,
hexahedra elsewhere, a modified Johnson-Cook law for the metal.")
# dpkg-shlibdeps finds the libraries of the programs: VTK, OpenMP and EGL (libegl1, which brings Mesa). The headers need
# Eigen; only those of ogive::vtk need the headers of VTK. Curves are drawn by gnuplot, sections by a driver of Mesa,
# pages of `ogive view` hold three.js, films need ffmpeg; shots run without them.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libeigen3-dev (>= 3.4)")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "g++ (>= 4:12), gnuplot-nox | gnuplot, libgl1-mesa-dri, libjs-three, ffmpeg")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "bash-completion, libvtk9-dev, cmake (>= 3.25), paraview")
include(CPack)
