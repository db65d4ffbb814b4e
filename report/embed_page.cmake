# Joins the files of report/page and Vega's modules into one page and writes it as a C++ string.
# cmake -DPAGE=folder -DVEGA=folder -DSCRIPTS=a.js,b.js -DOUTPUT=page_template.cpp -P embed_page.cmake

# Vega's modules that the plots use (Debian ships them apart), as file:module where the names differ.
set(vega_modules util time format loader dataflow statistics scale canvas scenegraph expression selection:selections
                 functions runtime event-selector parser view transforms view-transforms encode)

file(READ ${PAGE}/modules.js vega)
foreach(entry ${vega_modules})
  string(REGEX REPLACE ":.*" "" file ${entry})
  string(REGEX REPLACE ".*:" "" module ${entry})
  file(READ ${VEGA}/vega-${file}.min.js source)
  string(REGEX REPLACE "//# sourceMappingURL=[^\n]*" "" source "${source}")
  string(APPEND vega "define_module('vega-${module}', function (exports, require, module) {\n${source}\n});\n")
endforeach()

string(REPLACE "," ";" SCRIPTS "${SCRIPTS}")
set(scripts "")
foreach(script ${SCRIPTS})
  file(READ ${PAGE}/${script} source)
  string(APPEND scripts "${source}\n")
endforeach()

file(READ ${PAGE}/style.css style)
file(READ ${PAGE}/page.html page)
string(REPLACE "{{style}}" "${style}" page "${page}")
string(REPLACE "{{vega}}" "${vega}" page "${page}")
string(REPLACE "{{scripts}}" "${scripts}" page "${page}")

file(WRITE ${OUTPUT} "#include <string_view>\n\nnamespace demens::report {\nextern std::string_view const page_template;\n")
file(APPEND ${OUTPUT} "constexpr char text[] = R\"demens_page(${page})demens_page\";\n")
file(APPEND ${OUTPUT} "std::string_view const page_template{text, sizeof(text) - 1};\n} // namespace demens::report\n")
