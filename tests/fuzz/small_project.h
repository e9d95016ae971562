#pragma once

#include "tests/scenarios/sample_project.h"

namespace noonmark::tests {

/// The sample project with a small result, since each input reads all of it.
inline Project smallProject() {
    Project project = sampleProject();
    project.results = {keptResult("first", 12, 9)};
    return project;
}

}  // namespace noonmark::tests
