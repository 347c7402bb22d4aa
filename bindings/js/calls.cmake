# The table of calls as a module of JavaScript. cmake -DFROM=calls.json -DTO=calls.js -P calls.cmake
file(READ ${FROM} text)
file(WRITE ${TO} "export default ${text}")
