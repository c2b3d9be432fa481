# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DOUTPUT=page_parts.cpp -DHEADER=playback/page/page_parts.h -DNAMESPACE=page_parts "-DPARTS=html=FILE|engine=FILE|…" -P embed.cmake
# Files as bytes in a source file; a part without a file is empty.
set(text "// SPDX-License-Identifier: GPL-3.0-or-later\n// Written by playback/page/embed.cmake.\n#include \"${HEADER}\"\n\nnamespace detent::playback::${NAMESPACE} {\nnamespace {\n")
set(names "")
string(REPLACE "|" ";" PARTS "${PARTS}")
foreach(part IN LISTS PARTS)
  string(REGEX MATCH "^([^=]*)=(.*)$" matched "${part}")
  set(name ${CMAKE_MATCH_1})
  set(bytes "")
  if(CMAKE_MATCH_2)
    file(READ "${CMAKE_MATCH_2}" bytes HEX)
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" bytes "${bytes}")
  endif()
  string(APPEND text "constexpr char ${name}Bytes[] = \"${bytes}\";\n")
  string(APPEND names "const std::string_view ${name}{${name}Bytes, sizeof ${name}Bytes - 1};\n")
endforeach()
file(WRITE ${OUTPUT} "${text}}  // namespace\n\n${names}\n}  // namespace detent::playback::${NAMESPACE}\n")
