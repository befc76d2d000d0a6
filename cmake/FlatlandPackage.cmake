# SPDX-License-Identifier: GPL-3.0-or-later
# `cpack -G DEB` in a build folder makes the Debian packages flatland and libflatland-dev.
# Needs dpkg-dev and file, which find out the libraries that the program depends on.
set(CPACK_PACKAGE_NAME flatland)
set(CPACK_PACKAGE_VENDOR "Flatland contributors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "View-dependent curvature of 2D curves, seen and computed")
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_STRIP_FILES ON)
# The program lives under the prefix of distributions, whatever prefix this build was configured with.
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL flatland dev)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "Flatland contributors")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_FLATLAND_PACKAGE_NAME flatland)
set(CPACK_DEBIAN_FLATLAND_PACKAGE_SECTION math)
set(CPACK_DEBIAN_FLATLAND_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_FLATLAND_PACKAGE_RECOMMENDS fonts-dejavu-core)
set(CPACK_COMPONENT_FLATLAND_DESCRIPTION
    "A window and a command-line tool for 2D curves seen on a 1D screen: silhouettes, ridges and\n\
valleys, inflections and apparent ridges, each with its place, terms and residual, and drawings of\n\
them as SVG, PDF, PNG and TikZ.")

set(CPACK_DEBIAN_DEV_PACKAGE_NAME libflatland-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "libeigen3-dev (>= 3.4), nlohmann-json3-dev (>= 3.10), libpugixml-dev")
set(CPACK_COMPONENT_DEV_DESCRIPTION
    "Headers, static library and CMake package of Flatland's mathematics: curves, certified roots of\n\
Bernstein polynomials, features of a curve under a view. No Qt.")
include(CPack)
