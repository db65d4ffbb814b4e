# `cpack` in the build folder, once the program is built, writes a .deb that installs on the distribution it was built on.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME demens)
set(CPACK_PACKAGE_CONTACT "The demens authors <demens@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Calibrates discrete element models of granular materials from bulk experiments")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)     # what the program is linked to
set(CPACK_DEBIAN_PACKAGE_DEPENDS openmpi-bin)
include(CPack)
