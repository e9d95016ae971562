// Nothing of its own: the library around it holds the headers that all test programs share
// (tests/CMakeLists.txt).
