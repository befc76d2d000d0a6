# SPDX-License-Identifier: GPL-3.0-or-later
# flatland_target(<target>): the flags every target of this project is built with.
function(flatland_target target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                         -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual)
  # g++ 12 sees an overlap in "literal" + std::string where there is none (GCC bug 105651).
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(${target} PRIVATE -Wno-restrict)
  endif()
  # Certified arithmetic needs the operations as written: no contraction into fused multiply-add.
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  if(FLATLAND_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(FLATLAND_SANITIZE)
    # GCC warns of uninitialized values that are none once the sanitizers have changed the code.
    target_compile_options(${target} PRIVATE -fsanitize=address,undefined -fno-sanitize-recover=all
                           -fno-omit-frame-pointer -Wno-maybe-uninitialized)
    target_link_options(${target} PRIVATE -fsanitize=address,undefined)
  endif()
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
endfunction()
