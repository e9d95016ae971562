#include "app/gui/base/widgets/error_text.h"
#include "app/gui/docks/review/review_cache.h"
#include "app/gui/docks/scenarios/latest_answers.h"
#include "app/gui/docks/scenarios/scenario_table.h"
#include "app/gui/docks/weights/weights_model.h"
#include "app/gui/session/workbench.h"
#include "app/input/all_engines.h"
#include "core/receivers/roof_receivers.h"
#include "core/study/provenance/study_hash.h"
#include "scenarios/scenario.h"

// The jobs of LatestAnswers: impacts from studies at hand, scores, and saved results.
namespace noonmark {

void LatestAnswers::compareStudies() {
    const StudySettings& settings = from_.workbench.document().settings();
    if (comparing_.busy() || !checkOnGround(settings.receivers.places)) return;
    const auto studies = from_.workbench.studies();
    const auto first = studies.find(baseline());
    if (first == studies.end() || first->second->settings != settings) return;
    std::vector<std::pair<CityPointer, std::shared_ptr<const Study>>> lacking;
    const CityPointer before = cityOf(baseline());
    for (const auto& [name, study] : studies) {
        const CityPointer city = cityOf(name);
        if (city != before && areComparable(*first->second, *study) && !impactOf(city))
            lacking.emplace_back(city, study);
    }
    if (lacking.empty()) return;
    using Made = std::vector<ImpactFigures>;
    comparing_.start<Made>(
        tr("Comparison"),
        [base = first->second, lacking](Progress&, const std::stop_token&) -> Result<Made> {
            Made made;
            for (const auto& [city, study] : lacking) made.push_back(noonmark::compareStudies(*base, *study));
            return made;
        },
        [this, before, lacking](const Result<Made>& made) {
            if (!made) return Q_EMIT failed(made.error());
            for (std::size_t i = 0; i < lacking.size(); ++i)
                add({lacking[i].first,
                     before,
                     {.question = hashQuestion(lacking[i].second->settings), .impact = (*made)[i]}});
            update();
        });
}

void LatestAnswers::scoreAll() {
    const StudySettings& settings = from_.workbench.document().settings();
    const TimeWeights& weights = from_.weights.table();
    std::vector<CityPointer> lacking;
    std::vector<std::string> names;
    for (const std::string& name : listNames(from_.workbench.session().project().scenarios))
        if (const CityPointer city = cityOf(name); city && !scoreOf(city)) {
            lacking.push_back(city);
            names.push_back(name);
        }
    using Made = std::vector<Result<Score>>;
    scoring_.start<Made>(
        tr("All scores"),
        [lacking, settings, weights](Progress& progress, const std::stop_token& stop) -> Result<Made> {
            const auto compute = [&](const CityPointer& city, Progress& share,
                                     const std::stop_token& stopped) -> Result<Score> {
                auto score = runScore(*city, settings, weights, share, stopped, enginesWith(settings.engine));
                if (score) score->score.clear();  // of each cell: only its sums are shown
                return score;
            };
            return computeEach<Score>(lacking, compute, progress, stop);
        },
        [this, lacking, names, settings, weights](Result<Made> scores) {
            if (!scores) return isCancelled(scores.error()) ? void() : Q_EMIT failed(scores.error());
            const std::size_t all = scores->size();
            const ScenarioErrors errors =
                adoptEach(*std::move(scores), names, [&](Score score, std::size_t i) {
                    add({lacking[i],
                         nullptr,
                         {.question = hashQuestion(settings),
                          .weights = weights,
                          .score = score,
                          .scoreMonths = std::move(score.months),
                          .scoreErrors = std::move(score.errors),
                          .scoreWithTrees = withoutMaps(std::move(score.withTrees))}});
                });
            if (errors.size() < all) from_.workbench.session().noteAnswer();
            update();
            for (const auto& [scenario, error] : errors) noteFailure(scenario, ScenarioWork::scoring, error);
            if (!errors.empty()) Q_EMIT failed(sumUp(errors, all));
        });
}

void LatestAnswers::noteFailure(const std::string& scenario, ScenarioWork work, const Error& error) {
    table_.noteFailure(scenario, work, describeError(error));
}

// Each saved result is read once, for the cities of that time: after an edit it counts no longer.
void LatestAnswers::readSaved() {
    if (reading_.busy()) return;
    const Project& project = from_.workbench.session().project();
    std::vector<std::shared_ptr<const SavedResult>> unread;
    for (const auto& result : project.results)
        if (!read_.contains(result)) unread.push_back(result);
    if (unread.empty()) return;
    std::vector<std::pair<CityPointer, CityPointer>> cities;
    for (const auto& result : unread) {
        read_.insert(result);
        cities.emplace_back(cityOf(result->scenario), cityOf(result->baseline));
    }
    using Read = std::vector<std::optional<SavedFigures>>;
    reading_.start<Read>(
        tr("Reading saved results"),
        [unread, project](Progress&, const std::stop_token& stop) -> Result<Read> {
            Read read;
            for (const auto& result : unread) {
                if (stop.stop_requested()) return cancelled();
                read.push_back(readSavedFigures(*result, project));
            }
            return read;
        },
        [this, cities](const Result<Read>& read) {
            if (!read) return;
            for (std::size_t i = 0; i < cities.size(); ++i)
                if ((*read)[i]) add({cities[i].first, cities[i].second, *(*read)[i]});
            update();
        });
}

// Figures count for the cities of today's scenarios that have the hashes they were saved with.
void LatestAnswers::readViewFigures() {
    auto saved = parseViewFigures(figuresInView());
    if (saved.empty()) return;
    using Hashes = std::map<CityPointer, std::string>;
    hashing_.start<Hashes>(
        tr("Comparing buildings"),
        [cities = cities()](Progress&, const std::stop_token& stop) -> Result<Hashes> {
            Hashes hashes;
            for (const CityPointer& city : cities) {
                if (stop.stop_requested()) return cancelled();
                hashes[city] = hashCity(*city);
            }
            return hashes;
        },
        [this, saved = std::move(saved)](const Result<Hashes>& hashes) {
            if (!hashes) return;
            hashes_.insert(hashes->begin(), hashes->end());
            addViewFigures(saved);
        });
}

void LatestAnswers::addViewFigures(const std::vector<ViewFigures>& saved) {
    std::vector<Known> read;
    for (const ViewFigures& one : saved)
        for (const auto& [city, hash] : hashes_) {
            if (hash != one.citySha256) continue;
            if (!one.figures.impact) read.push_back({city, nullptr, one.figures});
            for (const auto& [before, other] : hashes_)
                if (one.figures.impact && other == one.baselineSha256)
                    read.push_back({city, before, one.figures});
        }
    known_.insert(known_.begin(), read.begin(), read.end());  // older than what was computed meanwhile
    update();
}

}  // namespace noonmark
