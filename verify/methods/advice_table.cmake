# cmake -DTABLE=methods.csv -DOUTPUT=file -P advice_table.cmake: each line of the table as a C++ string of its own.
file(READ ${TABLE} text)
string(STRIP "${text}" text)
string(REPLACE "\n" ")\",\nR\"(" text "${text}")
file(WRITE ${OUTPUT} "R\"(${text})\",\n")
