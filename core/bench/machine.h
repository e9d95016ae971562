#pragma once

#include <string>

namespace noonmark::bench {

/// What a time depends on.
struct Machine {
    std::string processor;  ///< model, as the system calls it; "unknown processor" where it does not say
    int threads = 1;        ///< that the engines use
};

/// The one at hand.
Machine detectMachine();

/// "AMD EPYC, 2 threads"
std::string describeMachine(const Machine& machine);

}  // namespace noonmark::bench
