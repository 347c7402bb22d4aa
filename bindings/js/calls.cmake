# A part of the table of calls as a module of JavaScript. cmake -DFROM=core.json -DTO=core.js -P calls.cmake
file(READ ${FROM} text)
file(WRITE ${TO} "export default ${text}")
