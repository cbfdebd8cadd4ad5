# quell_warnings(target): the warnings every target of this project compiles with.
function(quell_warnings target)
  quell_opencl_version(${target})
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
  if(QUELL_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()

# quell_opencl_version(target): OpenCL 1.2 headers. Private: those who embed Quell choose their own.
function(quell_opencl_version target)
  target_compile_definitions(${target} PRIVATE CL_TARGET_OPENCL_VERSION=120)
endfunction()
