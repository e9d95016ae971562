#pragma once

#include <tuple>
#include <utility>

#include "app/gui/session/project/project_session.h"
#include "app/questions/answer.h"

namespace noonmark {

/// A snapshot of the project when an answer was displayed, to state its provenance later. Use it in a job:
/// stating costs the hashes of provenanceOf().
class AnswerOrigin {
public:
    explicit AnswerOrigin(const ProjectSession& session)
        : project_(session.project()), file_(session.file()) {}

    [[nodiscard]] const Project& project() const { return project_; }
    /// A saved result states its own origin and stays as it is.
    [[nodiscard]] std::shared_ptr<const Answer> stated(const std::shared_ptr<const Answer>& answer) const {
        return answer->isSaved() ? answer : answer->stated(of(answer->part()));
    }
    [[nodiscard]] std::shared_ptr<const Study> stated(Study study, const std::string& scenario) const {
        study.provenance = of({scenario, {}, study.settings.region, {}});
        return std::make_shared<const Study>(std::move(study));
    }

    /// Whether both state the same of any answer, so far as no other program saves the file.
    bool operator==(const AnswerOrigin& other) const {
        const auto content = [](const Project& p) {
            return std::tie(p.city, p.reading, p.attribution, p.regions, p.places, p.scenarios, p.weights);
        };
        const auto file = [](const std::optional<ProjectFile>& f) {
            return f ? std::pair(f->path(), f->saves()) : std::pair(std::filesystem::path(), std::int64_t{0});
        };
        return content(project_) == content(other.project_) && file(file_) == file(other.file_);
    }

private:
    [[nodiscard]] Provenance of(const MeasuredPart& part) const {
        return provenanceOf(project_, file_ ? &*file_ : nullptr, part);
    }

    Project project_;
    std::optional<ProjectFile> file_;
};

}  // namespace noonmark
