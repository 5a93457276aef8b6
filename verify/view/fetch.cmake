# cmake -DNPM=program -DSOURCE=folder -DFOLDER=folder -DREQUIRED=bool -P fetch.cmake: fetches what SOURCE's
# package-lock.json pins into FOLDER/node_modules. What cannot be fetched is an error if REQUIRED, else FOLDER/plot says
# so by being empty.
file(MAKE_DIRECTORY ${FOLDER})
file(COPY ${SOURCE}/package.json ${SOURCE}/package-lock.json DESTINATION ${FOLDER})
execute_process(COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --prefer-offline
  WORKING_DIRECTORY ${FOLDER} RESULT_VARIABLE status OUTPUT_VARIABLE words ERROR_VARIABLE words)
string(SUBSTRING "${words}" 0 300 words)
if(status EQUAL 0)
  file(WRITE ${FOLDER}/plot "${FOLDER}/node_modules/uplot")
elseif(REQUIRED)
  message(FATAL_ERROR "npm cannot fetch the plotting library of `gpf view` (${words}): connect to the network, or "
    "configure with -D GPF_VIEW=OFF")
else()
  file(WRITE ${FOLDER}/plot "")
  message(WARNING "npm cannot fetch the plotting library (${words}): `gpf view` will write no pages; "
    "-D GPF_VIEW=ON tries again")
endif()
