# SPDX-License-Identifier: BSD-3-Clause
# Removes the files listed in MANIFEST, those of the last installation, and the folders they leave
# empty.

if (NOT EXISTS "${MANIFEST}")
  message(FATAL_ERROR "Nothing was installed from here: there is no ${MANIFEST}.")
endif ()

file(STRINGS "${MANIFEST}" files)
set(folders)
foreach (file IN LISTS files)
  file(REMOVE "$ENV{DESTDIR}${file}")
  get_filename_component(folder "${file}" DIRECTORY)
  if (file MATCHES "[.]py$")
    file(REMOVE_RECURSE "$ENV{DESTDIR}${folder}/__pycache__")
  endif ()
  list(APPEND folders "${folder}")
endforeach ()

# Each parent as well, the deepest first; what holds anything else stays.
while (folders)
  list(REMOVE_DUPLICATES folders)
  set(parents)
  foreach (folder IN LISTS folders)
    file(GLOB content LIST_DIRECTORIES ON "$ENV{DESTDIR}${folder}/*" "$ENV{DESTDIR}${folder}/.*")
    if (EXISTS "$ENV{DESTDIR}${folder}" AND NOT content)
      file(REMOVE_RECURSE "$ENV{DESTDIR}${folder}")
      get_filename_component(parent "${folder}" DIRECTORY)
      list(APPEND parents "${parent}")
    endif ()
  endforeach ()
  set(folders "${parents}")
endwhile ()

file(REMOVE "${MANIFEST}")
list(LENGTH files number)
list(GET files 0 first)
message(STATUS "${number} files removed, the first was ${first}")
