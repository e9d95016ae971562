#pragma once

#include <functional>
#include <map>
#include <set>

#include "app/report/scenarios/scenario_study.h"
#include "app/window/scenarios/saved_figures.h"
#include "app/window/study/job_slot.h"

namespace noonmark {

class ReviewSession;
class ScenarioTable;
class WeightsModel;
class WindowSession;
class Workbench;

/// The latest impact, score and verdicts of each scenario, from what the window computed and from the
/// project's saved results. Only those count whose buildings, settings, weights, rule and places are as they
/// are now. Fills a ScenarioTable.
class LatestAnswers final : public QObject {
    Q_OBJECT
public:
    struct Sources {
        Workbench& workbench;
        ReviewSession& review;
        WindowSession& windows;
        WeightsModel& weights;  ///< of the chosen table
    };
    /// All must outlive it.
    LatestAnswers(const Sources& sources, ScenarioTable& table, QObject* parent = nullptr);

    [[nodiscard]] std::map<std::string, ScenarioAnswers> all();

    /// Computes the scores that all() lacks, with the chosen weights.
    void scoreAll();
    /// Reviews, by the chosen rule, the scenarios whose verdicts all() lacks.
    void reviewAll();

    [[nodiscard]] JobSlot& scoring() { return scoring_; }
    [[nodiscard]] bool busy() const { return scoring_.busy() || comparing_.busy() || reading_.busy(); }

Q_SIGNALS:
    void failed(noonmark::Error error);  ///< not emitted for cancelled work

private:
    using CityPointer = std::shared_ptr<const City>;
    using Fits = std::function<bool(const StudySettings&)>;
    struct KnownImpact {
        CityPointer before, after;
        Fits fits;
        ImpactFigures figures;
    };
    struct KnownScore {
        CityPointer city;
        Fits fits;
        TimeWeights weights;
        double scoreM2 = 0;
    };
    static Fits sameAs(const StudySettings& settings);
    void update();
    void forget();
    void takeComparison();
    void takeScore();
    void compareStudies();
    void readSaved();
    void takeSaved(const SavedFigures& saved, const CityPointer& city, const CityPointer& before);
    void add(KnownImpact impact);
    void add(KnownScore score);
    [[nodiscard]] CityPointer cityOf(const std::string& scenario);
    [[nodiscard]] std::string baseline() const;
    [[nodiscard]] std::optional<ScenarioImpact> impactOf(const CityPointer& city);
    [[nodiscard]] std::optional<ScenarioScore> scoreOf(const CityPointer& city);
    [[nodiscard]] std::map<std::string, ScenarioVerdicts> verdicts();

    Sources from_;
    ScenarioTable& table_;
    std::vector<KnownImpact> impacts_;  // oldest first
    std::vector<KnownScore> scores_;    // likewise
    std::set<std::shared_ptr<const SavedResult>> read_;
    JobSlot scoring_;
    JobSlot comparing_;
    JobSlot reading_;
};

}  // namespace noonmark
