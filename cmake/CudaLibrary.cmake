# What nvcc compiles, as shared libraries of which only what is marked is visible: code of headers that both compilers
# make must not be mixed. nvcc is called by a command of its own: CMake 3.25 knows no C++20 for recent versions of it.
find_program(DEMENS_NVCC nvcc HINTS /usr/local/cuda/bin)
if(NOT DEMENS_NVCC)
  if(DEMENS_CUDA)
    message(FATAL_ERROR "DEMENS_CUDA is set, and there is no nvcc: install the CUDA Toolkit, or give -DDEMENS_NVCC=...")
  endif()
  message(STATUS "No nvcc: nothing is compiled for CUDA devices")
endif()

set(DEMENS_CUDA_ARCHITECTURES "80;90" CACHE STRING "Compute capabilities of devices for which code is compiled, ascending")

# add_cuda_library(NAME SOURCE [flags...]): code for these devices, and PTX of the last one, which the driver translates
# for later ones. Without nvcc there is no such target.
function(add_cuda_library name source)
  if(NOT DEMENS_NVCC)
    return()
  endif()
  set(library ${CMAKE_CURRENT_BINARY_DIR}/lib${name}.so)
  set(devices)
  foreach(device ${DEMENS_CUDA_ARCHITECTURES})
    list(APPEND devices -gencode arch=compute_${device},code=sm_${device})
  endforeach()
  list(GET DEMENS_CUDA_ARCHITECTURES -1 last)
  list(APPEND devices -gencode arch=compute_${last},code=compute_${last})
  add_custom_command(
    OUTPUT ${library}
    COMMAND ${DEMENS_NVCC} -std=c++20 -O2 -DNDEBUG ${devices} --expt-relaxed-constexpr --extended-lambda
            -Werror=all-warnings ${ARGN} -Xcompiler=-Wall,-ffp-contract=off,-fno-math-errno -shared
            -Xcompiler=-fPIC,-fvisibility=hidden,-fvisibility-inlines-hidden -I${PROJECT_SOURCE_DIR}
            -I${PROJECT_SOURCE_DIR}/include -MD -MF ${library}.d -MT ${library} ${CMAKE_CURRENT_SOURCE_DIR}/${source}
            -o ${library}
    DEPFILE ${library}.d
    DEPENDS ${source}
    COMMENT "Compiling ${source} for CUDA devices")
  add_custom_target(${name}_file DEPENDS ${library})
  add_library(${name} SHARED IMPORTED GLOBAL)
  set_target_properties(${name} PROPERTIES IMPORTED_LOCATION ${library} IMPORTED_NO_SONAME ON)
  add_dependencies(${name} ${name}_file)
  install(FILES ${library} DESTINATION lib/demens) # where the program looks for it, see app/
endfunction()
