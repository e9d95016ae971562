#include <algorithm>

#include "app/gui/docks/review/review_session.h"
#include "app/gui/session/workbench.h"
#include "scenarios/scenario_list.h"

// The reviews of all scenarios.
namespace noonmark {

namespace {

using Answers = std::map<std::string, std::shared_ptr<const ReviewAnswer>>;

// Whether an answer is to the question `now`, of all of its places or, with `orSome`, of some.
bool holds(const ReviewAnswer& answer, const ReviewQuestion& now, bool orSome) {
    const ReviewQuestion& then = answer.question;
    if (!isOfSameCase(then, now)) return false;
    if (then.settings.zone != now.settings.zone || then.settings.year != now.settings.year) return false;
    if (then.places == now.places) return true;
    return orSome && std::ranges::all_of(then.places, [&](const Place& place) {
               return std::ranges::find(now.places, place) != now.places.end();
           });
}

}  // namespace

Answers ReviewSession::latest() {
    const auto rule = this->rule();
    return rule ? findLatest(*rule, chosenPlaces(*rule), false) : Answers();
}

Answers ReviewSession::findLatest(const Rule& rule, Result<PlacesToReview> places, bool orSome) {
    Answers latest;
    ProjectSession& session = workbench_.session();
    const auto before = session.cityOf(choice_.from);
    if (cached_.empty() || !before || !places) return latest;
    const Period& period = workbench_.document().settings().period;
    ReviewQuestion now{{choice_.from, {}, *before, {}},
                       rule,
                       std::move(places->places),
                       {1, period.zone, int(period.start.year())},
                       {}};
    for (const std::string& name : comparedScenarios()) {
        now.after = session.cityOf(name).value_or(nullptr);
        if (auto answer = cached_.find([&](const ReviewAnswer& one) { return holds(one, now, orSome); }))
            latest[name] = std::move(answer);
    }
    return latest;
}

std::vector<std::string> ReviewSession::comparedScenarios() {
    ProjectSession& session = workbench_.session();
    const auto before = session.cityOf(choice_.from).value_or(nullptr);
    std::vector<std::string> names = listNames(session.project().scenarios);
    std::erase_if(names, [&](const auto& name) { return session.cityOf(name).value_or(nullptr) == before; });
    return names;
}

// Where another scenario is displayed, its own answer is shown instead of the last one, of whichever places.
void ReviewSession::recall() {
    const auto rule = this->rule();
    if (!rule) return;
    const auto known =
        findLatest(*rule, moveLines(*rule, workbench_.session().project(), candidates()), true);
    if (const auto own = known.find(scenarioName()); own != known.end()) answer_ = own->second;
}

void ReviewSession::runAll() {
    const auto known = latest();
    std::vector<ReviewQuestion> questions;
    std::vector<std::string> names;
    ScenarioErrors refused;
    for (const std::string& name : comparedScenarios()) {
        if (known.contains(name)) continue;
        auto question = questionOf(name);
        if (!question) {
            refused.emplace_back(name, question.error());
            continue;
        }
        questions.push_back(*std::move(question));
        names.push_back(name);
    }
    if (questions.empty() && !refused.empty()) return tellAll(refused, refused.size());
    const std::size_t asked = names.size() + refused.size();
    using Made = std::vector<Result<ReviewAnswer>>;
    runningAll_.start<Made>(
        tr("All reviews"),
        [questions = std::move(questions)](Progress& progress, const std::stop_token& stop) -> Result<Made> {
            return computeEach<ReviewAnswer>(questions, computeReview, progress, stop);
        },
        [this, names, refused, asked](Result<Made> answers) {
            if (!answers) return tell(answers.error());
            ScenarioErrors errors =
                adoptEach(*std::move(answers), names,
                          [this](ReviewAnswer answer, std::size_t) { cached_.add(std::move(answer)); });
            errors.insert(errors.begin(), refused.begin(), refused.end());
            recall();
            Q_EMIT answered();
            tellAll(errors, asked);
        });
}

void ReviewSession::tellAll(const ScenarioErrors& errors, std::size_t asked) {
    for (const auto& [scenario, error] : errors) Q_EMIT scenarioFailed(scenario, error);
    if (!errors.empty()) tell(sumUp(errors, asked));
}

}  // namespace noonmark
