#pragma once

#include <mutex>
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
    /// `weights`: name of the table that the scenario was scored with; empty: none.
    [[nodiscard]] std::shared_ptr<const Study> stated(Study study, const std::string& scenario,
                                                      const std::string& weights = {}) const {
        MeasuredPart part{scenario, {}, study.settings.region, {}};
        if (const auto table = findWeights(project_, weights); table && !weights.empty())
            part.weights = *table;
        study.provenance = of(part);
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

/// An answer with the cities it is about, which identify it, since scenarios may be renamed.
struct KnownAnswer {
    std::shared_ptr<const City> city;
    std::shared_ptr<const City> before;    ///< of a comparison
    std::shared_ptr<const Answer> answer;  ///< null: not computed yet
    /// Of sun by place: further scenarios with their cities.
    std::vector<std::pair<std::string, std::shared_ptr<const City>>> others{};
};

/// An answer that the project keeps without being asked: it is saved with the project and listed when the
/// project is opened again. Computed in this session, or read from the project file.
class MeasuredAnswer {
public:
    /// `name`: that of the result in the project file.
    MeasuredAnswer(KnownAnswer known, const ProjectSession& session, std::string name);
    explicit MeasuredAnswer(std::shared_ptr<const SavedResult> read);

    /// Without an answer where it was read from the project file.
    [[nodiscard]] const KnownAnswer& known() const { return known_; }
    [[nodiscard]] const std::string& name() const { return name_; }
    /// Whether `later` answers the same question about the same scenario, whatever its buildings.
    [[nodiscard]] bool isReplacedBy(const Answer& later) const;
    /// As the project file holds it. The first call costs the hashes of Answer::toSave(). On any thread.
    [[nodiscard]] std::shared_ptr<const SavedResult> toSave() const;

private:
    KnownAnswer known_;
    std::optional<AnswerOrigin> origin_;  ///< none: it was read
    std::string name_;
    mutable std::once_flag made_;
    mutable std::shared_ptr<const SavedResult> saved_;
};

/// Oldest first.
using MeasuredAnswers = std::vector<std::shared_ptr<const MeasuredAnswer>>;

/// The project as it is saved: with the measured answers among its results, and their names in its view. The
/// oldest are left out where the maps of all have more than maxMeasuredCells. Use it in a job.
Project withMeasured(Project project, const MeasuredAnswers& measured);
inline constexpr std::size_t maxMeasuredCells = 32'000'000;  ///< 128 MB of float32 before compression

/// Takes the measured answers of a project that was read out of its results.
MeasuredAnswers takeMeasured(Project& project);

}  // namespace noonmark
