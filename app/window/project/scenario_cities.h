#pragma once

#include <memory>
#include <vector>

#include "scenarios/project/project.h"

namespace noonmark {

/// The cities that scenarios make, made once: a list of edits that begins like one that was applied before
/// goes on from there. So a city shares with its base what the base built, and an edit costs itself.
class ScenarioCities {
public:
    /// Errors as of cityOf(). Asked again the answer is the same city.
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
