#include "app/gui/docks/scenarios/latest_answers.h"

#include <algorithm>

#include "app/gui/docks/review/glazing/glazing_session.h"
#include "app/gui/docks/scenarios/scenario_table.h"
#include "app/gui/docks/weights/weights_model.h"
#include "app/gui/session/workbench.h"
#include "core/study/provenance/study_hash.h"
#include "core/study/review_figures.h"
#include "scenarios/impact/impact_text.h"
#include "scenarios/scenario.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

namespace {

constexpr std::size_t maxKnown = 192;  // figures, of three kinds; each holds the list of its city's buildings

ScenarioVerdicts countVerdicts(const ReviewAnswer& answer) {
    return {answer.question.rule.name, answer.question.from, countVerdicts(answer.study)};
}

ScenarioVerdicts countVerdicts(const GlazingAnswer& answer) {
    return {answer.question.rule.name, answer.question.from, answer.study.windowChanges.after};
}

template <class Answers>
std::map<std::string, ScenarioVerdicts> countEach(const Answers& answers) {
    std::map<std::string, ScenarioVerdicts> all;
    for (const auto& [scenario, answer] : answers) all[scenario] = countVerdicts(*answer);
    return all;
}

// Whether figures answer the same question of the same buildings as older ones.
bool replaces(const ViewFigures& newer, const ViewFigures& older) {
    const SavedFigures &now = newer.figures, &then = older.figures;
    return newer.citySha256 == older.citySha256 && newer.baselineSha256 == older.baselineSha256 &&
           now.question == then.question && now.weights == then.weights &&
           now.measured.has_value() == then.measured.has_value() &&
           now.impact.has_value() == then.impact.has_value() && now.sun.has_value() == then.sun.has_value();
}

}  // namespace

LatestAnswers::LatestAnswers(const Sources& sources, ScenarioTable& table, QObject* parent)
    : QObject(parent), from_(sources), table_(table) {
    Workbench& workbench = from_.workbench;
    workbench.setScenarioAnswers([this] { return all(); });
    connect(&workbench, &Workbench::projectOpened, this, &LatestAnswers::forget);
    connect(&workbench, &Workbench::answered, this, &LatestAnswers::adoptAnswer);
    connect(&workbench, &Workbench::answerUpdated, this, [this] {  // other hours are enough
        adoptSun();
        update();
    });
    connect(&workbench.document(), &StudyDocument::changed, this, &LatestAnswers::update);
    for (auto signal : {&ProjectSession::changed, &ProjectSession::baselineChanged})
        connect(&workbench.session(), signal, this, &LatestAnswers::update);
    const auto unlessShaping = [this] {  // a shape that is dragged changes no scenario
        if (!from_.review.isShaping()) update();
    };
    connect(&from_.review, &ReviewSession::answered, this, unlessShaping);
    connect(&from_.windows, &GlazingSession::answered, this, unlessShaping);
    connect(&workbench, &Workbench::scenarioFailed, this, [this](const auto& scenario, const Error& error) {
        noteFailure(scenario, ScenarioWork::measuring, error);
    });
    const auto noteReview = [this](const std::string& scenario, const Error& error) {
        noteFailure(scenario, ScenarioWork::reviewing, error);
    };
    connect(&from_.review, &ReviewSession::scenarioFailed, this, noteReview);
    connect(&from_.windows, &GlazingSession::scenarioFailed, this, noteReview);
    connect(&from_.weights, &WeightsModel::chosen, this, &LatestAnswers::update);
}

void LatestAnswers::add(Known known) {
    known_.push_back(std::move(known));
    if (known_.size() > maxKnown) known_.erase(known_.begin());
}

template <class Holds>
const SavedFigures* LatestAnswers::find(const Holds& holds) const {
    const StudySettings& settings = from_.workbench.document().settings();
    for (auto one = known_.rbegin(); one != known_.rend(); ++one)
        if (holds(*one) && haveSettings(one->figures, settings, question_)) return &one->figures;
    return nullptr;
}

void LatestAnswers::forget() {
    for (JobSlot* slot : {&scoring_, &comparing_, &reading_, &hashing_}) slot->drop();
    known_.clear();
    hashes_.clear();
    read_.clear();
    table_.forgetPast();
    update();
    readViewFigures();
}

void LatestAnswers::update() {
    question_ = listHashes(from_.workbench.document().settings());
    const auto rule = from_.review.rule();
    const TimeWeights& weights = from_.weights.table();
    table_.setAnswers(all(), {.baseline = baseline(),
                              .weights = weights.name,
                              .rule = rule ? rule->name : std::string(),
                              .ruleBaseline = from_.review.choice().from,
                              .hasWeights = !weights.intervals.empty()});
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
        answers = {impactOf(city), scoreOf(city), std::nullopt, measuredOf(city), sunOf(city)};
        if (const auto found = verdicts.find(name); found != verdicts.end()) answers.verdicts = found->second;
    }
    return all;
}

std::optional<ScenarioImpact> LatestAnswers::impactOf(const CityPointer& city) {
    const CityPointer before = cityOf(baseline());
    const auto* found = find(
        [&](const Known& one) { return one.figures.impact && one.before == before && one.city == city; });
    if (!found) return std::nullopt;
    return ScenarioImpact{baseline(), *found->impact};
}

std::optional<ScenarioScore> LatestAnswers::scoreOf(const CityPointer& city) const {
    const TimeWeights& weights = from_.weights.table();
    const auto* found = find([&](const Known& one) {
        return one.city == city && one.figures.weights && one.figures.weights->intervals == weights.intervals;
    });
    if (!found) return std::nullopt;
    return ScenarioScore{weights.name, found->score, found->scoreMonths, found->scoreErrors,
                         found->scoreWithTrees};
}

std::optional<ShadowStatistics> LatestAnswers::measuredOf(const CityPointer& city) const {
    const auto* found = find([&](const Known& one) { return one.city == city && one.figures.measured; });
    return found ? found->measured : std::nullopt;
}

// Null: no places were measured.
const SavedFigures* LatestAnswers::latestSun() const {
    const auto found = std::ranges::find_if(known_.rbegin(), known_.rend(),
                                            [](const Known& one) { return one.figures.sun.has_value(); });
    return found == known_.rend() ? nullptr : &found->figures;
}

// Only scenarios whose places were measured alike can be compared: as those of the latest answer.
std::optional<ScenarioSun> LatestAnswers::sunOf(const CityPointer& city) const {
    const SavedFigures* latest = latestSun();
    const auto found = std::ranges::find_if(known_.rbegin(), known_.rend(), [&](const Known& one) {
        return one.city == city && one.figures.sun && one.figures.question == latest->question &&
               one.figures.sun->enoughHours == latest->sun->enoughHours;
    });
    return found == known_.rend() ? std::nullopt : found->figures.sun;
}

std::map<std::string, ScenarioVerdicts> LatestAnswers::verdicts() {
    return from_.windows.applies() ? countEach(from_.windows.latest()) : countEach(from_.review.latest());
}

// The workbench has a comparison or score only while the cities are those that it measured.
void LatestAnswers::adoptAnswer() {
    if (const auto comparison = from_.workbench.answerAs<ImpactAnswer>())
        add({cityOf(comparison->to),
             cityOf(comparison->from),
             {.question = hashQuestion(comparison->settings.study),
              .impact =
                  computeFigures(comparison->study.total, comparison->settings.thresholdsMin.front())}});
    if (const auto score = from_.workbench.answerAs<ScoreAnswer>())
        add({cityOf(score->scenario),
             nullptr,
             {.question = hashQuestion(score->settings),
              .weights = score->weights,
              .score = score->score,
              .scoreMonths = score->score.months,
              .scoreErrors = score->score.errors,
              .scoreWithTrees = withoutMaps(score->score.withTrees)}});
    adoptSun();
    update();
}

// Of each city that the answer is about, unless one of them has changed since.
void LatestAnswers::adoptSun() {
    const auto sun = from_.workbench.answerAs<SunOfCities>();
    const auto measured = from_.workbench.measuredShown();
    if (!sun || !measured || from_.workbench.isOutdated(*measured)) return;
    const auto adopt = [&](const SunByPlace& one) {
        const CityPointer city = cityOf(one.name.empty() ? from_.workbench.session().scenario() : one.name);
        Known known{
            city, nullptr, {.question = hashQuestion(one.settings.study), .sun = makeScenarioSun(one)}};
        std::erase_if(known_, [&](const Known& old) {
            return old.figures.sun && old.city == city && old.figures.question == known.figures.question;
        });
        add(std::move(known));
    };
    adopt(sun->baseline);
    for (const ComparedSun& compared : sun->compared) adopt(compared.sun);
}

std::vector<LatestAnswers::CityPointer> LatestAnswers::cities() {
    std::vector<CityPointer> cities;
    for (const std::string& name : listNames(from_.workbench.session().project().scenarios))
        if (CityPointer city = cityOf(name)) cities.push_back(std::move(city));
    return cities;
}

std::string LatestAnswers::hashOf(const CityPointer& city) {
    std::string& hash = hashes_[city];
    if (hash.empty()) hash = hashCity(*city);
    return hash;
}

// Figures of the studies at hand.
std::vector<LatestAnswers::Known> LatestAnswers::ofStudies() {
    std::vector<Known> known;
    for (const auto& [name, study] : from_.workbench.studies())
        known.push_back({cityOf(name),
                         nullptr,
                         {.question = hashQuestion(study->settings), .measured = study->statistics}});
    return known;
}

std::string LatestAnswers::figuresInView() const {
    const auto& view = from_.workbench.session().project().view;
    const auto text = view.find(viewFiguresKey);
    return text == view.end() ? std::string() : text->second;
}

// Of the cities of scenarios as they are now; the others cannot come back in another session. The newest of
// each kind.
std::string LatestAnswers::figuresToSave() {
    if (hashing_.busy()) return figuresInView();
    std::vector<Known> all = known_;
    for (Known& one : ofStudies()) all.push_back(std::move(one));
    const std::vector<CityPointer> now = cities();
    const auto isNow = [&](const CityPointer& city) { return std::ranges::find(now, city) != now.end(); };
    std::erase_if(hashes_, [&](const auto& one) { return !isNow(one.first); });
    std::vector<ViewFigures> saved;
    for (auto one = all.rbegin(); one != all.rend(); ++one) {
        if (one->figures.question.empty() || !isNow(one->city) || (one->before && !isNow(one->before)))
            continue;
        ViewFigures next{hashOf(one->city), one->before ? hashOf(one->before) : std::string(), one->figures};
        if (std::ranges::none_of(saved, [&](const ViewFigures& newer) { return replaces(newer, next); }))
            saved.push_back(std::move(next));
    }
    std::ranges::reverse(saved);
    return saved.empty() ? std::string() : formatText(saved);
}

void LatestAnswers::reviewAll() { from_.windows.applies() ? from_.windows.runAll() : from_.review.runAll(); }

}  // namespace noonmark
