#include <iostream>

#include "app/cli/command_line.h"
#include "core/base/process.h"

int main(int argc, char** argv) {
    return noonmark::cli::runCommandLine(
        argc, argv, {std::cout, std::cerr, noonmark::isTerminal(noonmark::StandardStream::error)});
}
