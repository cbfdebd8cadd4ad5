# quell_precompile(target headers...): compiles once what most files of a target include, most of their compile time.
# Headers of others alone: with our own ones every edit would build everything. Without those of CLI11 and nlohmann-json,
# whose templates would be instantiated in every file (2 s). -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON shows where a file
# relies on what it does not include.
set(QUELL_STANDARD_HEADERS <algorithm> <array> <cmath> <cstddef> <cstdint> <cstring> <functional> <limits> <map> <memory>
    <optional> <string> <utility> <vector>)
set(QUELL_FILE_HEADERS <filesystem> <fstream> <iterator> <sstream>)

function(quell_precompile target)
  target_precompile_headers(${target} PRIVATE ${QUELL_STANDARD_HEADERS} ${ARGN})
  # Lets ccache look inside (with sloppiness pch_defines and time_macros, which the build presets ask for).
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
endfunction()

# quell_reuse_precompiled(target other): the same of a target that compiles with the same options and definitions.
function(quell_reuse_precompiled target other)
  target_precompile_headers(${target} REUSE_FROM ${other})
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
endfunction()
