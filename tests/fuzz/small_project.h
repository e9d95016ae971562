#pragma once

#include "tests/scenarios/sample_project.h"

namespace noonmark::tests {

/// The sample project with a small result, since each input reads all of it.
inline Project smallProject() {
    Project project = sampleProject();
    SavedResult result = *makeSavedResult("first", 12, 9);
    result.layers.resize(1);
    project.results = {std::make_shared<const SavedResult>(std::move(result))};
    return project;
}

}  // namespace noonmark::tests
