# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DOUTPUT=page_parts.cpp -DHTML=… -DSTYLE=… -DENGINE_SCRIPT=… -DWORKLET=… -DSCRIPT=… [-DENGINE=engine.wasm] -P embed.cmake
# Files as bytes in a source file.
set(text "// SPDX-License-Identifier: GPL-3.0-or-later\n// Written by playback/page/embed.cmake.\n#include \"playback/page/page_parts.h\"\n\nnamespace detent::playback::page_parts {\nnamespace {\n")
set(names "")
foreach(part html:HTML style:STYLE engineScript:ENGINE_SCRIPT worklet:WORKLET script:SCRIPT engine:ENGINE)
  string(REPLACE ":" ";" part ${part})
  list(GET part 0 name)
  list(GET part 1 variable)
  set(bytes "")
  if(${variable})
    file(READ "${${variable}}" bytes HEX)
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" bytes "${bytes}")
  endif()
  string(APPEND text "constexpr char ${name}Bytes[] = \"${bytes}\";\n")
  string(APPEND names "const std::string_view ${name}{${name}Bytes, sizeof ${name}Bytes - 1};\n")
endforeach()
file(WRITE ${OUTPUT} "${text}}  // namespace\n\n${names}\n}  // namespace detent::playback::page_parts\n")
