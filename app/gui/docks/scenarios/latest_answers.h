#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/gui/base/jobs/job.h"
#include "app/report/scenarios/scenario_study.h"
#include "core/measures/statistics.h"
#include "core/study/provenance/study_hash.h"
#include "scenarios/impact/impact_figures.h"
#include "scenarios/project/project.h"
#include "scenarios/weights/score.h"

namespace noonmark {

/// Figures of a scenario that were computed before, with what they depend on.
struct SavedFigures {
    std::string question;  ///< hashQuestion(); empty in results of versions that did not store it
    std::optional<ShadowStatistics> measured;  ///< of a study
    std::optional<ImpactFigures> impact;       ///< of a comparison, for its first threshold
    std::optional<TimeWeights> weights;        ///< of a score
    ScoreTotals score;
    std::vector<MonthFigures> scoreMonths;  ///< of it; empty in results of versions that did not save them
    std::vector<ShownError> scoreErrors{};  ///< likewise
    std::vector<ShadedScore> scoreWithTrees{};  ///< without their maps
    std::optional<ScenarioSun> sun{};           ///< of places; `question` is that of their study
    std::string settings;  ///< JSON: period, engine, cells and region's name, where there is no question
    Grid grid;             ///< likewise
};

/// Reads those of a saved result if the project would still give it; use it in a job. Nothing: another kind,
/// damaged, or out of date. Costs a hash of the scenario's city and of the baseline's.
std::optional<SavedFigures> readSavedFigures(const SavedResult& result, const Project& project);

/// Whether they were computed with these settings, of which `hashes` are those. Where the figures state
/// none, settings and the region's name and extent decide.
bool haveSettings(const SavedFigures& saved, const StudySettings& settings, const QuestionHashes& hashes);

/// Figures as they are saved in the project's view, so that they are there again when it is opened: they
/// count for a city of these hashes (hashCity), whatever its scenario is called.
struct ViewFigures {
    std::string citySha256;
    std::string baselineSha256;  ///< of a comparison
    SavedFigures figures;        ///< with a question
};
inline constexpr const char* viewFiguresKey = "figures";  ///< in Project::view

/// As JSON text, and back. Reads what is valid of any text, since the file may come from anywhere.
std::string formatText(const std::vector<ViewFigures>& saved);
std::vector<ViewFigures> parseViewFigures(const std::string& text);

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
    void adoptSun();
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
    [[nodiscard]] const SavedFigures* latestSun() const;
    [[nodiscard]] std::optional<ScenarioSun> sunOf(const CityPointer& city) const;
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
