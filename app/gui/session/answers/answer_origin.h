#pragma once

#include "app/gui/session/project/project_session.h"
#include "core/study/elements/element_study.h"
#include "scenarios/impact/impact_text.h"
#include "scenarios/project/project_provenance.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

/// A snapshot of the project when a result was displayed, to state the result's provenance later: the
/// scenarios' names and edits, and whether the file contains them. Use it in a job: stating costs the hashes
/// of provenanceOf().
class AnswerOrigin {
public:
    explicit AnswerOrigin(const ProjectSession& session);

    /// The study is of the scenario displayed at the time of the snapshot.
    [[nodiscard]] Study stated(Study study) const { return stated(std::move(study), scenario_); }
    [[nodiscard]] Study stated(Study study, const std::string& scenario) const;
    [[nodiscard]] ElementStudy stated(ElementStudy study) const;
    [[nodiscard]] ImpactAnswer stated(ImpactAnswer answer) const;
    [[nodiscard]] ScoreAnswer stated(ScoreAnswer answer) const;

private:
    [[nodiscard]] Provenance of(const MeasuredPart& part) const;

    Project project_;
    std::optional<ProjectFile> file_;
    std::string scenario_;
};

}  // namespace noonmark
