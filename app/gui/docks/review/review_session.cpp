#include "app/gui/docks/review/review_session.h"

#include <QStandardPaths>
#include <algorithm>
#include <ranges>
#include <utility>

#include "app/gui/base/widgets/error_text.h"
#include "app/gui/docks/review/review_cache.h"
#include "app/gui/session/workbench.h"
#include "core/receivers/place_names.h"
#include "core/sun/zone_country.h"

namespace noonmark {

namespace {

// The shipped rules and those of the user's folder; without it the shipped ones.
RuleLibrary loadLibrary() {
    const QString folder = QStandardPaths::locate(QStandardPaths::AppDataLocation, QStringLiteral("rules"),
                                                  QStandardPaths::LocateDirectory);
    if (!folder.isEmpty())
        if (auto all = RuleLibrary::load({folder.toStdString()})) return *std::move(all);
    return RuleLibrary::load().value_or(RuleLibrary{});
}

Error sameScenarios(const std::string& scenario) {
    return proposesNothing("Baseline and scenario are the same: " + scenario);
}

}  // namespace

Error proposesNothing(std::string what) {
    return {std::move(what),
            {},
            QT_TRANSLATE_NOOP("Error", "Design a tower, or choose a scenario with a proposal")};
}

Error noReviewError() {
    return {QT_TRANSLATE_NOOP("Error", "There is no review to export"),
            {},
            QT_TRANSLATE_NOOP("Error", "Press Run review first")};
}

ReviewSession::ReviewSession(Workbench& workbench, QObject* parent) : QObject(parent), workbench_(workbench) {
    library_ = loadLibrary();
    ProjectSession& session = workbench_.session();
    connect(&session, &ProjectSession::changed, this, [this] {
        Q_EMIT changed();
        Q_EMIT answered();
    });
    connect(&session, &ProjectSession::renamed, this, &ReviewSession::rename);
    connect(&workbench_, &Workbench::cityShown, this, &ReviewSession::cityChanged);
    connect(&workbench_, &Workbench::answered, this, &ReviewSession::adoptShown);
    connect(&workbench_.document(), &StudyDocument::changed, this, &ReviewSession::answered);
}

void ReviewSession::restore(const std::string& text) {
    for (JobSlot* slot : {&running_, &runningAll_, &followed_, &estimating_}) slot->drop();
    answer_.reset();
    cached_.clear();
    live_.reset();
    proposed_.reset();
    reach_.reset();
    choice_ = parseReviewChoice(text);
    suggest();
    Q_EMIT changed();
    Q_EMIT answered();
}

void ReviewSession::takeOver(const ReviewSession& before) {
    answer_ = before.answer_;
    cached_ = before.cached_;
    reach_ = before.reach_;
    Q_EMIT changed();
    Q_EMIT answered();
}

// Where nobody has chosen a rule yet.
void ReviewSession::suggest() {
    if (choice_.rule.empty() && workbench_.city())
        choice_.rule =
            suggestRule(library_.rules(), countryOfZone(zone()), workbench_.city()->city().frame.origin());
}

const std::string& ReviewSession::zone() const { return workbench_.document().settings().period.zone; }

void ReviewSession::choose(const ReviewChoice& choice) {
    if (choice == choice_) return;
    choice_ = choice;
    Q_EMIT changed();
    Q_EMIT answered();
    follow();
}

void ReviewSession::rename(ProjectPart part, const std::string& from, const std::string& to) {
    if (part == ProjectPart::scenario)
        for (std::string* name : {&choice_.from, &choice_.to})
            if (*name == from) *name = to;
    if (part == ProjectPart::place || part == ProjectPart::lot)
        std::ranges::replace(choice_.places, from, to);
}

std::string ReviewSession::scenarioName() const {
    return choice_.to.empty() ? workbench_.session().scenario() : choice_.to;
}

std::vector<Place> ReviewSession::candidates() const {
    const auto rule = this->rule();
    const Project& project = workbench_.session().project();
    return rule ? placesUnder(*rule, project) : project.places;
}

Result<PlacesToReview> ReviewSession::chosenPlaces(const Rule& rule) const {
    std::vector<Place> places = candidates();
    if (places.empty() && rule.receivers.hasLines())
        return failure(QT_TRANSLATE_NOOP("Error", "The project has no lots, and this rule is about parcels"),
                       {}, QT_TRANSLATE_NOOP("Error", "Draw the lot of the proposal: Edit > Draw lot"));
    if (places.empty())
        return failure(
            QT_TRANSLATE_NOOP("Error", "The project has no places yet"), {},
            QT_TRANSLATE_NOOP("Error",
                              "Read them from a map or draw one: Study > Read places, Study > Draw place"));
    if (choice_.reviewed == ReviewedPlaces::chosen)
        std::erase_if(places, [this](const Place& place) {
            return std::ranges::find(choice_.places, place.name) == choice_.places.end();
        });
    if (places.empty())
        return failure(
            QT_TRANSLATE_NOOP("Error", "No place is chosen"), {},
            QT_TRANSLATE_NOOP(
                "Error",
                "Tick the places to review, or press In reach to find those that the shadow reaches"));
    return moveLines(rule, workbench_.session().project(), std::move(places));
}

Result<ReviewedCities> ReviewSession::comparedCities(const std::string& to) const {
    const auto before = workbench_.session().cityOf(choice_.from);
    if (!before) return tl::make_unexpected(before.error());
    const auto after = workbench_.session().cityOf(to);
    if (!after) return tl::make_unexpected(after.error());
    if (*before == *after && to != choice_.from) return tl::make_unexpected(sameScenarios(to));
    return ReviewedCities{choice_.from, to, *before, *after};
}

Result<ReviewQuestion> ReviewSession::question() { return questionOf(scenarioName()); }

Result<ReviewQuestion> ReviewSession::questionOf(const std::string& scenario) {
    if (!workbench_.city()) return tl::make_unexpected(noCityError());
    auto rule = this->rule();
    if (!rule) return tl::make_unexpected(rule.error());
    auto places = chosenPlaces(*rule);
    if (!places) return tl::make_unexpected(places.error());
    auto cities = comparedCities(scenario);
    if (!cities) return tl::make_unexpected(cities.error());
    const StudySettings& study = workbench_.document().settings();
    ReviewQuestion question{*std::move(cities),
                            *std::move(rule),
                            std::move(places->places),
                            {1, study.period.zone, int(study.period.start.year())},
                            std::move(places->moved)};
    if (choice_.reviewed != ReviewedPlaces::chosen) question.named = {"all"};
    if (reach_ && isScreened(choice_, question) && isSame(reach_->asked, question)) return reach_->kept;
    return question;
}

bool ReviewSession::needsScreening(const ReviewQuestion& question) const {
    return isScreened(choice_, question) && !(reach_ && isSame(reach_->asked, question));
}

bool ReviewSession::mustFindReach() {
    const auto now = question();
    return now && needsScreening(*now) && canScreen(*now);
}

const ReviewSession::Reach* ReviewSession::reach() {
    const auto now = question();
    const bool isKept = now && now->inReach && reach_ && reach_->kept && isSame(*now, *reach_->kept);
    return isKept ? &*reach_ : nullptr;
}

// Of many places those in reach are reviewed, found first. `next` follows when they are known.
void ReviewSession::findReach(JobSlot& slot, const ReviewQuestion& question, std::function<void()> next) {
    slot.start<Reach>(
        tr("Finding places in reach"),
        [question, choice = choice_](Progress& progress, const std::stop_token& stop) -> Result<Reach> {
            Reach reach{question, question, {}};
            if (!canScreen(question)) return reach;
            auto found = findPlacesInReach(question, progress, stop);
            if (!found && isCancelled(found.error())) return tl::make_unexpected(found.error());
            const auto kept = found ? keepReach(choice, *reach.kept, *found)
                                    : Result<void>(tl::make_unexpected(found.error()));
            if (!kept) reach.kept = tl::make_unexpected(kept.error());
            if (found) reach.reasons = std::move(found->reasons);
            return reach;
        },
        [this, next = std::move(next)](Result<Reach> reach) {
            if (!reach) return report(reach.error());
            reach_ = *std::move(reach);
            Q_EMIT changed();
            Q_EMIT answered();
            next();
        });
}

Asked ReviewSession::makeAsked(ReviewQuestion question) const {
    return {.review = std::make_shared<const ReviewQuestion>(std::move(question)),
            .reviewSource = std::make_shared<const ReviewSource>(source())};
}

std::shared_ptr<const MeasuredAnswer> ReviewSession::measuredBefore() {
    const auto now = question();
    if (!now) return nullptr;
    const MeasuredAnswers measured = workbench_.measured();
    const bool orSome = needsScreening(*now);  // which of them was found then
    for (const auto& one : measured | std::views::reverse)
        if (!one->known().answer && isReviewOf(*one->toSave(), *now, orSome)) return one;
    return nullptr;
}

bool ReviewSession::repeatMeasured() {
    const auto before = measuredBefore();
    if (!before || secondsOfReview(*before->toSave()) > quickSeconds) return false;
    const bool wasShown = before->name() == workbench_.openedView().shown;
    ask({.isWork = false, .isShown = wasShown});
    return wasShown;
}

void ReviewSession::ask(const Workbench::Adopting& how) {
    const auto question = this->question();
    if (!question) return report(question.error());
    if (needsScreening(*question)) {
        estimating_.drop();  // which may be finding them, too
        return findReach(running_, *question, [this, how] { ask(how); });
    }
    running_.start<std::shared_ptr<const Answer>>(
        tr("Review"),
        [asked = makeAsked(*question)](Progress& progress, const std::stop_token& stop) {
            return reviewQuestion().compute(asked, progress, stop);
        },
        [this, how](Result<std::shared_ptr<const Answer>> answer) {
            if (!answer) return report(answer.error());
            answer_ = contentOf<ReviewAnswer>(*answer);
            cached_.add(answer_);
            if (!proposed_) live_.reset();
            workbench_.adopt({answer_->question.after, answer_->question.before, *answer}, how);
            Q_EMIT answered();
        });
}

// One that was chosen in the list of answers.
void ReviewSession::adoptShown() {
    const auto shown = workbench_.answerAs<ReviewAnswer>();
    if (!shown || shown == answer_) return;
    answer_ = shown;
    cached_.add(shown);
    Q_EMIT answered();
}

void ReviewSession::estimate() {
    const auto question = this->question();
    if (!question) {
        estimating_.drop();
        return Q_EMIT estimated({});
    }
    if (needsScreening(*question)) return findReach(estimating_, *question, [] {});
    estimating_.start<double>(
        tr("Estimating"),
        [question = *question](Progress&, const std::stop_token& stop) {
            return estimateReviewSeconds(question.rule, *question.before, *question.after, question.places,
                                         question.settings, stop);
        },
        [this](Result<double> seconds) { Q_EMIT estimated(seconds ? describeAbout(*seconds) : QString()); });
}

void ReviewSession::screen() {
    ReviewChoice choice = choice_;
    choice.reviewed = ReviewedPlaces::inReach;
    choice.places.clear();
    choose(choice);
    const auto question = this->question();
    if (!question) return report(question.error());
    if (question->before == question->after) return report(sameScenarios(question->to));
    if (needsScreening(*question)) findReach(running_, *question, [] {});
}

ReviewSource ReviewSession::source() const {
    const ProjectSession& session = workbench_.session();
    return {session.project(), session.file(), {}, library_.warnings(), workbench_.exportRules()};
}

Result<std::shared_ptr<const ReviewAnswer>> ReviewSession::finished() const {
    if (live_)
        return failure(QT_TRANSLATE_NOOP("Error", "The building is still being designed"), {},
                       QT_TRANSLATE_NOOP("Error", "Build it, then run the review"));
    if (!answer_) return tl::make_unexpected(noReviewError());
    return answer_;
}

Result<void> ReviewSession::showFinished() {
    return finished().and_then([this](const std::shared_ptr<const ReviewAnswer>& answer) {
        return showReview(workbench_, answer, source());
    });
}

void ReviewSession::setFollowing(bool following) {
    following_ = following;
    if (following) follow();
}

void ReviewSession::shape(std::shared_ptr<const City> proposed) {
    proposed_ = std::move(proposed);
    if (proposed_) return follow();
    followed_.drop();
    newerShape_ = false;
    if (std::exchange(live_, nullptr)) Q_EMIT answered();
}

// Those that the latest proposal reaches, where only places in reach are reviewed. A shape may reach others;
// they are found when it is built.
Result<PlacesToReview> ReviewSession::livePlaces(const Rule& rule) const {
    auto places = chosenPlaces(rule);
    const bool isKnown = places && reach_ && reach_->kept && isSameRule(reach_->asked.rule, rule) &&
                         screensPlaces(choice_.reviewed, places->places.size());
    if (!isKnown) return places;
    std::erase_if(places->places, [this](const Place& place) {
        return std::ranges::find(reach_->kept->places, place) == reach_->kept->places.end();
    });
    return places;
}

// From a run of the same rule on as many places.
bool ReviewSession::isKnownAsQuick() const {
    if (!answer_ || answer_->seconds > quickSeconds || answer_->question.rule.key != choice_.rule)
        return false;
    const auto rule = this->rule();
    const auto places = rule ? livePlaces(*rule) : tl::make_unexpected(rule.error());
    return places && places->places.size() <= answer_->question.places.size();
}

void ReviewSession::dropLive() {
    live_.reset();
    Q_EMIT answered();
}

// One shape is computed at a time; when it is ready, the newest that arrived meanwhile is next.
void ReviewSession::follow() {
    const bool shaping = proposed_ && (following_ || isKnownAsQuick());
    if (!shaping || (!choice_.to.empty() && choice_.to != workbench_.session().scenario())) return;
    const auto rule = this->rule();
    const bool ofPlaces = rule && rule->receivers.surface != RuleSurface::windows;
    auto places = ofPlaces && hasFewDays(*rule) ? livePlaces(*rule)
                                                : Result<PlacesToReview>(tl::make_unexpected(Error{}));
    const auto before = workbench_.session().cityOf(choice_.from);
    if (!places || !before) return dropLive();
    newerShape_ = followed_.busy();
    if (newerShape_) return;
    const StudySettings& study = workbench_.document().settings();
    ReviewQuestion question{
        {choice_.from, tr("the building being designed").toStdString(), *before, proposed_},
        *rule,
        std::move(places->places),
        {1, study.period.zone, int(study.period.start.year())},
        std::move(places->moved)};
    question.settings.refinesSpots = false;  // as fast as a hand drags; their error includes the cell
    followed_.start<ReviewAnswer>(
        tr("Live review"),
        [question = std::move(question)](Progress& progress, std::stop_token stop) {
            return computeReview(question, progress, std::move(stop));
        },
        [this](Result<ReviewAnswer> answer) { takeLive(std::move(answer)); });
    if (!live_) Q_EMIT answered();
}

void ReviewSession::takeLive(Result<ReviewAnswer> answer) {
    if (!answer && !isCancelled(answer.error())) live_.reset();
    if (answer && proposed_) live_ = std::make_shared<const ReviewAnswer>(*std::move(answer));
    Q_EMIT answered();
    if (std::exchange(newerShape_, false)) follow();
}

// A review that was quick is computed again, as studies are.
void ReviewSession::cityChanged() {
    suggest();
    recall();
    Q_EMIT answered();
    if (!answer_ || !following_ || proposed_ || answer_->seconds > quickSeconds) return;
    const auto now = question();
    if (!now || !hasFewDays(now->rule) || isAnswered(*now)) return;
    // Nobody asked for it: it takes the place of an earlier review only.
    ask({.isWork = false, .isShown = !workbench_.answer() || workbench_.answerAs<ReviewAnswer>()});
}

// Until the places in reach are known, by the answer's own.
bool ReviewSession::isAnswered(const ReviewQuestion& now) {
    const ReviewQuestion& then = answer_->question;
    if (isSame(now, then)) return true;
    if (!needsScreening(now) || !then.inReach) return false;
    ReviewQuestion same = now;
    same.places = then.places;
    return isSame(same, then);
}

QString ReviewSession::whyOutdated() {
    if (live_) return {};
    if (proposed_ && answer_) return tr("Not up to date: a building is being designed. Build it, then run.");
    if (!answer_) return {};
    const auto now = question();
    if (!now) return tr("Not up to date. %1").arg(describeError(now.error()));
    if (isAnswered(*now)) return {};
    const bool buildings = now->before != answer_->question.before || now->after != answer_->question.after;
    return buildings ? tr("Not up to date: buildings or scenarios have changed. Run again.")
                     : tr("Not up to date: rule, places, time zone or year have changed. Run again.");
}

void ReviewSession::report(const Error& error) {
    if (!isCancelled(error)) Q_EMIT failed(error);
}

}  // namespace noonmark
