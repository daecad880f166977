# The batched contact kernels, once a vector width. -O3 in every build type: they are loops for the vectoriser.
set(SARCINA_KERNEL_DIR ${CMAKE_CURRENT_SOURCE_DIR}/mechanics)
set_source_files_properties(${SARCINA_KERNEL_DIR}/kernel_base.c PROPERTIES COMPILE_OPTIONS "-O3")
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  set_source_files_properties(${SARCINA_KERNEL_DIR}/kernel_avx2.c PROPERTIES COMPILE_OPTIONS "-O3;-mavx2")
  set_source_files_properties(${SARCINA_KERNEL_DIR}/kernel_avx512.c PROPERTIES
    COMPILE_OPTIONS "-O3;-mavx512f;-mavx512dq;-mprefer-vector-width=512")
  set_source_files_properties(${SARCINA_KERNEL_DIR}/kernel.c PROPERTIES COMPILE_DEFINITIONS SARCINA_X86)
endif()
