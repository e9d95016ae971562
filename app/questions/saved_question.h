#pragma once

#include "app/questions/answer.h"
#include "scenarios/project/results/saved_answer.h"

namespace noonmark {

/// The content of an answer that was read back from a project.
struct SavedContent {
    std::shared_ptr<const SavedResult> result;
    SavedAnswer answer;
    std::vector<std::string> changes;        ///< of buildings and files since it was saved, a sentence each
    std::vector<std::string> weightChanges;  ///< of a score's weight table
    [[nodiscard]] bool upToDate() const { return changes.empty() && weightChanges.empty(); }
};

/// It is read, not computed.
const Question& savedQuestion();

/// For use in a job. Error: as of readSavedAnswer().
Result<std::shared_ptr<const Answer>> readSaved(const std::shared_ptr<const SavedResult>& result,
                                                const Project& project);

}  // namespace noonmark
