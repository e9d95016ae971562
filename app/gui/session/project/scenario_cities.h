#pragma once

#include <memory>
#include <vector>

#include "scenarios/project/project.h"

namespace noonmark {

/// Caches the cities of scenarios. A list of edits that begins with one applied before continues from its
/// city, so that a scenario shares buildings with its base and an edit costs only itself.
class ScenarioCities {
public:
    /// Errors as of cityOf(). Repeated calls return the same city.
    Result<std::shared_ptr<const City>> cityOf(const Project& project, const std::string& scenario);

private:
    struct Made {
        std::vector<Edit> edits;
        std::shared_ptr<const City> city;
    };
    [[nodiscard]] Made nearest(const std::vector<Edit>& edits) const;

    std::shared_ptr<const City> existing_;
    std::vector<Made> made_;  // oldest first
};

}  // namespace noonmark
