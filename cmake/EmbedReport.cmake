cmake_minimum_required(VERSION 3.22)
# Turns the report page and its parts into one C++ source: cmake -DFOLDER=... -DOUTPUT=... -P EmbedReport.cmake
#
# A line @INCLUDE name@ of page.html is replaced by that file. The text is split into string literals short enough for
# every compiler.
file(READ "${FOLDER}/page.html" page)
foreach(part page.css charts.js comparer.js page.js)
  file(READ "${FOLDER}/${part}" text)
  string(REPLACE "@INCLUDE ${part}@" "${text}" page "${page}")
endforeach()
set(literals "")
string(LENGTH "${page}" rest)
set(position 0)
while(rest GREATER 0)
  string(SUBSTRING "${page}" ${position} 8000 piece)
  string(APPEND literals "R\"page(${piece})page\"\n")
  math(EXPR position "${position} + 8000")
  math(EXPR rest "${rest} - 8000")
endwhile()
file(WRITE "${OUTPUT}" "// Generated from host/cli/bench/page by cmake/EmbedReport.cmake.\n#include \"host/cli/bench/page_template.hpp\"\n\nnamespace quell::cli {\n\nconst char* const kReportPage =\n${literals};\n\n}  // namespace quell::cli\n")
