#pragma once

#include "app/window/project/project_session.h"
#include "scenarios/impact/impact_text.h"
#include "scenarios/project/project_provenance.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

/// The project at a moment, to state what an answer shown then came from: its scenarios' names and edits, and
/// whether its file holds them. For a job: costs the hashes of provenanceOf().
class AnswerOrigin {
public:
    explicit AnswerOrigin(const ProjectSession& session);

    /// Of the scenario that was shown then.
    [[nodiscard]] Study stated(Study study) const;
    [[nodiscard]] ImpactAnswer stated(ImpactAnswer answer) const;
    [[nodiscard]] ScoreAnswer stated(ScoreAnswer answer) const;

private:
    [[nodiscard]] Provenance of(const MeasuredPart& part) const;

    Project project_;
    std::optional<ProjectFile> file_;
    std::string scenario_;
};

}  // namespace noonmark
