#include "app/gui/docks/point/point_inspector.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <utility>

#include "app/gui/session/workbench.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/gui/view/time/time_strip.h"
#include "app/report/skyline/skyline_svg.h"
#include "core/city/city_position.h"
#include "core/study/text/point_text.h"

namespace noonmark {

namespace {

constexpr double uprightBelow = 0.5;  // of the normal's vertical component: steeper than 60 degrees
constexpr double offWallM = 0.02;     // so that rounding does not put the point inside the building

}  // namespace

PointQuestion questionAt(const City& city, const Pick& pick) {
    PointQuestion question;
    glm::dvec2 place(pick.position);
    if (pick.building) {
        const glm::dvec3 normal(pick.normal);
        if (std::abs(normal.z) < uprightBelow) {
            place += offWallM * glm::normalize(glm::dvec2(normal));
            const glm::dvec3 facing = glm::transpose(placeObserver(city, place).frameFromPlace) * normal;
            const double azimuthDeg = Radians{std::atan2(facing.x, facing.y)}.degrees().value;
            question.facingDeg = std::fmod(azimuthDeg + 360, 360);
        }
        question.heightM = std::max(0.0, pick.position.z - double(groundAt(city, place)));
    }
    question.at = city.frame.lonLatFromLocal(place);
    return question;
}

namespace {

/// What a job needs, independent of the window.
struct InspectedCities {
    std::shared_ptr<const City> baseline;
    std::shared_ptr<const City> scenario;  ///< null: there is nothing to compare with
    std::string from, to;                  ///< their names
    std::vector<PointScenario> cases;      ///< all of the project, if it has scenarios
};

bool hasScenario(const ProjectSession& session, const std::string& name) {
    return name == existingCity || std::ranges::find(session.project().scenarios, name, &Scenario::name) !=
                                       session.project().scenarios.end();
}

std::vector<PointScenario> casesOf(ProjectSession& session) {
    std::vector<PointScenario> cases;
    if (session.project().scenarios.empty()) return cases;
    cases.push_back({existingCity, session.project().city});
    for (const Scenario& scenario : session.project().scenarios)
        if (const auto city = session.cityOf(scenario.name)) cases.push_back({scenario.name, *city});
    return cases;
}

// The existing city, unless another baseline is chosen.
InspectedCities citiesToInspect(ProjectSession& session, const PointComparison& chosen) {
    const std::string baseline = session.baseline().empty() ? existingCity : session.baseline();
    const std::string from = hasScenario(session, chosen.from) ? chosen.from : baseline;
    const std::string to = hasScenario(session, chosen.to) ? chosen.to : session.scenario();
    const auto before = session.cityOf(from), after = session.cityOf(to);
    if (!before || !after || *before == *after || from == to)
        return {after ? *after : session.city(), nullptr, {}, to, casesOf(session)};
    return {*before, *after, from, to, casesOf(session)};
}

Result<PointStudy> measure(InspectedCities& cities, const PointQuestion& question,
                           const std::stop_token& stop) {
    auto study = runPointStudy(*cities.baseline, cities.scenario.get(), question, stop);
    if (study || !cities.scenario || stop.stop_requested()) return study;
    // On what the scenario builds there is nothing to compare with.
    cities.baseline = std::exchange(cities.scenario, nullptr);
    cities.from.clear();
    return runPointStudy(*cities.baseline, nullptr, question, stop);
}

Result<PointAnswer> answerOf(InspectedCities cities, const PointQuestion& question,
                             const std::stop_token& stop) {
    const auto zone = Zone::named(question.zone);
    if (!zone) return tl::make_unexpected(zone.error());
    auto study = measure(cities, question, stop);
    if (!study) return tl::make_unexpected(study.error());
    const City& city = *cities.baseline;
    PointAnswer answer{*std::move(study), {}, {}, cities.from, cities.to};
    if (const auto figures = measurePointCases(cities.cases, question, stop)) answer.cases = *figures;
    answer.sentence = QString::fromStdString(describe(answer.study, city));
    answer.drawing = QByteArray::fromStdString(skylineSvg(answer.study, city, *zone));
    return answer;
}

}  // namespace

PointInspector::PointInspector(Workbench& workbench, ViewPanel& panel)
    : workbench_(workbench), panel_(panel) {
    connect(&workbench_, &Workbench::cityShown, this, &PointInspector::follow);
    connect(&workbench_, &Workbench::projectOpened, this, &PointInspector::forget);
    connect(&workbench_.session(), &ProjectSession::baselineChanged, this, &PointInspector::follow);
    connect(&workbench_.session(), &ProjectSession::changed, this, &PointInspector::scenariosChanged);
    connect(&panel_.time(), &TimeStrip::lookChanged, this, [this](const ShownTime& look) {
        if (look.date != day_) follow();
    });
}

void PointInspector::inspect(const Pick& pick) {
    pick_ = pick;
    mark();
    ask();
    Q_EMIT asked();
}

void PointInspector::setVisible(bool visible) {
    visible_ = visible;
    mark();
    if (visible_ && outdated_) ask();
}

void PointInspector::compare(const PointComparison& chosen) {
    if (chosen == chosen_) return;
    chosen_ = chosen;
    follow();
    Q_EMIT scenariosChanged();
}

QStringList PointInspector::scenarios() const {
    QStringList names{QString::fromLatin1(existingCity)};
    for (const Scenario& scenario : workbench_.session().project().scenarios)
        names << QString::fromStdString(scenario.name);
    return names;
}

void PointInspector::mark() {
    panel_.view().overlay().showPin(visible_ && pick_ ? std::optional(pick_->position) : std::nullopt);
    Q_EMIT marked();
}

void PointInspector::follow() {
    outdated_ = true;
    if (visible_) ask();
}

void PointInspector::forget() {
    pick_.reset();
    chosen_ = {};
    mark();
    slot_.drop();
    answer_.reset();
    Q_EMIT changed();
}

void PointInspector::ask() {
    outdated_ = false;
    if (!pick_ || !workbench_.city()) return;
    const InspectedCities cities = citiesToInspect(workbench_.session(), chosen_);
    PointQuestion question = questionAt(*cities.baseline, *pick_);
    question.day = day_ = panel_.time().look().date;
    question.zone = workbench_.document().settings().period.zone;
    slot_.start<PointAnswer>(
        tr("Point"),
        [cities, question](Progress&, const std::stop_token& stop) {
            return answerOf(cities, question, stop);
        },
        [this](Result<PointAnswer> answer) { take(std::move(answer)); });
}

void PointInspector::take(Result<PointAnswer> answer) {
    if (!answer && answer.error().kind == ErrorKind::cancelled) return;
    const std::optional<Error> error = answer ? std::nullopt : std::optional(answer.error());
    answer_ = answer ? std::make_shared<const PointAnswer>(*std::move(answer)) : nullptr;
    Q_EMIT changed();
    if (error) Q_EMIT failed(*error);
}

}  // namespace noonmark
