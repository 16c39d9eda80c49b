# cmake -DIN=PAGE.html -DOUT=FILE.html -P page.cmake: the page with the scripts that it names (`<script src="name.js">`) in
# their places, one file that needs no others.
get_filename_component(folder ${IN} DIRECTORY)
file(READ ${IN} page)
string(REGEX MATCHALL "<script src=\"[a-z]+\\.js\"></script>" tags "${page}")
foreach(tag IN LISTS tags)
  string(REGEX REPLACE ".*\"(.*)\".*" "\\1" name "${tag}")
  file(READ ${folder}/${name} script)
  string(REPLACE "${tag}" "<script>\n${script}</script>" page "${page}")
endforeach()
file(WRITE ${OUT} "${page}")
