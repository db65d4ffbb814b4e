# What must be installed; cmake/debian-packages.txt has the packages of Debian.
find_package(fmt REQUIRED)
find_package(Qhull REQUIRED)
if(DEMENS_BENCHMARKS OR NOT DEMENS_ENGINE_ONLY)
  find_package(CLI11 REQUIRED)
endif()
if(DEMENS_ENGINE_ONLY)
  return()
endif()

find_package(PkgConfig REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(nlohmann_json REQUIRED)
find_package(spdlog REQUIRED)
find_package(MPI REQUIRED COMPONENTS C)
# Only the C interface: Open MPI's header would otherwise pull in its old C++ one, which is not linked.
set_property(TARGET MPI::MPI_C APPEND PROPERTY INTERFACE_COMPILE_DEFINITIONS OMPI_SKIP_MPICXX)

set(HDF5_PREFER_PARALLEL ON)
find_package(HDF5 REQUIRED COMPONENTS C)
if(NOT HDF5_IS_PARALLEL)
  message(FATAL_ERROR "demens needs a parallel HDF5 (Debian: libhdf5-openmpi-dev); found ${HDF5_C_LIBRARIES}")
endif()

pkg_check_modules(tomlplusplus REQUIRED IMPORTED_TARGET tomlplusplus)
pkg_check_modules(nlopt REQUIRED IMPORTED_TARGET nlopt_cxx)
pkg_check_modules(gd REQUIRED IMPORTED_TARGET gdlib)
pkg_check_modules(petsc REQUIRED IMPORTED_TARGET PETSc)
