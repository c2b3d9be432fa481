# SPDX-License-Identifier: GPL-3.0-or-later
# Read by cpack when it packs: files have the time of the commit, so that one commit gives one package. Outside a checkout they have the
# time of the last entry in Debian's changelog.
if(NOT DEFINED ENV{SOURCE_DATE_EPOCH})
  execute_process(COMMAND git -C "${CMAKE_CURRENT_LIST_DIR}" log -1 --format=%ct OUTPUT_VARIABLE seconds ERROR_QUIET
                  OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT seconds)
    execute_process(COMMAND dpkg-parsechangelog -l "${CMAKE_CURRENT_LIST_DIR}/debian/changelog" -S Timestamp OUTPUT_VARIABLE seconds
                    OUTPUT_STRIP_TRAILING_WHITESPACE)
  endif()
  set(ENV{SOURCE_DATE_EPOCH} "${seconds}")
endif()
