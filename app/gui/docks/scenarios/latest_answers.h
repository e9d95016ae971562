#pragma once

#include <map>
#include <set>

#include "app/gui/base/jobs/job.h"
#include "app/gui/docks/scenarios/saved_figures.h"
#include "app/report/scenarios/scenario_study.h"

namespace noonmark {

enum class ScenarioWork;
class ReviewSession;
class ScenarioTable;
class WeightsModel;
class GlazingSession;
class Workbench;

/// The latest figures, impact, score and verdicts of each scenario, from what the window computed, from the
/// project's saved results, and from the figures that were saved with its view. Only those count whose
/// buildings, settings, weights, rule and places are as they are now. Fills a ScenarioTable.
class LatestAnswers final : public QObject {
    Q_OBJECT
public:
    struct Sources {
        Workbench& workbench;
        ReviewSession& review;
        GlazingSession& windows;
        WeightsModel& weights;  ///< of the chosen table
    };
    /// All must outlive it.
    LatestAnswers(const Sources& sources, ScenarioTable& table, QObject* parent = nullptr);

    [[nodiscard]] std::map<std::string, ScenarioAnswers> all();

    /// The figures of the present scenarios as text, to be saved with the project's view (viewFiguresKey);
    /// empty if there are none. Costs a hash of each city whose figures are new.
    [[nodiscard]] std::string figuresToSave();

    /// Computes the scores that all() lacks, with the chosen weights.
    void scoreAll();
    /// Reviews, by the chosen rule, the scenarios whose verdicts all() lacks.
    void reviewAll();

    [[nodiscard]] JobSlot& scoring() { return scoring_; }
    [[nodiscard]] bool busy() const {
        return scoring_.busy() || comparing_.busy() || reading_.busy() || hashing_.busy();
    }

Q_SIGNALS:
    void failed(noonmark::Error error);  ///< not emitted for cancelled work

private:
    using CityPointer = std::shared_ptr<const City>;
    struct Known {
        CityPointer city;
        CityPointer before;  ///< of a comparison
        SavedFigures figures;
    };
    void update();
    void forget();
    void adoptAnswer();
    void noteFailure(const std::string& scenario, ScenarioWork work, const Error& error);
    void compareStudies();
    void readSaved();
    [[nodiscard]] std::string figuresInView() const;
    void readViewFigures();
    void addViewFigures(const std::vector<ViewFigures>& saved);
    void add(Known known);
    /// The newest that fits the settings as they are now.
    template <class Holds>
    [[nodiscard]] const SavedFigures* find(const Holds& holds) const;
    [[nodiscard]] std::vector<CityPointer> cities();
    [[nodiscard]] std::string hashOf(const CityPointer& city);
    [[nodiscard]] std::vector<Known> ofStudies();
    [[nodiscard]] std::optional<ShadowStatistics> measuredOf(const CityPointer& city) const;
    [[nodiscard]] CityPointer cityOf(const std::string& scenario);
    [[nodiscard]] std::string baseline() const;
    [[nodiscard]] std::optional<ScenarioImpact> impactOf(const CityPointer& city);
    [[nodiscard]] std::optional<ScenarioScore> scoreOf(const CityPointer& city) const;
    [[nodiscard]] std::map<std::string, ScenarioVerdicts> verdicts();

    Sources from_;
    ScenarioTable& table_;
    std::vector<Known> known_;                   // oldest first
    std::map<CityPointer, std::string> hashes_;  // hashCity()
    QuestionHashes question_;                    // of the settings as they are now
    std::set<std::shared_ptr<const SavedResult>> read_;
    JobSlot scoring_;
    JobSlot comparing_;
    JobSlot reading_;
    JobSlot hashing_;
};

}  // namespace noonmark
