#include "app/window/scenarios/latest_answers.h"

#include "app/window/frame/workbench.h"
#include "app/window/review/windows/window_session.h"
#include "app/window/scenarios/scenario_table.h"
#include "app/window/weights/weights_model.h"
#include "scenarios/scenario_list.h"

namespace noonmark {

namespace {

constexpr std::size_t mostKnown = 64;  // figures; each holds the list of its city's buildings

template <class Known>
void keep(std::vector<Known>& all, Known one) {
    all.push_back(std::move(one));
    if (all.size() > mostKnown) all.erase(all.begin());
}

template <class Known, class Holds>
const Known* findNewest(const std::vector<Known>& all, const Holds& holds) {
    for (auto one = all.rbegin(); one != all.rend(); ++one)
        if (holds(*one)) return &*one;
    return nullptr;
}

ScenarioVerdicts countVerdicts(const ReviewAnswer& answer) {
    ScenarioVerdicts verdicts{answer.question.rule.name, answer.question.from, {}};
    for (const PlaceReview& place : answer.study.places) verdicts.counts.add(place.verdict);
    return verdicts;
}

ScenarioVerdicts countVerdicts(const WindowAnswer& answer) {
    return {answer.question.rule.name, answer.question.from, answer.study.windowChanges.after};
}

template <class Answers>
std::map<std::string, ScenarioVerdicts> countEach(const Answers& answers) {
    std::map<std::string, ScenarioVerdicts> all;
    for (const auto& [scenario, answer] : answers) all[scenario] = countVerdicts(*answer);
    return all;
}

}  // namespace

LatestAnswers::LatestAnswers(const Sources& sources, ScenarioTable& table, QObject* parent)
    : QObject(parent), from_(sources), table_(table) {
    Workbench& workbench = from_.workbench;
    workbench.setScenarioAnswers([this] { return all(); });
    connect(&workbench, &Workbench::projectOpened, this, &LatestAnswers::forget);
    connect(&workbench, &Workbench::comparisonDone, this, &LatestAnswers::takeComparison);
    connect(&workbench, &Workbench::scoreDone, this, &LatestAnswers::takeScore);
    connect(&workbench, &Workbench::studyDone, this, &LatestAnswers::update);
    connect(&workbench.document(), &StudyDocument::changed, this, &LatestAnswers::update);
    for (auto signal : {&ProjectSession::changed, &ProjectSession::baselineChanged})
        connect(&workbench.session(), signal, this, &LatestAnswers::update);
    const auto unlessShaping = [this] {  // a shape that is dragged changes no scenario
        if (!from_.review.isShaping()) update();
    };
    connect(&from_.review, &ReviewSession::answered, this, unlessShaping);
    connect(&from_.windows, &WindowSession::answered, this, unlessShaping);
    connect(&from_.weights, &WeightsModel::chosen, this, &LatestAnswers::update);
}

LatestAnswers::Fits LatestAnswers::sameAs(const StudySettings& settings) {
    return [settings](const StudySettings& now) { return now == settings; };
}

void LatestAnswers::add(KnownImpact impact) { keep(impacts_, std::move(impact)); }
void LatestAnswers::add(KnownScore score) { keep(scores_, std::move(score)); }

void LatestAnswers::forget() {
    for (JobSlot* slot : {&scoring_, &comparing_, &reading_}) slot->drop();
    impacts_.clear();
    scores_.clear();
    read_.clear();
    update();
}

void LatestAnswers::update() {
    const auto rule = from_.review.rule();
    table_.setAnswers(all(), {baseline(), from_.weights.table().name, rule ? rule->name : std::string()});
    compareStudies();
    readSaved();
}

LatestAnswers::CityPointer LatestAnswers::cityOf(const std::string& scenario) {
    return from_.workbench.session().cityOf(scenario).value_or(nullptr);
}

std::string LatestAnswers::baseline() const {
    const std::string& chosen = from_.workbench.session().baseline();
    return chosen.empty() ? existingCity : chosen;
}

std::map<std::string, ScenarioAnswers> LatestAnswers::all() {
    std::map<std::string, ScenarioAnswers> all;
    auto verdicts = this->verdicts();
    for (const std::string& name : listNames(from_.workbench.session().project().scenarios)) {
        const CityPointer city = cityOf(name);
        if (!city) continue;
        ScenarioAnswers& answers = all[name];
        answers = {impactOf(city), scoreOf(city), std::nullopt};
        if (const auto found = verdicts.find(name); found != verdicts.end()) answers.verdicts = found->second;
    }
    return all;
}

std::optional<ScenarioImpact> LatestAnswers::impactOf(const CityPointer& city) {
    const CityPointer before = cityOf(baseline());
    const auto* known = findNewest(impacts_, [&](const KnownImpact& one) {
        return one.before == before && one.after == city && one.fits(from_.workbench.document().settings());
    });
    if (!known) return std::nullopt;
    return ScenarioImpact{baseline(), known->figures};
}

std::optional<ScenarioScore> LatestAnswers::scoreOf(const CityPointer& city) {
    const TimeWeights& weights = from_.weights.table();
    const auto* known = findNewest(scores_, [&](const KnownScore& one) {
        return one.city == city && one.weights.intervals == weights.intervals &&
               one.fits(from_.workbench.document().settings());
    });
    if (!known) return std::nullopt;
    return ScenarioScore{weights.name, known->scoreM2};
}

std::map<std::string, ScenarioVerdicts> LatestAnswers::verdicts() {
    return from_.windows.applies() ? countEach(from_.windows.latest()) : countEach(from_.review.latest());
}

// The workbench emits a comparison only while the cities are those that it compared.
void LatestAnswers::takeComparison() {
    if (const auto comparison = from_.workbench.comparison())
        add(KnownImpact{cityOf(comparison->from), cityOf(comparison->to), sameAs(comparison->settings.study),
                        computeFigures(comparison->study.total, comparison->thresholdsMin.front())});
    update();
}

void LatestAnswers::takeScore() {
    if (const auto score = from_.workbench.score())
        add(KnownScore{cityOf(score->scenario), sameAs(score->settings), score->weights,
                       score->score.scoreM2});
    update();
}

void LatestAnswers::reviewAll() { from_.windows.applies() ? from_.windows.runAll() : from_.review.runAll(); }

}  // namespace noonmark
