#include "app/window/point/point_inspector.h"

#include "app/report/skyline/skyline_svg.h"
#include "app/window/frame/workbench.h"
#include "app/window/point/picked_point.h"
#include "app/window/time/time_strip.h"
#include "app/window/view/view_panel.h"
#include "core/study/text/point_text.h"

namespace noonmark {

namespace {

/// What a job needs, independent of the window.
struct InspectedCities {
    std::shared_ptr<const City> baseline;
    std::shared_ptr<const City> scenario;  ///< null: there is nothing to compare with
};

// The existing city, unless another baseline is chosen.
InspectedCities citiesToInspect(ProjectSession& session) {
    const std::string baseline = session.baseline().empty() ? existingCity : session.baseline();
    if (baseline == session.scenario()) return {session.city(), nullptr};
    const auto before = session.cityOf(baseline);
    if (!before || *before == session.city()) return {session.city(), nullptr};
    return {*before, session.city()};
}

Result<PointStudy> measure(InspectedCities& cities, const PointQuestion& question,
                           const std::stop_token& stop) {
    auto study = runPointStudy(*cities.baseline, cities.scenario.get(), question, stop);
    if (study || !cities.scenario || stop.stop_requested()) return study;
    // On what the scenario builds there is nothing to compare with.
    cities = {cities.scenario, nullptr};
    return runPointStudy(*cities.baseline, nullptr, question, stop);
}

Result<PointAnswer> answerOf(InspectedCities cities, const PointQuestion& question,
                             const std::stop_token& stop) {
    const auto zone = Zone::named(question.zone);
    if (!zone) return tl::make_unexpected(zone.error());
    auto study = measure(cities, question, stop);
    if (!study) return tl::make_unexpected(study.error());
    const City& city = *cities.baseline;
    PointAnswer answer{*std::move(study), {}, {}};
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
    connect(&panel_.time(), &TimeStrip::lookChanged, this, [this](const TimeLook& look) {
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

void PointInspector::mark() {
    panel_.view().overlay().showPin(visible_ && pick_ ? std::optional(pick_->position) : std::nullopt);
}

void PointInspector::follow() {
    outdated_ = true;
    if (visible_) ask();
}

void PointInspector::forget() {
    pick_.reset();
    mark();
    slot_.drop();
    answer_.reset();
    Q_EMIT changed();
}

void PointInspector::ask() {
    outdated_ = false;
    if (!pick_ || !workbench_.city()) return;
    const InspectedCities cities = citiesToInspect(workbench_.session());
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
