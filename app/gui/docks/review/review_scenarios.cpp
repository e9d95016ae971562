#include <algorithm>

#include "app/gui/docks/review/review_session.h"
#include "app/gui/session/workbench.h"
#include "scenarios/scenario.h"

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

// As ReviewSession::findReach() does for the scenario that is displayed.
Result<void> keepReach(const ReviewChoice& choice, Asked& asked, Progress& progress,
                       const std::stop_token& stop) {
    ReviewQuestion question = *asked.review;
    if (!isScreened(choice, question) || !canScreen(question)) return {};
    const auto found = findPlacesInReach(question, progress, stop);
    if (!found) return tl::make_unexpected(found.error());
    if (const auto kept = keepReach(choice, question, *found); !kept) return kept;
    asked.review = std::make_shared<const ReviewQuestion>(std::move(question));
    return {};
}

}  // namespace

Answers ReviewSession::latest() {
    const auto rule = this->rule();
    if (!rule) return {};
    auto places = chosenPlaces(*rule);
    const bool inReach = places && screensPlaces(choice_.reviewed, places->places.size());
    return findLatest(*rule, std::move(places), inReach);
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

// Where another scenario is displayed, its own answer is shown instead of the last one, whatever places that
// was about.
void ReviewSession::recall() {
    const auto rule = this->rule();
    if (!rule) return;
    const auto known =
        findLatest(*rule, moveLines(*rule, workbench_.session().project(), candidates()), true);
    if (const auto own = known.find(scenarioName()); own != known.end()) answer_ = own->second;
}

void ReviewSession::runAll() {
    std::vector<std::string> lacking = comparedScenarios();
    std::erase_if(lacking, [known = latest()](const std::string& name) { return known.contains(name); });
    auto asked = askAbout<Asked>(lacking, [this](const std::string& name) {
        return questionOf(name).map([this](ReviewQuestion one) { return makeAsked(std::move(one)); });
    });
    if (asked.questions.empty() && !asked.refused.empty()) return reportAll(asked.refused, asked.count());
    using Shared = std::shared_ptr<const Answer>;
    using Made = std::vector<Result<Shared>>;
    runningAll_.start<Made>(
        tr("All reviews"),
        [asked, choice = choice_](Progress& progress, const std::stop_token& stop) -> Result<Made> {
            const auto compute = [&](Asked one, Progress& share, const std::stop_token& stopped) {
                return keepReach(choice, one, share, stopped).and_then([&] {
                    return reviewQuestion().compute(one, share, stopped);
                });
            };
            return computeEach<Shared>(asked.questions, compute, progress, stop);
        },
        [this, asked](Result<Made> answers) {
            if (!answers) return report(answers.error());
            const ScenarioErrors errors = adoptReviews(*std::move(answers), asked, cached_, workbench_);
            recall();
            Q_EMIT answered();
            reportAll(errors, asked.count());
        });
}

void ReviewSession::reportAll(const ScenarioErrors& errors, std::size_t asked) {
    for (const auto& [scenario, error] : errors) Q_EMIT scenarioFailed(scenario, error);
    if (!errors.empty()) report(sumUp(errors, asked));
}

}  // namespace noonmark
