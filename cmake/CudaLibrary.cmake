# What nvcc compiles, as shared libraries of which only what is marked is visible: code of headers that both compilers
# make must not be mixed. nvcc is called by a command of its own: CMake 3.25 knows no C++20 for recent versions of it.
find_program(DEMENS_NVCC nvcc HINTS /usr/local/cuda/bin)
if(NOT DEMENS_NVCC)
  if(DEMENS_CUDA)
    message(FATAL_ERROR "DEMENS_CUDA is set, and there is no nvcc: install the CUDA Toolkit, or give -DDEMENS_NVCC=...")
  endif()
  message(STATUS "No nvcc: nothing is compiled for CUDA devices")
endif()

# add_cuda_library(NAME SOURCE [flags...]): code for two generations of devices, and PTX, which the driver translates
# for later ones. Without nvcc there is no such target.
function(add_cuda_library name source)
  if(NOT DEMENS_NVCC)
    return()
  endif()
  set(library ${CMAKE_CURRENT_BINARY_DIR}/lib${name}.so)
  add_custom_command(
    OUTPUT ${library}
    COMMAND ${DEMENS_NVCC} -std=c++20 -O2 -DNDEBUG -gencode arch=compute_80,code=sm_80 -gencode
            arch=compute_90,code=sm_90 -gencode arch=compute_90,code=compute_90 --expt-relaxed-constexpr
            --extended-lambda -Werror=all-warnings ${ARGN} -Xcompiler=-Wall,-ffp-contract=off,-fno-math-errno -shared
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
