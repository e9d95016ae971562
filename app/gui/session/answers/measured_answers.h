#pragma once

#include <mutex>

#include "app/gui/session/answers/answer_origin.h"
#include "app/questions/answer.h"

namespace noonmark {

/// An answer with the cities it is about, which identify it, since scenarios may be renamed.
struct KnownAnswer {
    std::shared_ptr<const City> city;
    std::shared_ptr<const City> before;    ///< of a comparison
    std::shared_ptr<const Answer> answer;  ///< null: not computed yet
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
