# Flags that every target of the project shares.
add_library(demens_settings INTERFACE)
target_compile_features(demens_settings INTERFACE cxx_std_20)
target_include_directories(demens_settings INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/include)
# No contraction: the same bits on every instruction set. No errno: square roots vectorise.
target_compile_options(demens_settings INTERFACE -Wall -Wextra -Wno-psabi -ffp-contract=off -fno-math-errno
                                                 -fno-trapping-math)
if(DEMENS_WARNINGS_AS_ERRORS)
  target_compile_options(demens_settings INTERFACE -Werror)
endif()
