#include <cstdlib>
#include <iostream>

#include "app/cli/base/command_line.h"
#include "app/cli/base/interrupt.h"
#include "core/base/process.h"

// Everything is written and closed by then. What is left to free ends with the process: the destructors of
// GDAL and Qt would take some 10 ms.
int main(int argc, char** argv) {
    const noonmark::cli::SignalWatch watch;
    const int status = noonmark::cli::runCommandLine(
        argc, argv, {std::cout, std::cerr, noonmark::isTerminal(noonmark::StandardStream::error)});
    std::cout.flush();
    std::cerr.flush();
    std::_Exit(status);
}
