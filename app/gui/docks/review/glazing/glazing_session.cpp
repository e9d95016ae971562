#include "app/gui/docks/review/glazing/glazing_session.h"

#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/session/study/run_estimate.h"
#include "app/gui/session/workbench.h"
#include "app/input/load_project.h"
#include "core/city/city.h"
#include "core/receivers/made_names.h"

namespace noonmark {

namespace {

using Shared = std::shared_ptr<const Answer>;

QString describeForecast(const GlazingForecast& forecast) {
    return QObject::tr("%1 window(s): %2", "", pluralNumber(forecast.windows))
        .arg(formatCount(forecast.windows), describeAbout(forecast.seconds));
}

}  // namespace

GlazingSession::GlazingSession(Workbench& workbench, ReviewSession& review, QObject* parent)
    : QObject(parent), workbench_(workbench), review_(review) {
    connect(&workbench_, &Workbench::projectOpened, this, [this] {
        for (JobSlot* slot : {&running_, &runningAll_, &estimating_}) slot->drop();
        cached_.clear();
        asked_.reset();
        answer_.reset();
        Q_EMIT answered();
    });
    connect(&workbench_, &Workbench::answered, this, &GlazingSession::adoptShown);
}

void GlazingSession::takeOver(const GlazingSession& before) {
    answer_ = before.answer_;
    cached_ = before.cached_;
    Q_EMIT answered();
}

// One that was chosen in the list of answers.
void GlazingSession::adoptShown() {
    const auto shown = workbench_.answerAs<GlazingAnswer>();
    if (!shown || shown == answer_) return;
    answer_ = shown;
    cached_.add(shown);
    Q_EMIT answered();
}

Asked GlazingSession::makeAsked(GlazingQuestion question) const {
    return {.glazing = std::make_shared<const GlazingQuestion>(std::move(question)),
            .reviewSource = std::make_shared<const ReviewSource>(review_.source())};
}

bool GlazingSession::applies() const {
    const auto rule = review_.rule();
    return rule && rule->receivers.surface == RuleSurface::windows;
}

Result<GlazingQuestion> GlazingSession::question() { return questionOf(review_.comparedCities()); }

Result<GlazingQuestion> GlazingSession::questionOf(const Result<ReviewedCities>& cities) {
    if (!workbench_.city()) return tl::make_unexpected(noCityError());
    auto rule = review_.rule();
    if (!rule) return tl::make_unexpected(rule.error());
    const ReviewChoice& choice = review_.choice();
    if (choice.windows.places == ElementPlaces::windows && choice.windows.windows.empty())
        return failure("No file of windows is chosen", {},
                       "Choose a file of points or polygons with heights, or take the facades");
    if (!cities) return tl::make_unexpected(cities.error());
    if (cities->before == cities->after)
        return tl::make_unexpected(
            proposesNothing("A review of windows compares two scenarios, and both are " + cities->to));
    auto windows = findElementParts(choice.windows, workbench_.session().project(), *cities->after);
    if (!windows) return tl::make_unexpected(windows.error());
    const StudySettings& study = workbench_.document().settings();
    Region region = makeRegionFromLocalBox(bounds(*cities->after));
    region.name = madeNames::wholeCity;
    return GlazingQuestion{*cities,
                           *std::move(rule),
                           {*std::move(windows), std::move(region), study.period.zone,
                            int(study.period.start.year()), std::nullopt},
                           {{"--region", {"city"}}}};
}

void GlazingSession::run() {
    const auto question = this->question();
    if (!question) return report(question.error());
    running_.start<Shared>(
        tr("Review"),
        [asked = makeAsked(*question)](Progress& progress, const std::stop_token& stop) {
            return glazingQuestion().compute(asked, progress, stop);
        },
        [this](Result<Shared> answer) {
            if (!answer) return report(answer.error());
            answer_ = contentOf<GlazingAnswer>(*answer);
            cached_.add(answer_);
            workbench_.adopt({answer_->question.after, answer_->question.before, *answer}, {});
            Q_EMIT answered();
        });
}

std::map<std::string, std::shared_ptr<const GlazingAnswer>> GlazingSession::latest() {
    std::map<std::string, std::shared_ptr<const GlazingAnswer>> latest;
    if (cached_.empty() || !applies()) return latest;
    for (const std::string& name : review_.comparedScenarios()) {
        const auto now = questionOf(review_.comparedCities(name));
        if (!now) continue;
        if (auto answer = cached_.find([&](const GlazingAnswer& one) { return isSame(*now, one.question); }))
            latest[name] = std::move(answer);
    }
    return latest;
}

void GlazingSession::runAll() {
    std::vector<std::string> lacking = review_.comparedScenarios();
    std::erase_if(lacking, [known = latest()](const std::string& name) { return known.contains(name); });
    auto asked = askAbout<Asked>(lacking, [this](const std::string& name) {
        return questionOf(review_.comparedCities(name)).map([this](GlazingQuestion one) {
            return makeAsked(std::move(one));
        });
    });
    if (asked.questions.empty() && !asked.refused.empty()) return reportAll(asked.refused, asked.count());
    using Made = std::vector<Result<Shared>>;
    runningAll_.start<Made>(
        tr("All reviews"),
        [asked](Progress& progress, const std::stop_token& stop) -> Result<Made> {
            return computeEach<Shared>(asked.questions, glazingQuestion().compute, progress, stop);
        },
        [this, asked](Result<Made> answers) {
            if (!answers) return report(answers.error());
            const ScenarioErrors errors = adoptReviews(*std::move(answers), asked, cached_, workbench_);
            Q_EMIT answered();
            reportAll(errors, asked.count());
        });
}

void GlazingSession::reportAll(const ScenarioErrors& errors, std::size_t asked) {
    for (const auto& [scenario, error] : errors) Q_EMIT scenarioFailed(scenario, error);
    if (!errors.empty()) report(sumUp(errors, asked));
}

void GlazingSession::estimate() {
    const auto question = this->question();
    if (!question) {
        estimating_.drop();
        asked_.reset();
        return Q_EMIT estimated({});
    }
    if (asked_ && isSame(*asked_, *question)) {
        if (!estimating_.busy()) Q_EMIT estimated(estimate_);
        return;
    }
    asked_ = *question;
    estimating_.start<GlazingForecast>(
        tr("Estimating"),
        [question = *question](Progress& progress, const std::stop_token& stop) {
            return forecastGlazingReview(question.rule, *question.before, *question.after, question.settings,
                                         progress, stop);
        },
        [this](const Result<GlazingForecast>& forecast) {
            estimate_ = forecast ? describeForecast(*forecast) : QString();
            Q_EMIT estimated(estimate_);
        });
}

QString GlazingSession::whyOutdated() {
    if (!answer_) return {};
    const auto now = question();
    if (!now) return tr("Not up to date. %1").arg(describeError(now.error()));
    if (isSame(*now, answer_->question)) return {};
    return tr("Not up to date: buildings, windows or the rule have changed. Run again.");
}

Result<std::shared_ptr<const GlazingAnswer>> GlazingSession::finished() const {
    if (!answer_) return tl::make_unexpected(noReviewError());
    return answer_;
}

Result<void> GlazingSession::showFinished() {
    return finished().and_then([this](const std::shared_ptr<const GlazingAnswer>& answer) {
        return showReview(workbench_, answer, review_.source());
    });
}

void GlazingSession::report(const Error& error) {
    if (!isCancelled(error)) Q_EMIT failed(error);
}

}  // namespace noonmark
