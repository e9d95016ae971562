#pragma once

#include <string>

namespace noonmark {

/// The name, or "name (2)", "name (3)"...: the first for which `isTaken(name)` is false.
template <class IsTaken>
std::string findFreeName(const std::string& name, IsTaken&& isTaken) {
    std::string free = name;
    for (int copy = 2; isTaken(free); ++copy) free = name + " (" + std::to_string(copy) + ")";
    return free;
}

}  // namespace noonmark
