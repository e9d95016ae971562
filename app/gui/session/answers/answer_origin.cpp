#include "app/gui/session/answers/answer_origin.h"

namespace noonmark {

AnswerOrigin::AnswerOrigin(const ProjectSession& session)
    : project_(session.project()), file_(session.file()), scenario_(session.scenario()) {}

Study AnswerOrigin::stated(Study study, const std::string& scenario) const {
    study.provenance = of({scenario, {}, study.settings.region, {}});
    return study;
}

ElementStudy AnswerOrigin::stated(ElementStudy study) const {
    study.provenance = of({scenario_, {}, study.settings.region, {}});
    return study;
}

ImpactAnswer AnswerOrigin::stated(ImpactAnswer answer) const {
    answer.provenance = of({answer.to, answer.from, answer.settings.study.region, {}});
    return answer;
}

ScoreAnswer AnswerOrigin::stated(ScoreAnswer answer) const {
    answer.provenance = of({answer.scenario, {}, answer.settings.region, answer.weights});
    return answer;
}

Provenance AnswerOrigin::of(const MeasuredPart& part) const {
    return provenanceOf(project_, file_ ? &*file_ : nullptr, part);
}

}  // namespace noonmark
